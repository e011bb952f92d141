// RenderScene: the compiled scene, immutable while it is traced. Positions are relative to
// `origin`, the centre of the finite scene bounds, so that a scene far from zero loses nothing.
// Made by compiler.h; traced by render/.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tracer/base/shared_list.h"
#include "tracer/compile/camera_model.h"
#include "tracer/compile/casters.h"
#include "tracer/compile/highlights.h"
#include "tracer/compile/light_buffer.h"
#include "tracer/compile/light_table.h"
#include "tracer/compile/shape_lists.h"
#include "tracer/materials/builder.h"

namespace glint {

/// What a scene holds; kernels are compiled for sets of these and skip the rest.
enum class Feature : std::uint32_t {
    Smooth = 1u << 0,       ///< a BSDF with a smooth part: next-event estimation has a receiver
    Delta = 1u << 1,        ///< a BSDF with a delta part
    Media = 1u << 2,        ///< dielectrics that paths go into
    Straight = 1u << 3,     ///< surfaces that shadow rays pass through: clear, thin glass
    DeltaLights = 1u << 4,  ///< point, spot, hard sun
    AreaLights = 1u << 5,   ///< emissive shapes
    Sky = 1u << 6,          ///< an environment that is not black, or a sun with a disc
    SampledSky = 1u << 7,   ///< of these, one with next-event estimation
    Lens = 1u << 8,         ///< an aperture
    Rough = 1u << 9,        ///< lobes between Lambert's and a mirror's: microfacets, Phong
    Casters = 1u << 10,  ///< perfect balls and faces under small lights, for the path integrator:
                         ///< see compile/casters.h
    Highlights =
        1u << 11,  ///< glossy surfaces under small lights, for it too: see compile/highlights.h
    // Not the scene's but the render's:
    Layers = 1u << 12,  ///< layers are asked for
    NoSkips =
        1u << 13,  ///< work that cannot count is done all the same, to prove that it may be skipped
};
inline constexpr std::array<std::string_view, 12> kFeatureNames = {
    "smooth BSDFs", "delta BSDFs", "media", "straight transmission", "delta lights", "area lights",
    "sky",          "sampled sky", "lens",  "rough lobes",           "caustics",     "highlights"};

using Features = std::uint32_t;
/// All that a scene can hold.
inline constexpr Features kAllFeatures = (1u << kFeatureNames.size()) - 1;
[[nodiscard]] constexpr bool has(Features features, Feature feature) {
    return (features & static_cast<Features>(feature)) != 0;
}

/// A material's leaves and what the kernels want to know of them at a glance.
struct CompiledMaterial {
    std::vector<WeightedLeaf> leaves;
    std::vector<float> pick;  ///< chance of each leaf's smooth part, in proportion to weight times
                              ///< albedo; sums to 1 or 0
    float smoothAlbedo =
        0;  ///< of all smooth parts together, for choosing between them and delta branches
    float broadAlbedo = 0;  ///< of those that are not one narrow lobe alone
    bool hasDelta = false;
    bool isRough = false;  ///< some leaf is, see kIsRough
    Rgb straight{0.0f};    ///< factor on light that passes straight through, at most; black: opaque
                           ///< to shadow rays
    bool dielectric = false;
    Medium medium;
    std::uint64_t bit = 0;  ///< stands for it in sets of materials, see materialBit()

    [[nodiscard]] bool hasSmooth() const { return smoothAlbedo > 0; }
};

/// The bit for a material in a set of 64; materials share one where there are more. No material:
/// bit 0.
[[nodiscard]] constexpr std::uint64_t materialBit(MaterialId id) {
    return std::uint64_t{1} << (id.value % 64);
}

struct RenderScene {
    DVec3 origin{0.0};  ///< world position of render space's origin
    SharedList<ShapeInstance> shapes;
    std::shared_ptr<const ShapeLists>
        lists;  ///< of `shapes`; scenes that have them in common share it
    std::vector<CompiledMaterial> materials;
    LightTable lights;
    LightBuffers lightBuffers;
    CasterTable casters;
    HighlightTable highlights;
    CameraModel camera;
    MediaStack cameraMedia;  ///< the dielectrics around the camera, where all of its rays start
    std::vector<std::uint32_t>
        cameraBoundaries;  ///< those that some of its rays may start inside of: lens, orthographic
    FilmSettings film;
    RenderSettings settings;
    Features features = 0;
    bool clearShadows = false;    ///< shadow rays pass all dielectrics as if there were none, and
                                  ///< nothing else
    std::size_t lightGroups = 1;  ///< number of groups that lights belong to
};

}  // namespace glint
