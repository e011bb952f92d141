// Compiled once an instruction set: AVX2 (eight lanes), SSE4 (four, twice) and plain code as the
// last resort.
#include "tracer/render/preview_filter.h"

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/render/preview_filter_simd.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h has to come first.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glint::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<float, FilterPlane::kLanes>;
using V = hn::Vec<Tag>;
constexpr Tag kTag;

// How unlike two pixels may be. Each difference is divided by its measure; the weight is about
// exp(-sum).
constexpr float kNormalSharpness = 40;       ///< times 1 - cosine
constexpr float kNearnessTolerance = 0.01f;  ///< of the nearness itself ...
constexpr float kSlopeTolerance = 0.25f;     ///< ... and of its foreseen change
constexpr float kLuminanceTolerance = 4;     ///< standard deviations
constexpr float kOutlier = 3;  ///< standard deviations over its neighbours that make a pixel one

HWY_INLINE V set(float x) { return hn::Set(kTag, x); }
HWY_INLINE V at(const FilterPlane& plane, int x, int y) {
    return hn::LoadU(kTag, plane.row(y) + x);
}

/// (1 - x/8)^8, near exp(-x) and 0 from 8 on.
HWY_INLINE V falloff(V x) {
    const V base = hn::Max(hn::NegMulAdd(x, set(0.125f), set(1.0f)), hn::Zero(kTag));
    const V second = hn::Mul(base, base), fourth = hn::Mul(second, second);
    return hn::Mul(fourth, fourth);
}

/// What a pixel compares its neighbours with.
struct Center {
    V normal[3], nearness, slope[2], invTolerance;
};
HWY_INLINE Center centerAt(const FilterPlanes& p, int x, int y, int distance) {
    Center out{{at(p.normal[0], x, y), at(p.normal[1], x, y), at(p.normal[2], x, y)},
               at(p.nearness, x, y),
               {at(p.slope[0], x, y), at(p.slope[1], x, y)},
               {}};
    const V change = hn::Mul(hn::Add(hn::Abs(out.slope[0]), hn::Abs(out.slope[1])),
                             set(kSlopeTolerance * static_cast<float>(distance)));
    out.invTolerance = hn::Div(
        set(1.0f), hn::MulAdd(out.nearness, set(kNearnessTolerance), hn::Add(change, set(1e-30f))));
    return out;
}

/// How unlike the surface at (x, y) is, (dx, dy) pixels away.
HWY_INLINE V surfaceDifference(const FilterPlanes& p, const Center& center, int x, int y, float dx,
                               float dy) {
    const V cosine = hn::MulAdd(at(p.normal[2], x, y), center.normal[2],
                                hn::MulAdd(at(p.normal[1], x, y), center.normal[1],
                                           hn::Mul(at(p.normal[0], x, y), center.normal[0])));
    const V foreseen =
        hn::MulAdd(center.slope[0], set(dx), hn::MulAdd(center.slope[1], set(dy), center.nearness));
    const V off = hn::Abs(hn::Sub(at(p.nearness, x, y), foreseen));
    return hn::MulAdd(off, center.invTolerance,
                      hn::NegMulAdd(cosine, set(kNormalSharpness), set(kNormalSharpness)));
}

HWY_INLINE V luminanceOf(V r, V g, V b) {
    return hn::MulAdd(r, set(0.2126f), hn::MulAdd(g, set(0.7152f), hn::Mul(b, set(0.0722f))));
}

/// The smaller of the changes to both sides: that of the surface the pixel lies on.
HWY_INLINE V slopeAlong(const FilterPlane& plane, int x, int y, int dx, int dy) {
    const V here = at(plane, x, y), forward = hn::Sub(at(plane, x + dx, y + dy), here),
            back = hn::Sub(here, at(plane, x - dx, y - dy));
    return hn::IfThenElse(hn::Lt(hn::Abs(forward), hn::Abs(back)), forward, back);
}

/// Sums over the like neighbours of a pixel, itself left out but for the variance.
struct Neighbours {
    V weights, light, squares;  ///< light: of the luminance
    V known, variance;          ///< of the pixels that know their own variance
};
HWY_INLINE Neighbours likeNeighbours(const FilterPlanes& p, int x, int y) {
    constexpr int kRadius = 2;
    const Center center = centerAt(p, x, y, 1);
    const V zero = hn::Zero(kTag), tiny = set(1e-20f);
    Neighbours out{tiny, zero, zero, tiny, zero};
    for (int dy = -kRadius; dy <= kRadius; ++dy)
        for (int dx = -kRadius; dx <= kRadius; ++dx) {
            const int nx = x + dx, ny = y + dy;
            const bool self = dx == 0 && dy == 0;
            const V w = self ? set(1.0f)
                             : falloff(surfaceDifference(p, center, nx, ny, static_cast<float>(dx),
                                                         static_cast<float>(dy)));
            const V v = at(p.variance[0], nx, ny),
                    wKnown = hn::IfThenElseZero(hn::Ge(v, hn::Zero(kTag)), w);
            out.known = hn::Add(out.known, wKnown);
            out.variance = hn::MulAdd(wKnown, v, out.variance);
            if (self) continue;
            const V l = luminanceOf(at(p.light[0][0], nx, ny), at(p.light[0][1], nx, ny),
                                    at(p.light[0][2], nx, ny));
            out.weights = hn::Add(out.weights, w);
            out.light = hn::MulAdd(w, l, out.light);
            out.squares = hn::MulAdd(w, hn::Mul(l, l), out.squares);
        }
    return out;
}

/// What is left of luminance `l` if it stands out of its neighbours, and its own noise (variance
/// `own`) says that it may be chance.
HWY_INLINE V withoutOutlier(V l, V own, const Neighbours& near, V mean, V among) {
    const V usual = hn::MulAdd(hn::Sqrt(among), set(kOutlier), mean);
    const V sure = hn::NegMulAdd(hn::Sqrt(hn::Max(own, hn::Zero(kTag))), set(kOutlier), l);
    const V limit = hn::IfThenElse(hn::Gt(near.weights, set(1.0f)), hn::Max(usual, sure), l);
    return hn::Div(hn::Min(l, hn::Max(limit, hn::Zero(kTag))), hn::Max(l, set(1e-30f)));
}

void prepare(FilterPlanes& p, int y) {
    for (int x = 0; x < p.width; x += static_cast<int>(hn::Lanes(kTag))) {
        hn::StoreU(slopeAlong(p.nearness, x, y, 1, 0), kTag, p.slope[0].row(y) + x);
        hn::StoreU(slopeAlong(p.nearness, x, y, 0, 1), kTag, p.slope[1].row(y) + x);
        const Neighbours near = likeNeighbours(p, x, y);
        const V mean = hn::Div(near.light, near.weights);
        const V among =
            hn::Max(hn::NegMulAdd(mean, mean, hn::Div(near.squares, near.weights)), hn::Zero(kTag));
        const V told = hn::Div(near.variance, near.known);
        hn::StoreU(hn::IfThenElse(hn::Gt(near.known, set(1e-6f)), told, among), kTag,
                   p.variance[1].row(y) + x);

        const V l =
            luminanceOf(at(p.light[0][0], x, y), at(p.light[0][1], x, y), at(p.light[0][2], x, y));
        const V own = at(p.variance[0], x, y);
        const V share = withoutOutlier(
            l, hn::IfThenElse(hn::Ge(own, hn::Zero(kTag)), own, hn::Mul(l, l)), near, mean, among);
        for (int c = 0; c < 3; ++c)
            hn::StoreU(hn::Mul(share, at(p.light[0][c], x, y)), kTag, p.light[1][c].row(y) + x);
    }
}

/// `kRadius` 2: the cubic B-spline of Dammertz et al.; 1: the smaller one, which is enough for the
/// nearest neighbours.
template <int kRadius>
void stepWithin(FilterPlanes& p, int from, int distance, int y) {
    static constexpr float kSpline[2][3] = {{1.0f / 2, 1.0f / 4, 0},
                                            {3.0f / 8, 1.0f / 4, 1.0f / 16}};
    constexpr auto& kWeights = kSpline[kRadius - 1];
    const FilterPlane(&light)[3] = p.light[from];
    for (int x = 0; x < p.width; x += static_cast<int>(hn::Lanes(kTag))) {
        const Center center = centerAt(p, x, y, distance);
        const V r = at(light[0], x, y), g = at(light[1], x, y), b = at(light[2], x, y),
                variance = at(p.variance[from], x, y);
        const V l = luminanceOf(r, g, b);
        const V invNoise = hn::Div(
            set(1.0f), hn::MulAdd(hn::Sqrt(variance), set(kLuminanceTolerance), set(1e-12f)));
        V w = set(kWeights[0] * kWeights[0]);
        V weights = w, sumR = hn::Mul(w, r), sumG = hn::Mul(w, g), sumB = hn::Mul(w, b),
          sumVariance = hn::Mul(hn::Mul(w, w), variance);
        for (int j = -kRadius; j <= kRadius; ++j)
            for (int i = -kRadius; i <= kRadius; ++i) {
                if (i == 0 && j == 0) continue;
                const int dx = i * distance, dy = j * distance, nx = x + dx, ny = y + dy;
                const V nr = at(light[0], nx, ny), ng = at(light[1], nx, ny),
                        nb = at(light[2], nx, ny);
                const V surface = surfaceDifference(p, center, nx, ny, static_cast<float>(dx),
                                                    static_cast<float>(dy));
                const V unlike =
                    hn::MulAdd(hn::Abs(hn::Sub(luminanceOf(nr, ng, nb), l)), invNoise, surface);
                w = hn::Mul(falloff(unlike), set(kWeights[std::abs(i)] * kWeights[std::abs(j)]));
                weights = hn::Add(weights, w);
                sumR = hn::MulAdd(w, nr, sumR);
                sumG = hn::MulAdd(w, ng, sumG);
                sumB = hn::MulAdd(w, nb, sumB);
                sumVariance = hn::MulAdd(hn::Mul(w, w), at(p.variance[from], nx, ny), sumVariance);
            }
        const V scale = hn::Div(set(1.0f), weights);
        const int to = 1 - from;
        hn::StoreU(hn::Mul(sumR, scale), kTag, p.light[to][0].row(y) + x);
        hn::StoreU(hn::Mul(sumG, scale), kTag, p.light[to][1].row(y) + x);
        hn::StoreU(hn::Mul(sumB, scale), kTag, p.light[to][2].row(y) + x);
        hn::StoreU(hn::Mul(sumVariance, hn::Mul(scale, scale)), kTag, p.variance[to].row(y) + x);
    }
}

void step(FilterPlanes& p, int from, int distance, int y) {
    if (distance == 1)
        stepWithin<1>(p, from, distance, y);
    else
        stepWithin<2>(p, from, distance, y);
}

}  // namespace

FilterLoops loops() { return {prepare, step}; }

}  // namespace glint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glint {

HWY_EXPORT(loops);

FilterLoops filterLoops() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    return HWY_DYNAMIC_DISPATCH(loops)();
}

}  // namespace glint
#endif
