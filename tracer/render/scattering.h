// Evaluating a compiled material at a point: the smooth leaves as one mixture, the delta leaves as a list of branches.
#pragma once

#include <array>

#include "tracer/render/surface.h"

namespace glint {

/// The delta branches at a point with their leaf weights applied.
struct Branches {
    static constexpr int kCapacity = 16;
    std::array<DeltaBranch, kCapacity> at;
    int count = 0;
    float total = 0;  ///< sum of the sizes

    /// What a branch is chosen by: its largest share of light.
    static float size(const DeltaBranch& branch) { return maxComponent(branch.weight) / branch.scale; }

    void add(const DeltaBranch& branch) {
        if (!(size(branch) > 0) || count == kCapacity) return;
        at[static_cast<std::size_t>(count++)] = branch;
        total += size(branch);
    }
    /// The branch at `u` in [0, total), drawn with probability size / total.
    [[nodiscard]] const DeltaBranch& pick(float u) const {
        std::size_t i = 0;
        while (i + 1 < static_cast<std::size_t>(count) && u >= size(at[i])) u -= size(at[i++]);
        return at[i];
    }
};

[[nodiscard]] inline Branches deltaBranches(const CompiledMaterial& material, const Vec3& wo, float eta) {
    Branches out;
    for (const WeightedLeaf& weighted : material.leaves)
        std::visit(
            [&]<class Leaf>(const Leaf& leaf) {
                if constexpr (Leaf::kDelta) {
                    DeltaBranch found[kMaxBranches];
                    const int count = leaf.branches(wo, eta, found);
                    for (int i = 0; i < count; ++i) {
                        found[i].weight *= weighted.weight;
                        out.add(found[i]);
                    }
                }
            },
            weighted.leaf);
    return out;
}

/// Sum of the smooth leaves' f (without the cosine) and their mixture's density.
[[nodiscard]] inline BsdfSample evalSmooth(const CompiledMaterial& material, const Vec3& wo, const Vec3& wi, float eta) {
    BsdfSample out{wi};
    for (std::size_t i = 0; i < material.leaves.size(); ++i)
        std::visit(
            [&]<class Leaf>(const Leaf& leaf) {
                if constexpr (Leaf::kSmooth) {
                    out.f += material.leaves[i].weight * leaf.eval(wo, wi, eta);
                    out.pdf += material.pick[i] * leaf.pdf(wo, wi, eta);
                }
            },
            material.leaves[i].leaf);
    return out;
}

/// A direction from the mixture of the smooth leaves. `u`: three numbers for the leaf, one to choose it, all in [0, 1).
[[nodiscard]] inline BsdfSample sampleSmooth(const CompiledMaterial& material, const Vec3& wo, const Vec3& u, float choice, float eta) {
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < material.leaves.size(); ++i) {
        if (!(material.pick[i] > 0)) continue;
        chosen = i;
        if (choice < material.pick[i]) break;
        choice -= material.pick[i];
    }
    BsdfSample sample;
    std::visit(
        [&]<class Leaf>(const Leaf& leaf) {
            if constexpr (Leaf::kSmooth) sample = leaf.sample(wo, u, eta);
        },
        material.leaves[chosen].leaf);
    if (!(sample.pdf > 0)) return {};
    if (material.leaves.size() == 1) {
        sample.f *= material.leaves[0].weight;
        return sample;
    }
    return evalSmooth(material, wo, sample.wi, eta);
}

/// Share of light that passes straight through at this angle.
[[nodiscard]] inline Rgb straightWeight(const CompiledMaterial& material, const Vec3& wo, float eta) {
    Rgb sum(0.0f);
    const Branches branches = deltaBranches(material, wo, eta);
    for (int i = 0; i < branches.count; ++i)
        if (const DeltaBranch& b = branches.at[static_cast<std::size_t>(i)]; b.straight) sum += b.weight;
    return sum;
}

}  // namespace glint
