// glint-bench error: time against error.
#pragma once

#include "tests/bench/command.h"

namespace glint::bench {

[[nodiscard]] Command errorCommand(CLI::App& root);

}  // namespace glint::bench
