// glint-bench rays: rays a second on one thread, by kind of shape and number, against Embree's own
// sphere points and against the plain double loop. Same rays, same process, interleaved.
#pragma once

#include <string>

namespace glint::bench {

/// Prints a table and, if `jsonFile` is not empty, writes it there as JSON. Answers with the exit
/// code.
int runRays(const std::string& jsonFile);

}  // namespace glint::bench
