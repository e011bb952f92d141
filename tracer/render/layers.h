// Layers: what a picture's light is made of, and what its first surfaces are. Filled only when
// asked for, by kernels with Feature::Layers; the light layers sum to the beauty picture.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tracer/io/film_exr.h"
#include "tracer/render/film.h"
#include "tracer/render/scattering.h"

namespace glint {

/// How light left the first surface that turned it.
enum class Lobe { Diffuse, Glossy, Transmission };

/// Shares of the three lobes in some light, per channel; they sum to 1.
using LobeShares = std::array<Rgb, 3>;

enum class LightLayer {
    DiffuseDirect,
    DiffuseIndirect,
    GlossyDirect,
    GlossyIndirect,
    TransmissionDirect,
    TransmissionIndirect,
    Emission,
    Environment
};
inline constexpr std::size_t kLightLayers = 8;

/// One sample's layers. Ids are 1-based (0: nothing was hit); of objects they are the document's.
struct LayerSample {
    std::array<Rgb, kLightLayers> light{};
    Rgb albedo{0.0f};
    Vec3 normal{0.0f};    ///< world space, outward
    float depth = 1e10f;  ///< along the view axis, metres; 1e10 where nothing is
    Vec3 position{0.0f};  ///< world space
    std::uint32_t object = 0, material = 0;

    void add(LightLayer layer, const Rgb& value) {
        light[static_cast<std::size_t>(layer)] += value;
    }
    /// Light by the way of the first surface: `direct` if it came there straight from a source.
    void add(const LobeShares& shares, bool direct, const Rgb& value) {
        for (std::size_t lobe = 0; lobe < shares.size(); ++lobe)
            light[2 * lobe + (direct ? 0 : 1)] += value * shares[lobe];
    }
};

/// All of one lobe.
[[nodiscard]] inline LobeShares sharesOf(Lobe lobe) {
    LobeShares out{};
    out[static_cast<std::size_t>(lobe)] = Rgb(1.0f);
    return out;
}

/// The part of a smooth leaf's f that is diffuse reflection.
template <class Leaf>
[[nodiscard]] Rgb diffusePart(const Leaf& leaf, const Vec3& wo, const Vec3& wi, float eta,
                              const Rgb& f) {
    if constexpr (requires { leaf.baseValue(wo, wi, eta); })
        return leaf.baseValue(wo, wi, eta);
    else if constexpr (std::is_same_v<Leaf, LambertBsdf> || std::is_same_v<Leaf, TranslucentBsdf> ||
                       std::is_same_v<Leaf, PolishedGlossyBsdf>)
        return f;
    else
        return Rgb(0.0f);
}

/// The lobes' shares in the smooth part at a pair of directions.
[[nodiscard]] inline LobeShares smoothShares(const CompiledMaterial& material, const Vec3& wo,
                                             const Vec3& wi, float eta) {
    if (!sameSide(wo, wi)) return sharesOf(Lobe::Transmission);
    Rgb whole(0.0f), diffuse(0.0f);
    for (const WeightedLeaf& weighted : material.leaves)
        std::visit(
            [&]<class Leaf>(const Leaf& leaf) {
                if constexpr (Leaf::kSmooth) {
                    const Rgb f = leaf.value(wo, wi, eta).f;
                    whole += weighted.weight * f;
                    diffuse += weighted.weight * diffusePart(leaf, wo, wi, eta, f);
                }
            },
            weighted.leaf);
    LobeShares out{};
    for (int c = 0; c < 3; ++c) {
        out[0][c] = whole[c] > 0 ? diffuse[c] / whole[c] : 1;
        out[1][c] = 1 - out[0][c];
    }
    return out;
}

/// Fills what is known of a surface by looking at it.
void describeSurface(const RenderScene& scene, const SurfacePoint& point, LayerSample& out,
                     WorkCounts& work);

/// The layers of a whole film: means of light, albedo and normal; the rest from each pixel's first
/// sample.
class LayerFilm {
  public:
    /// All layers, or only which share of each pixel's samples met an object.
    enum class Content { All, Coverage };
    LayerFilm(int width, int height, Content content = Content::All);

    void add(int x, int y, const LayerSample& sample);
    /// EXR channels by layer: diffuse_direct.R ... environment.B, albedo.R, normal.X, depth.Z,
    /// position.X, object_id.id, material_id.id; the light layers only if `withLight`.
    void appendTo(std::vector<ExrChannel>& channels, bool withLight) const;
    /// height x width, row-major: 0 where every sample went past all objects, to 1.
    [[nodiscard]] std::vector<float> coverage() const;

  private:
    static constexpr std::size_t kMeans = 3 * (kLightLayers + 2);
    struct Pixel {
        std::array<double, kMeans> sums{};
        float depth = 0;
        Vec3 position{0.0f};
        std::uint32_t object = 0, material = 0, samples = 0;
    };
    struct Cover {
        std::uint32_t hits = 0, samples = 0;
    };
    int width_;
    std::vector<Pixel> pixels_;  ///< empty if only coverage is kept
    std::vector<Cover> cover_;
};

/// The picture's own channels R, G, B, the number of samples and the standard error of the mean's
/// luminance, the latter from the difference of the film's halves over 8 x 8 pixels.
void appendFilm(const Film& film, std::vector<ExrChannel>& channels);

}  // namespace glint
