// Evaluating a compiled material at a point: the smooth leaves as one mixture, the delta leaves as
// a list of branches.
#pragma once

#include <array>

#include "tracer/render/surface.h"

namespace glint {

/// The delta branches at a point with their leaf weights applied.
struct Branches {
    static constexpr int kCapacity =
        4;  ///< mirrored, refracted, straight on, and refracted straight on
    std::array<DeltaBranch, kCapacity> at;
    int count = 0;
    float total = 0;  ///< sum of the sizes

    /// What a branch is chosen by: its largest share of light.
    static float size(const DeltaBranch& branch) {
        return maxComponent(branch.weight) / branch.scale;
    }

    /// Leaves that send light the same way make one branch.
    void add(const DeltaBranch& branch) {
        if (!(size(branch) > 0)) return;
        for (int i = 0; i < count; ++i)
            if (DeltaBranch& other = at[static_cast<std::size_t>(i)];
                other.wi == branch.wi && other.straight == branch.straight) {
                const float both = size(other) + size(branch);
                other.weight += branch.weight;
                other.scale = maxComponent(other.weight) / both;
                total += size(branch);
                return;
            }
        at[static_cast<std::size_t>(count++)] = branch;
        total += size(branch);
    }
    /// Both of two ways can be followed, and there is no other.
    [[nodiscard]] bool areTwo(const CompiledMaterial& material) const {
        return count == 2 && material.smoothAlbedo == 0;
    }
    /// Chance of a path that chooses among all ways, smooth ones too, to be reflected or, if not
    /// `reflects`, to go through bent.
    [[nodiscard]] double chanceOf(const CompiledMaterial& material, const Vec3& wo,
                                  bool reflects) const {
        float sum = 0;
        for (int i = 0; i < count; ++i)
            if (const DeltaBranch& b = at[static_cast<std::size_t>(i)];
                !b.straight && sameSide(wo, b.wi) == reflects)
                sum += size(b);
        return static_cast<double>(sum / (material.smoothAlbedo + total));
    }
    /// Factor of these ways together.
    [[nodiscard]] Rgb weightOf(const Vec3& wo, bool reflects) const {
        Rgb sum(0.0f);
        for (int i = 0; i < count; ++i)
            if (const DeltaBranch& b = at[static_cast<std::size_t>(i)];
                !b.straight && sameSide(wo, b.wi) == reflects)
                sum += b.weight;
        return sum;
    }
    /// The branch at `u` in [0, total), drawn with probability size / total.
    [[nodiscard]] const DeltaBranch& pick(float u) const {
        std::size_t i = 0;
        while (i + 1 < static_cast<std::size_t>(count) && u >= size(at[i])) u -= size(at[i++]);
        return at[i];
    }
};

[[nodiscard]] inline Branches deltaBranches(const CompiledMaterial& material, const Vec3& wo,
                                            float eta, WorkCounts& work) {
    ++work[Work::DeltaLists];
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

/// Calls `use` with the leaf if it has a smooth part that the kernel knows. The most common leaf is
/// asked for first, which spares it the jump through a table.
template <Features F, class Use>
void withSmoothLeaf(const BsdfLeaf& leaf, WorkCounts& work, Use&& use) {
    if (const auto* lambert = std::get_if<LambertBsdf>(&leaf)) return use(*lambert);
    if constexpr (has(F, Feature::Rough)) {
        std::visit(
            [&]<class Leaf>(const Leaf& other) {
                if constexpr (kIsRough<Leaf>) ++work[Work::RoughLobes];
                if constexpr (Leaf::kSmooth && !std::is_same_v<Leaf, LambertBsdf>) use(other);
            },
            leaf);
    } else if (const auto* translucent = std::get_if<TranslucentBsdf>(&leaf)) {
        use(*translucent);
    }
}

/// Sum of the smooth leaves' f (without the cosine) and their mixture's density.
template <Features F>
[[nodiscard]] BsdfSample evalSmooth(const CompiledMaterial& material, const Vec3& wo,
                                    const Vec3& wi, float eta, WorkCounts& work) {
    BsdfValue sum;
    for (std::size_t i = 0; i < material.leaves.size(); ++i)
        withSmoothLeaf<F>(material.leaves[i].leaf, work, [&](const auto& leaf) {
            const BsdfValue value = leaf.value(wo, wi, eta);
            sum.f += material.leaves[i].weight * value.f;
            sum.pdf += material.pick[i] * value.pdf;
        });
    return {wi, sum};
}

/// Sum of the smooth leaves' f alone.
template <Features F>
[[nodiscard]] inline Rgb smoothValue(const CompiledMaterial& material, const Vec3& wo,
                                     const Vec3& wi, float eta, WorkCounts& work) {
    Rgb out(0.0f);
    for (const WeightedLeaf& weighted : material.leaves)
        withSmoothLeaf<F>(weighted.leaf, work, [&](const auto& leaf) {
            out += weighted.weight * leaf.value(wo, wi, eta).f;
        });
    return out;
}

/// A direction from the mixture of the smooth leaves. `u`: three numbers for the leaf, one to
/// choose it, all in [0, 1).
template <Features F>
[[nodiscard]] BsdfSample sampleSmooth(const CompiledMaterial& material, const Vec3& wo,
                                      const Vec3& u, float choice, float eta, WorkCounts& work) {
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < material.leaves.size(); ++i) {
        if (!(material.pick[i] > 0)) continue;
        chosen = i;
        if (choice < material.pick[i]) break;
        choice -= material.pick[i];
    }
    BsdfSample sample;
    withSmoothLeaf<F>(material.leaves[chosen].leaf, work,
                      [&](const auto& leaf) { sample = leaf.sample(wo, u, eta); });
    if (!(sample.pdf > 0)) return {};
    if (material.leaves.size() == 1) {
        sample.f *= material.leaves[0].weight;
        return sample;
    }
    return evalSmooth<F>(material, wo, sample.wi, eta, work);
}

/// Share of light that passes straight through at this angle.
[[nodiscard]] inline Rgb straightWeight(const CompiledMaterial& material, const Vec3& wo, float eta,
                                        WorkCounts& work) {
    Rgb sum(0.0f);
    const Branches branches = deltaBranches(material, wo, eta, work);
    for (int i = 0; i < branches.count; ++i)
        if (const DeltaBranch& b = branches.at[static_cast<std::size_t>(i)]; b.straight)
            sum += b.weight;
    return sum;
}

}  // namespace glint
