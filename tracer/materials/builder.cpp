#include "tracer/materials/builder.h"

#include <algorithm>

namespace glint {

BsdfBuilder::BsdfBuilder(const Scene& scene) : scene_(scene) {
    const auto addIndex = [this](double ior) {
        const float n = static_cast<float>(ior);
        if (std::find(indices_.begin(), indices_.end(), n) != indices_.end()) return;
        if (indices_.size() < kMostIndices)
            indices_.push_back(n);
        else
            tooManyIndices_ = true;
    };
    scene.materials.forEach([&](MaterialId, const Material& material) {
        if (const auto* glass = std::get_if<Glass>(&material.value); glass && !glass->thin)
            addIndex(glass->ior.value);
        if (const auto* phong = std::get_if<Phong>(&material.value);
            phong && phong->refraction.value > 0)
            addIndex(phong->ior.value);
    });
}

std::vector<float> BsdfBuilder::ratiosTo(float n) const {
    std::vector<float> ratios;
    for (const float index : indices_) ratios.push_back(n / index);
    return ratios;
}

MaterialLeaves BsdfBuilder::build(MaterialId id) {
    out_ = {};
    if (const Material* material = scene_.materials.find(id))
        if (const auto* mix = std::get_if<Mix>(&material->value)) (void)value(mix->amount);
    for (const auto& [part, share] : blendOf(id)) {
        const Rgb weight(share);  // A lambda may not capture the binding itself in clang 14.
        if (!part)
            add(ClearBsdf{}, weight);
        else if (share > 0)
            std::visit(
                [&]<class M>(const M& m) {
                    if constexpr (!std::is_same_v<M, Mix>) m.compile(*this, weight);
                },
                scene_.materials.at(part).value);
    }
    const auto knowsIndices = [](const WeightedLeaf& weighted) {
        return std::visit([]<class Leaf>(const Leaf&) { return kKnowsIndices<Leaf>; },
                          weighted.leaf);
    };
    if (tooManyIndices_ && std::any_of(out_.leaves.begin(), out_.leaves.end(), knowsIndices))
        notBuilt("beside glass beyond the first " + std::to_string(kMostIndices - 1) +
                 " refractive indices of the scene, it reflects as if in air");
    return std::move(out_);
}

const BsdfBuilder::Blend& BsdfBuilder::blendOf(MaterialId id) {
    if (const auto known = blends_.find(id); known != blends_.end()) return known->second;
    // Entered empty, so that a mix that holds itself, which files cannot have, adds nothing there.
    Blend& blend = blends_[id];
    const Material* material = scene_.materials.find(id);
    if (!material) return blend;
    const auto* mix = std::get_if<Mix>(&material->value);
    if (!mix) {
        blend[id] = 1;
        return blend;
    }
    const float amount = static_cast<float>(mix->amount.value);
    Blend sum;
    for (const auto& [part, share] : {std::pair(mix->a, 1 - amount), std::pair(mix->b, amount)}) {
        if (part.clear) sum[MaterialId{}] += share;
        if (part.clear || !(share > 0)) continue;
        for (const auto& [simple, within] : blendOf(part.material)) sum[simple] += share * within;
    }
    return blend = std::move(sum);
}

}  // namespace glint
