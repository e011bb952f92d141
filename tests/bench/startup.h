// glint-bench startup: how long glint-render takes from its start to the end of a small picture,
// and the editor to its first.
#pragma once

#include "tests/bench/command.h"

namespace glint::bench {

[[nodiscard]] Command startupCommand(CLI::App& root);

}  // namespace glint::bench
