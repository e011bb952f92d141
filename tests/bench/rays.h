// glint-bench rays: rays a second on one thread, by kind of shape and number, against Embree's own
// sphere points and against the plain double loop. Same rays, same process, interleaved.
#pragma once

#include "tests/bench/command.h"

namespace glint::bench {

[[nodiscard]] Command raysCommand(CLI::App& root);

}  // namespace glint::bench
