#include "tracer/render/bands.h"

#include <algorithm>
#include <cmath>

#include "tracer/render/adaptive.h"
#include "tracer/render/film.h"
#include "tracer/render/outlines.h"
#include "tracer/render/stop_rule.h"

namespace glint {

namespace {

PixelRect rectOf(const RenderScene& scene, const RenderRequest& request) {
    return request.crop.value_or(PixelRect{0, 0, scene.film.width, scene.film.height});
}

/// Time and error are rules for a whole picture; layers, alpha and the filter need its whole film.
bool canBeInBands(const RenderScene& scene, const RenderRequest& request) {
    const bool byNumber = scene.settings.timeSeconds <= 0 && !samplesAdaptively(scene.settings);
    return byNumber && !request.layers && !request.alpha && !request.filter;
}

std::string gigabytes(double bytes) {
    return std::to_string(static_cast<std::int64_t>(std::ceil(bytes / 1e9))) + " GB";
}

/// Adds what a band found to the whole. `light` and `squares` collect the mean luminance and the
/// squared error, over pixels.
struct Whole {
    Rendering rendering;
    double light = 0, squares = 0, pixels = 0;

    void add(const Rendering& band, const PixelRect& rect, const Image& picture) {
        const bool first = pixels == 0;
        const double n = static_cast<double>(rect.width) * rect.height;
        double sum = 0;
        for (int y = rect.y; y < rect.y + rect.height; ++y)
            for (int x = rect.x; x < rect.x + rect.width; ++x) {
                const std::size_t i =
                    3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                         static_cast<std::size_t>(x));
                sum += static_cast<double>(
                    luminance(Rgb(picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2])));
            }
        const double error = band.error < kInfinity ? band.error * sum / n : kInfinity;
        pixels += n, light += sum, squares += error * error * n;
        rendering.spp = first ? band.spp : std::min(rendering.spp, band.spp);
        rendering.even = rendering.even && band.even && (first || band.spp == rendering.spp);
        rendering.threads = band.threads;
        rendering.seconds += band.seconds;
        rendering.rays += band.rays;
        rendering.work += band.work;
        rendering.kernel = band.kernel;
        rendering.nonfiniteSamples += band.nonfiniteSamples;
        if (!rendering.firstNonfinite) rendering.firstNonfinite = band.firstNonfinite;
        rendering.interrupted = rendering.interrupted || band.interrupted;
    }
};

}  // namespace

Result<int> rowsAtOnce(const RenderScene& scene, const RenderRequest& request, double bytes) {
    const PixelRect rect = rectOf(scene, request);
    // The picture, and its planes or bytes for the file; of the part that is rendered, the film;
    // layers and goals are as large as the picture.
    constexpr double kPicture = 2 * 3 * sizeof(float), kFilm = Film::kBytesAPixel, kLayers = 300;
    const int cell = adaptiveRule(scene.settings.integrator).cell;
    const double goals =
        samplesAdaptively(scene.settings)
            ? kBytesACell / (cell * cell) + (Outlines::suit(scene) ? Outlines::kBytesAPixel : 0)
            : 0;
    const double picture =
        (kPicture + (request.layers ? kLayers : 0) + goals) * scene.film.width * scene.film.height;
    const double row = kFilm * rect.width, whole = picture + row * rect.height;
    if (whole <= bytes) return rect.height;
    const bool inBands = canBeInBands(scene, request);
    // Few rows at a time keep neither threads busy nor passes long.
    const double least = inBands ? picture + row * std::min(rect.height, 4 * Film::kTile) : whole;
    if (least <= bytes)
        return static_cast<int>((bytes - picture) / row) / Film::kTile * Film::kTile;
    std::string remedy = "render it smaller";
    if (!inBands && request.layers)
        remedy += ", or without layers";
    else if (!inBands)
        remedy +=
            ", or by number of samples alone, without alpha and filter: then it is rendered in "
            "bands";
    return Error{.message = "a picture of " + std::to_string(scene.film.width) + " x " +
                            std::to_string(scene.film.height) + " pixels needs " +
                            gigabytes(least) + " of memory; " + gigabytes(bytes) + " are free",
                 .pointer = "/film",
                 .remedy = remedy};
}

Rendering renderInBands(const RenderScene& scene, const RenderRequest& request, int rows,
                        const std::function<Rendering(const RenderRequest&, Image&)>& renderPart) {
    const PixelRect rect = rectOf(scene, request);
    Image picture{scene.film.width, scene.film.height, {}};
    picture.rgb.resize(3 * static_cast<std::size_t>(picture.width) *
                       static_cast<std::size_t>(picture.height));
    Whole whole;
    int y = 0;
    for (; y < rect.height && !whole.rendering.interrupted; y += rows) {
        const PixelRect band{rect.x, rect.y + y, rect.width, std::min(rows, rect.height - y)};
        RenderRequest part = request;
        part.crop = band;
        const double before = whole.rendering.seconds, done = static_cast<double>(y) / rect.height,
                     share = static_cast<double>(band.height) / rect.height;
        if (request.progress)
            part.progress = [&, before, done, share](RenderProgress p) {
                p.fraction = done + share * p.fraction;
                p.seconds += before;
                p.remainingSeconds = p.fraction > 0 ? p.seconds / p.fraction - p.seconds : 0;
                request.progress(p);
            };
        whole.add(renderPart(part, picture), band, picture);
    }
    if (y < rect.height)
        whole.rendering.spp = 0, whole.rendering.even = false;  // The other bands have no sample.
    whole.rendering.error =
        whole.squares == 0 ? 0
                           : std::sqrt(whole.squares / whole.pixels) / (whole.light / whole.pixels);
    whole.rendering.beauty = std::move(picture);
    return std::move(whole.rendering);
}

}  // namespace glint
