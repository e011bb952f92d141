// glint-bench skip: what a scene does not hold costs it nothing.
#pragma once

#include "tests/bench/command.h"

namespace glint::bench {

[[nodiscard]] Command skipCommand(CLI::App& root);

}  // namespace glint::bench
