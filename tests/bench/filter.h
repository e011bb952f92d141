// glint-bench filter: what the preview filter gains and costs.
#pragma once

#include "tests/bench/command.h"

namespace glint::bench {

[[nodiscard]] Command filterCommand(CLI::App& root);

}  // namespace glint::bench
