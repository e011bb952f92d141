// glint-bench peers: Glint against Blender's Cycles and POV-Ray on the same scenes.
#pragma once

#include "tests/bench/command.h"

namespace glint::bench {

[[nodiscard]] Command peersCommand(CLI::App& root);

}  // namespace glint::bench
