// glint-bench scenes: how fast scenes render and how soon they are clean.
#pragma once

#include "tests/bench/command.h"

namespace glint::bench {

[[nodiscard]] Command scenesCommand(CLI::App& root);

}  // namespace glint::bench
