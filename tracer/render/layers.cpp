#include "tracer/render/layers.h"

#include <algorithm>
#include <string>

#include "tracer/render/tile_error.h"

namespace glint {

namespace {

constexpr std::array<const char*, kLightLayers> kLightNames = {
    "diffuse_direct",      "diffuse_indirect",      "glossy_direct", "glossy_indirect",
    "transmission_direct", "transmission_indirect", "emission",      "environment"};

/// Light that a surface sends back or lets through when lit evenly, as far as its leaves say.
Rgb albedoOf(const CompiledMaterial& material, const SurfacePoint& point, WorkCounts& work) {
    Rgb sum(0.0f);
    for (const WeightedLeaf& weighted : material.leaves)
        std::visit(
            [&]<class Leaf>(const Leaf& leaf) {
                if constexpr (Leaf::kSmooth) sum += weighted.weight * leaf.albedo();
            },
            weighted.leaf);
    if (material.hasDelta) {
        const Branches branches = deltaBranches(material, point.wo, point.eta, work);
        for (int i = 0; i < branches.count; ++i) {
            const DeltaBranch& branch = branches.at[static_cast<std::size_t>(i)];
            sum += branch.weight / branch.scale;
        }
    }
    return glm::min(sum, Rgb(1.0f));
}

}  // namespace

void describeSurface(const RenderScene& scene, const SurfacePoint& point, LayerSample& out,
                     WorkCounts& work) {
    const ShapeInstance& instance = point.instance(scene);
    out.albedo = albedoOf(scene.materials[instance.material], point, work);
    out.normal = toFloat(point.frame.n);
    out.position = toFloat(point.position + scene.origin);
    out.depth = static_cast<float>(
        glm::dot(point.position - scene.camera.position(), scene.camera.forward()));
    out.object = instance.object.value;
    out.material = instance.material + 1;
}

LayerFilm::LayerFilm(int width, int height, Content content)
    : width_(width), cover_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    if (content == Content::All) pixels_.resize(cover_.size());
}

void LayerFilm::add(int x, int y, const LayerSample& sample) {
    const std::size_t index = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                              static_cast<std::size_t>(x);
    ++cover_[index].samples;
    if (sample.object != 0) ++cover_[index].hits;
    if (pixels_.empty()) return;
    Pixel& pixel = pixels_[index];
    const auto addTo = [&](std::size_t layer, const Vec3& value) {
        for (int c = 0; c < 3; ++c)
            pixel.sums[3 * layer + static_cast<std::size_t>(c)] += static_cast<double>(value[c]);
    };
    for (std::size_t i = 0; i < kLightLayers; ++i) addTo(i, sample.light[i]);
    addTo(kLightLayers, sample.albedo);
    addTo(kLightLayers + 1, sample.normal);
    if (pixel.samples++ > 0) return;
    pixel.depth = sample.depth;
    pixel.position = sample.position;
    pixel.object = sample.object;
    pixel.material = sample.material;
}

std::vector<float> LayerFilm::coverage() const {
    std::vector<float> out;
    out.reserve(cover_.size());
    for (const Cover& c : cover_)
        out.push_back(c.samples ? static_cast<float>(c.hits) / static_cast<float>(c.samples)
                                : 0.0f);
    return out;
}

void LayerFilm::appendTo(std::vector<ExrChannel>& channels, bool withLight) const {
    const auto append = [&](const std::string& name, auto valueOf) {
        ExrChannel channel{name, {}};
        channel.values.reserve(pixels_.size());
        for (const Pixel& pixel : pixels_)
            channel.values.push_back(static_cast<float>(valueOf(pixel)));
        channels.push_back(std::move(channel));
    };
    const auto appendMean = [&](const std::string& layer, std::size_t index, const char* letters) {
        for (std::size_t c = 0; c < 3; ++c)
            append(layer + "." + letters[c], [&](const Pixel& p) {
                return p.samples ? p.sums[3 * index + c] / p.samples : 0.0;
            });
    };
    if (withLight)
        for (std::size_t i = 0; i < kLightLayers; ++i) appendMean(kLightNames[i], i, "RGB");
    appendMean("albedo", kLightLayers, "RGB");
    appendMean("normal", kLightLayers + 1, "XYZ");
    append("depth.Z", [](const Pixel& p) { return p.depth; });
    for (int c = 0; c < 3; ++c)
        append(std::string("position.") + "XYZ"[c], [&](const Pixel& p) { return p.position[c]; });
    append("object_id.id", [](const Pixel& p) { return p.object; });
    append("material_id.id", [](const Pixel& p) { return p.material; });
}

void appendFilm(const Film& film, std::vector<ExrChannel>& channels) {
    const int width = film.width(), height = film.height();
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    std::array<ExrChannel, 5> out = {
        ExrChannel{"R", {}}, {"G", {}}, {"B", {}}, {"sample_count.n", {}}, {"error.sigma", {}}};
    for (ExrChannel& channel : out) channel.values.resize(count);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x);
            const FilmPixel pixel = film.at(x, y);
            const Rgb mean = pixel.mean();
            for (int c = 0; c < 3; ++c) out[static_cast<std::size_t>(c)].values[i] = mean[c];
            out[3].values[i] = static_cast<float>(pixel.samples);
        }
    constexpr int kTile = 8;
    for (int y0 = 0; y0 < height; y0 += kTile)
        for (int x0 = 0; x0 < width; x0 += kTile) {
            const float sigma = static_cast<float>(tileError(
                film, {x0, y0, std::min(kTile, width - x0), std::min(kTile, height - y0)}));
            for (int y = y0; y < std::min(height, y0 + kTile); ++y)
                for (int x = x0; x < std::min(width, x0 + kTile); ++x)
                    out[4].values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x)] = sigma;
        }
    for (ExrChannel& channel : out) channels.push_back(std::move(channel));
}

}  // namespace glint
