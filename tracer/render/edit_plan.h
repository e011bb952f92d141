// What an edit does to a picture that is being rendered: nothing, a new mix of its lights, new
// samples for the pixels that rest on some materials, or a start from nothing.
#pragma once

#include <cstdint>

#include "tracer/compile/render_scene.h"
#include "tracer/scene/light_groups.h"

namespace glint {

struct EditPlan {
    enum class Kind {
        Keep,     ///< the samples hold, mixed by `mix`
        Retrace,  ///< those that rest on `materials` do not; `mix` as above
        Restart
    };
    Kind kind = Kind::Restart;
    LightMix mix;
    std::uint64_t materials = 0;  ///< set of bits, see materialBit()
};

/// How samples of `traced` become a picture of `next`; `groups` are those that the samples' light
/// is sorted by. Names, locks, saved views, display, stop rules and what is hidden in both scenes
/// do not count. Looks only where the documents' storage differs.
[[nodiscard]] EditPlan planEdit(const Scene& traced, const Scene& next, const LightGroups& groups);

/// `next` with the lights of `traced`: the scene to trace so that samples of both sum to one
/// picture, to be mixed by the plan of Kind::Retrace.
[[nodiscard]] Scene withLightsOf(const Scene& traced, Scene next);

/// The two differ at most in values that samples record their use of: the same shapes are
/// dielectric, let shadow rays pass, and throw caustics by the same ways with the same chances.
/// Asked after compiling for Kind::Retrace; else a restart is needed.
[[nodiscard]] bool sameStructure(const RenderScene& before, const RenderScene& after);

/// The cameras see from the same place with the same lens, but for the angle or height of view,
/// which follow the window.
[[nodiscard]] bool sameViewpoint(const Camera& a, const Camera& b);

}  // namespace glint
