// BsdfBuilder: collects the weighted leaves of one material while the document's materials describe themselves to it.
#pragma once

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
    explicit BsdfBuilder(const Scene& scene) : scene_(scene) {}

    [[nodiscard]] MaterialLeaves build(MaterialId id) {
        out_ = {};
        add(id, Rgb(1.0f));
        return std::move(out_);
    }

    void add(const BsdfLeaf& leaf, const Rgb& weight) {
        if (!isBlack(weight)) out_.leaves.push_back({leaf, weight});
    }
    /// Everything that another material consists of. Cycles are refused by the reader of files; deeper than 64 is a cycle.
    void add(MaterialId id, const Rgb& weight) {
        const Material* material = scene_.materials.find(id);
        if (!material || depth_ >= 64) return;
        ++depth_;
        std::visit([&](const auto& m) { m.compile(*this, weight); }, material->value);
        --depth_;
    }
    void setMedium(float ior, const Color& absorption, int priority) {
        out_.dielectric = true;
        out_.medium = {ior, absorption, priority};
    }
    void notBuilt(std::string what) { out_.notBuilt.push_back(std::move(what)); }

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
    const Scene& scene_;
    MaterialLeaves out_;
    int depth_ = 0;
};

}  // namespace glint
