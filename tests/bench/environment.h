// glint-bench environment: how directions of an environment are drawn, the built way against an
// alias table.
#pragma once

#include "tests/bench/command.h"

namespace glint::bench {

[[nodiscard]] Command environmentCommand(CLI::App& root);

}  // namespace glint::bench
