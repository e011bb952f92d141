// Every material. A new one is a file beside this and a word in the list.
#pragma once

#include "tracer/materials/diffuse.h"
#include "tracer/materials/glass.h"
#include "tracer/materials/glossy.h"
#include "tracer/materials/metal.h"
#include "tracer/materials/mirror.h"
#include "tracer/materials/mix.h"
#include "tracer/materials/phong.h"
#include "tracer/materials/translucent.h"

namespace glint {

/// Every leaf that a material can compile to.
using BsdfLeaf = std::variant<LambertBsdf, TranslucentBsdf, PhongBsdf, MirrorBsdf, GlassBsdf,
                              ThinGlassBsdf, RefractBsdf, ClearBsdf, MetalBsdf, PolishedMetalBsdf,
                              RoughGlassBsdf, RoughThinGlassBsdf, GlossyBsdf, PolishedGlossyBsdf>;

/// Leaves whose smooth part is more than Lambert's cosine: kernels without Feature::Rough leave
/// them out.
template <class Leaf>
inline constexpr bool kIsRough =
    Leaf::kSmooth && !std::is_same_v<Leaf, LambertBsdf> && !std::is_same_v<Leaf, TranslucentBsdf>;

/// Leaves that tell the refractive indices of their surroundings apart by a list.
template <class Leaf>
inline constexpr bool kKnowsIndices =
    std::is_same_v<Leaf, RoughGlassBsdf> || std::is_same_v<Leaf, RoughThinGlassBsdf> ||
    std::is_same_v<Leaf, GlossyBsdf> || std::is_same_v<Leaf, PolishedGlossyBsdf>;

using AllMaterials = TypeList<Diffuse, Mirror, Metal, Glass, Translucent, Glossy, Phong, Mix>;

}  // namespace glint
