// glint-bench choices: the ways that were not taken, measured against those that were.
#pragma once

#include "tests/bench/command.h"

namespace glint::bench {

[[nodiscard]] Command choicesCommand(CLI::App& root);

}  // namespace glint::bench
