// glint-bench scale: how time, node visits and memory grow with shapes and lights, and how threads
// share the work.
#pragma once

#include "tests/bench/command.h"

namespace glint::bench {

[[nodiscard]] Command scaleCommand(CLI::App& root);

}  // namespace glint::bench
