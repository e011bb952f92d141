// glint-bench viewport: how soon an edit shows in the living render.
#pragma once

#include "tests/bench/command.h"

namespace glint::bench {

[[nodiscard]] Command viewportCommand(CLI::App& root);

}  // namespace glint::bench
