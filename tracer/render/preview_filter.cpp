#include "tracer/render/preview_filter.h"

#include <algorithm>
#include <limits>

namespace glint {

namespace {

/// Surfaces darker than this are divided by it instead: their light is too dim to tell its colour.
constexpr float kLeastAlbedo = 0.02f;
constexpr float kInfinityF = std::numeric_limits<float>::infinity();
/// Where the last step leaves its light: prepare() and each step change sides.
constexpr int kFiltered = (PreviewFilter::kSteps + 1) % 2;

Rgb divisor(const GuideFilm::Pixel& guide) { return glm::max(guide.seenAlbedo, Rgb(kLeastAlbedo)); }

/// Variance of the mean's luminance, as the difference of the halves tells; below 0 if there is but
/// one.
float varianceOf(const FilmPixel& pixel, const Rgb& albedo) {
    if (pixel.samples < 2) return -1;
    const double countB = pixel.samples / 2, countA = pixel.samples - countB;
    const float half =
        0.5f * luminance(toFloat(pixel.sumA / countA - pixel.sumB / countB) / albedo);
    return half * half;
}

}  // namespace

void FilterPlane::resize(int width, int height) {
    pitch_ = (width + kLanes - 1) / kLanes * kLanes + 2 * kMargin;
    values_.assign(
        static_cast<std::size_t>(pitch_) * static_cast<std::size_t>(height + 2 * kMargin), 0.0f);
}

void PreviewFilter::load(const Film& film, const GuideFilm& guides, int y) {
    for (int x = 0; x < planes_.width; ++x) {
        const GuideFilm::Pixel& guide = guides.at(x, y);
        const FilmPixel pixel = film.at(x, y);
        const Rgb albedo = divisor(guide), light = pixel.mean() / albedo;
        for (int c = 0; c < 3; ++c) {
            planes_.light[0][c].row(y)[x] = light[c];
            planes_.normal[c].row(y)[x] = pixel.samples ? guide.seenNormal[c] : 0;
        }
        planes_.variance[0].row(y)[x] = varianceOf(pixel, albedo);
        planes_.nearness.row(y)[x] = guide.seenNearness;
    }
}

/// Light times albedo again, into the planes that the last step read from.
void PreviewFilter::remodulate(const GuideFilm& guides, int y) {
    for (int x = 0; x < planes_.width; ++x) {
        const Rgb albedo = divisor(guides.at(x, y));
        for (int c = 0; c < 3; ++c)
            planes_.light[1 - kFiltered][c].row(y)[x] =
                albedo[c] * planes_.light[kFiltered][c].row(y)[x];
    }
}

/// A pixel on an edge is like none of its neighbours and stays as noisy as it was. What it shows
/// lies between them, so it is kept to their range.
void PreviewFilter::store(int y, std::vector<Rgb>& out) const {
    constexpr float kNoisy = 0.25f;  // standard error over light
    const auto& radiance = planes_.light[1 - kFiltered];
    const auto at = [&](int px, int py) {
        return Rgb(radiance[0].row(py)[px], radiance[1].row(py)[px], radiance[2].row(py)[px]);
    };
    Rgb* row = out.data() + static_cast<std::ptrdiff_t>(y) * planes_.width;
    for (int x = 0; x < planes_.width; ++x) {
        row[x] = at(x, y);
        const auto& light = planes_.light[kFiltered];
        const float size =
            luminance(Rgb(light[0].row(y)[x], light[1].row(y)[x], light[2].row(y)[x]));
        if (planes_.variance[kFiltered].row(y)[x] <= kNoisy * kNoisy * size * size || x == 0 ||
            y == 0 || x + 1 == planes_.width || y + 1 == planes_.height)
            continue;
        Rgb low(kInfinityF), high(0.0f);
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                if (dx == 0 && dy == 0) continue;
                low = glm::min(low, at(x + dx, y + dy));
                high = glm::max(high, at(x + dx, y + dy));
            }
        row[x] = glm::clamp(row[x], low, high);
    }
}

bool PreviewFilter::run(const Film& film, const GuideFilm& guides, WorkerPool& pool,
                        const CancelToken& cancel, std::vector<Rgb>& out) {
    const int width = film.width(), height = film.height();
    if (width != planes_.width || height != planes_.height) {
        planes_.width = width;
        planes_.height = height;
        for (FilterPlane* plane :
             {&planes_.light[0][0], &planes_.light[0][1], &planes_.light[0][2],
              &planes_.light[1][0], &planes_.light[1][1], &planes_.light[1][2],
              &planes_.variance[0], &planes_.variance[1], &planes_.normal[0], &planes_.normal[1],
              &planes_.normal[2], &planes_.nearness, &planes_.slope[0], &planes_.slope[1]})
            plane->resize(width, height);
    }
    out.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::atomic<bool> complete{true};  // Only a flag, read when all workers have ended: relaxed.
    const auto eachRow = [&](auto&& work) {
        constexpr int kRows = 16;
        pool.run((height + kRows - 1) / kRows, [&](int, int band) {
            if (cancel.cancelled()) return complete.store(false, std::memory_order_relaxed);
            for (int y = band * kRows; y < std::min(height, (band + 1) * kRows); ++y) work(y);
        });
    };
    static const FilterLoops loops = filterLoops();
    eachRow([&](int y) { load(film, guides, y); });
    eachRow([&](int y) { loops.prepare(planes_, y); });
    for (int i = 0; i < kSteps; ++i)
        eachRow([&](int y) { loops.step(planes_, (i + 1) % 2, 1 << i, y); });
    eachRow([&](int y) { remodulate(guides, y); });
    eachRow([&](int y) { store(y, out); });
    return complete.load(std::memory_order_relaxed);
}

}  // namespace glint
