// A Glint scene as POV-Ray's scene language, for the `classic` integrator: both are Whitted's
// algorithm.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/peers/peer_scene.h"

namespace glint::bench {

struct PovrayScene {
    std::string text;
    std::vector<std::string> notes;  ///< what POV-Ray shows otherwise or not at all
};
[[nodiscard]] PovrayScene povrayScene(const Scene& scene);

}  // namespace glint::bench
