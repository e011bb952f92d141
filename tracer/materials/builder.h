// BsdfBuilder: collects the weighted leaves of one material while the document's materials describe
// themselves to it.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "tracer/materials/all.h"
#include "tracer/scene/scene.h"

namespace glint {

struct WeightedLeaf {
    BsdfLeaf leaf;
    Rgb weight{1.0f};
};

/// What fills a closed object made of a dielectric.
struct Medium {
    float ior = 1;
    Color absorption;  ///< 1/m; in double, as it goes with the scene's size
    int priority = 0;
};

/// One material, ready to be evaluated.
struct MaterialLeaves {
    std::vector<WeightedLeaf> leaves;
    bool dielectric = false;  ///< `medium` fills the inside of closed shapes
    Medium medium;
    std::vector<std::string> notBuilt;  ///< what is drawn differently from what the document says
};

class BsdfBuilder {
  public:
    explicit BsdfBuilder(const Scene& scene);

    /// The leaves of a material. A mix is taken apart into what it blends, each once, however often
    /// mixes of mixes name it.
    [[nodiscard]] MaterialLeaves build(MaterialId id);

    void add(const BsdfLeaf& leaf, const Rgb& weight) {
        if (!isBlack(weight)) out_.leaves.push_back({leaf, weight});
    }
    void setMedium(float ior, const Color& absorption, int priority) {
        out_.dielectric = true;
        out_.medium = {ior, absorption, priority};
    }
    void notBuilt(std::string what) { out_.notBuilt.push_back(std::move(what)); }

    /// The refractive indices that a surface can stand in: 1, then those of the scene's
    /// dielectrics, at most kMostIndices.
    [[nodiscard]] std::span<const float> surroundings() const { return indices_; }
    /// Index `n` over each of the surroundings'.
    [[nodiscard]] std::vector<float> ratiosTo(float n) const;

    [[nodiscard]] Color color(const Textured<Color>& v) {
        if (v.texture) notBuilt("its textures are drawn in their plain colour");
        return v.value;
    }
    [[nodiscard]] Rgb value(const Textured<Color>& v) { return toRgb(color(v)); }
    [[nodiscard]] float value(const Textured<double>& v) {
        if (v.texture) notBuilt("its textures are drawn as their plain number");
        return static_cast<float>(v.value);
    }

  private:
    /// Bounds the search of leaves for what they know of an index around.
    static constexpr std::size_t kMostIndices = 16;
    /// Shares of simple materials; of "clear" under the id 0.
    using Blend = std::map<MaterialId, float>;

    const Blend& blendOf(MaterialId id);

    const Scene& scene_;
    std::vector<float> indices_{1.0f};
    bool tooManyIndices_ = false;
    std::map<MaterialId, Blend> blends_;
    MaterialLeaves out_;
};

}  // namespace glint
