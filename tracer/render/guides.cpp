#include "tracer/render/guides.h"

#include <algorithm>

#include "tracer/render/layers.h"
#include "tracer/render/shadow.h"

namespace glint {

namespace {

/// The branch that carries most light.
const DeltaBranch& brightest(const Branches& branches) {
    return *std::max_element(branches.at.begin(), branches.at.begin() + branches.count,
                             [](const DeltaBranch& a, const DeltaBranch& b) {
                                 return Branches::size(a) < Branches::size(b);
                             });
}

void describeFirst(const RenderScene& scene, const SurfacePoint& point, WorkCounts& work,
                   GuideSample& out) {
    LayerSample surface;
    describeSurface(scene, point, surface, work);
    out.albedo = surface.albedo;
    out.normal = surface.normal;
    out.position = surface.position;
    out.depth = surface.depth;
    out.object = surface.object;
    out.material = surface.material;
}

/// Light comes from the side of the surface that is looked at.
bool shines(const RenderScene& scene, const SurfacePoint& point) {
    const std::uint32_t light = point.instance(scene).light;
    return light != ~0u && (point.outside || scene.lights.lights[light].twoSided);
}

}  // namespace

GuideSample traceGuide(const RenderScene& scene, int x, int y, std::uint32_t sample) {
    constexpr int kMostSurfaces = 24;  // hidden boundaries included
    KernelState state{.scene = scene, .cancel = {}, .rays = {}};
    GuideSample out;
    out.depth = std::numeric_limits<float>::infinity();
    Ray ray = cameraRay<kAllFeatures>(scene, samplerFor(scene, x, y, sample), x, y, state.work);
    MediaStack media = scene.cameraMedia;
    double way = 0;
    bool first = true;
    for (int surfaces = 0; surfaces < kMostSurfaces; ++surfaces) {
        const ShapeHit hit = scene.lists->closest(ray, media, kInfinity, state.work);
        if (!hit.found()) break;
        way += hit.t;
        out.seenAlbedo *= transmittance<kAllFeatures>(mediumOf(scene, fillingShape(scene, media)),
                                                      hit.t, state.work);
        const SurfacePoint point = surfacePoint(scene, ray, hit, media);
        if (point.hidden) {
            ray = {point.position, ray.direction, point.shape, point.outside};
            media.cross(point.shape);
            continue;
        }
        if (first) describeFirst(scene, point, state.work, out);
        first = false;
        const CompiledMaterial& material = scene.materials[point.instance(scene).material];
        const Branches branches = material.hasDelta
                                      ? deltaBranches(material, point.wo, point.eta, state.work)
                                      : Branches{};
        if (material.smoothAlbedo >= branches.total) {
            LayerSample surface;
            describeSurface(scene, point, surface, state.work);
            out.seenAlbedo *= surface.albedo;
            const bool towardsRay = point.outside != shines(scene, point);
            out.seenNormal = towardsRay ? surface.normal : -surface.normal;
            out.seenNearness = static_cast<float>(1 / way);
            return out;
        }
        const DeltaBranch& branch = brightest(branches);
        out.seenAlbedo *= branch.weight / branch.scale;
        media = mediaBeyond<kAllFeatures>(state, point, media, branch.wi);
        ray = branch.straight ? point.ray(ray.direction, branch.wi.z < 0) : point.ray(branch.wi);
    }
    out.seenNormal = -toFloat(ray.direction);
    return out;
}

bool GuideFilm::refine(const std::shared_ptr<const RenderScene>& scene, int width, int height,
                       int stride, std::uint32_t samples, const CancelToken& cancel,
                       WorkerPool& pool) {
    if (width != width_ || height != height_) {
        width_ = width;
        height_ = height;
        samples_ = 0;
        pixels_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), {});
        rowIsCurrent_.assign(static_cast<std::size_t>(height), true);
    } else if (scene != scene_) {
        std::fill(rowIsCurrent_.begin(), rowIsCurrent_.end(), false);
    }
    if (scene != scene_) samples_ = 0;
    scene_ = scene;
    const std::uint32_t target = std::min(samples, kSamples);
    const auto addTo = [&](Pixel& pixel, int x, int y) {
        const GuideSample s = traceGuide(*scene, x, y, pixel.samples);
        const float share = 1.0f / static_cast<float>(pixel.samples + 1);
        const auto mix = [share](auto& mean, const auto& value) { mean += (value - mean) * share; };
        mix(pixel.albedo, s.albedo);
        mix(pixel.normal, s.normal);
        mix(pixel.seenAlbedo, s.seenAlbedo);
        mix(pixel.seenNormal, s.seenNormal);
        mix(pixel.seenNearness, s.seenNearness);
        if (pixel.samples++ > 0) return;
        pixel.position = s.position;
        pixel.depth = s.depth;
        pixel.object = s.object;
        pixel.material = s.material;
    };
    const int rows = (height + stride - 1) / stride;
    std::atomic<bool> complete{
        true};  // of all workers; only a flag, read after they ended: relaxed
    pool.run(rows, [&](int, int row) {
        if (auto& current = rowIsCurrent_[static_cast<std::size_t>(row * stride)]; !current) {
            std::fill_n(pixels_.begin() + static_cast<std::ptrdiff_t>(row) * stride * width, width,
                        Pixel{});
            current = true;
        }
        for (int x = 0; x < width; x += stride) {
            Pixel& pixel =
                pixels_[static_cast<std::size_t>(row * stride) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(x)];
            while (pixel.samples < target) {
                if (cancel.cancelled()) return complete.store(false, std::memory_order_relaxed);
                addTo(pixel, x, row * stride);
            }
        }
    });
    const bool done = complete.load(std::memory_order_relaxed);
    if (done && stride == 1) samples_ = std::max(samples_, target);
    return done;
}

}  // namespace glint
