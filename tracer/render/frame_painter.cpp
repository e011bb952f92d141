#include "tracer/render/frame_painter.h"

#include <algorithm>

#include "tracer/color/false_color.h"

namespace glint {

namespace {

constexpr int kBandRows = 16;  ///< rows that a worker takes at a time; whole tiles of the error

/// 8-bit numbers as they are, without exposure or transfer curve: values in [0, 1].
std::uint32_t plainColor(const Vec3& value) {
    std::uint32_t out = 0xff;
    for (int c = 0; c < 3; ++c)
        out = out << 8 | static_cast<std::uint32_t>(std::clamp(value[c], 0.0f, 1.0f) * 255 + 0.5f);
    return out;
}

bool isSurfaceChannel(Channel channel) {
    return channel >= Channel::Albedo && channel <= Channel::Material;
}

/// Smallest and largest value of `valueOf(guide)` where something was hit.
template <class ValueOf>
Legend rangeOf(const GuideFilm& guides, int width, int height, int stride, ValueOf valueOf) {
    Legend out{kInfinity, -kInfinity, false};
    for (int y = 0; y < height; y += stride)
        for (int x = 0; x < width; x += stride) {
            const GuideFilm::Pixel& guide = guides.at(x, y);
            if (guide.object == 0) continue;
            const auto value = static_cast<double>(valueOf(guide));
            out.low = std::min(out.low, value);
            out.high = std::max(out.high, value);
        }
    return out.low > out.high ? Legend{0, 1, false} : out;
}

/// From the nearest surface to the depth that nineteen of twenty pixels stay below: one horizon
/// would leave the rest a single colour.
Legend depthScale(const GuideFilm& guides, int width, int height, int stride) {
    constexpr double kShare = 0.95;
    std::vector<float> depths;
    for (int y = 0; y < height; y += std::max(stride, 4))
        for (int x = 0; x < width; x += std::max(stride, 4))
            if (const GuideFilm::Pixel& guide = guides.at(x, y); guide.object != 0)
                depths.push_back(guide.depth);
    if (depths.empty()) return {0, 1, false};
    const auto last = depths.begin() +
                      static_cast<std::ptrdiff_t>(kShare * static_cast<double>(depths.size() - 1));
    std::nth_element(depths.begin(), last, depths.end());
    const double low = static_cast<double>(*std::min_element(depths.begin(), last + 1));
    return {low, static_cast<double>(*last), low > 0};
}

float placeOn(const Legend& legend, float value) {
    const auto scaled = [&](double v) { return legend.logarithmic ? std::log2(v) : v; };
    const double low = scaled(legend.low), high = scaled(legend.high);
    return high > low
               ? static_cast<float>((scaled(static_cast<double>(value)) - low) / (high - low))
               : 0.0f;
}

}  // namespace

template <class PaintRow>
bool FramePainter::eachRow(const Film& film, int stride, PaintRow&& paintRow, Painting& out) {
    const int width = film.width(), height = film.height(), rows = std::max(kBandRows, stride);
    out.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const auto rowOf = [&](int y) {
        return std::span(out.pixels)
            .subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(width),
                     static_cast<std::size_t>(width));
    };
    std::atomic<bool> complete{true};  // Only a flag, read when all workers have ended: relaxed.
    pool_.run((height + rows - 1) / rows, [&](int, int band) {
        if (cancel_.cancelled()) return complete.store(false, std::memory_order_relaxed);
        const int end = std::min(height, (band + 1) * rows);
        for (int y = band * rows; y < end; y += stride) {
            paintRow(y, rowOf(y));
            for (int copy = y + 1; copy < std::min(end, y + stride); ++copy)
                std::ranges::copy(rowOf(y), rowOf(copy).begin());
        }
    });
    return complete.load(std::memory_order_relaxed);
}

template <class Color>
bool FramePainter::eachPixel(const Film& film, Color&& color, Painting& out) {
    return eachBlock(film, 1, color, out);
}

template <class Color>
bool FramePainter::eachBlock(const Film& film, int stride, Color&& color, Painting& out) {
    return eachRow(
        film, stride,
        [&](int y, std::span<std::uint32_t> row) {
            for (int x = 0; x < film.width(); x += stride)
                std::fill(row.begin() + x, row.begin() + std::min(x + stride, film.width()),
                          color(x, y));
        },
        out);
}

bool FramePainter::paint(const std::shared_ptr<const RenderScene>& scene, const Film& film,
                         const Backdrop* backdrop, int stride, const TileErrors& errors,
                         const PaintSettings& settings, const CancelToken& cancel, Painting& out) {
    cancel_ = cancel;
    out.isRough = false;
    const bool filters = settings.filtered && settings.channel == Channel::Beauty && stride == 1 &&
                         !film.remembers();
    if (filters || isSurfaceChannel(settings.channel)) {
        // The first look is a quick one.
        const std::uint32_t known = guides_.samplesOf(scene, film.width(), film.height()),
                            samples = stride == 1 && known > 0 ? GuideFilm::kSamples : 1;
        if (!guides_.refine(scene, film.width(), film.height(), stride, samples, cancel, pool_))
            return false;
        out.isRough = stride == 1 && samples < GuideFilm::kSamples;
    }
    const Painting::Base base{settings.channel == Channel::Beauty ? film.retrace() : 0, film.mix(),
                              settings.display};
    const bool stays = base.retrace != 0 && out.base == base;
    out.base = {};
    out.channel = settings.channel;
    out.filtered = filters;
    out.legend.reset();
    out.errors = errors;
    const int mask = ~(stride - 1);
    out.probe.reset();
    if (const auto& at = settings.probe; at && std::min((*at)[0], (*at)[1]) >= 0 &&
                                         (*at)[0] < film.width() && (*at)[1] < film.height())
        out.probe = {*at, shownAt(film, backdrop, mask, (*at)[0], (*at)[1])};
    if (isSurfaceChannel(settings.channel)) return paintSurfaces(film, mask, out);
    if (settings.channel != Channel::Beauty) return paintScale(film, backdrop, mask, settings, out);
    const DisplayTransform transform(settings.display);
    if (!filters) {
        if (!paintBeauty(film, backdrop, mask, stays, transform, out)) return false;
        out.base = base;
        return true;
    }
    if (!filter_.run(film, guides_, pool_, cancel, filteredLight_)) return false;
    const auto width = static_cast<std::size_t>(film.width());
    return eachRow(
        film, 1,
        [&](int y, std::span<std::uint32_t> row) {
            transform.apply(
                std::span(filteredLight_).subspan(static_cast<std::size_t>(y) * width, width), row);
        },
        out);
}

bool FramePainter::paintBeauty(const Film& film, const Backdrop* backdrop, int mask,
                               bool untouchedStay, const DisplayTransform& transform,
                               Painting& out) {
    if (backdrop)
        return eachPixel(
            film,
            [&](int x, int y) { return transform.apply(shownAt(film, backdrop, mask, x, y)); },
            out);
    if (film.remembers())
        return eachRow(
            film, 1,
            [&](int y, std::span<std::uint32_t> row) {
                std::optional<std::uint32_t>
                    grid;  // The colour of all of a block's pixels that wait for their sample.
                for (int x = 0; x < film.width(); ++x) {
                    if ((x & ~mask) == 0)
                        grid = film.isAnew(x, y & mask)
                                   ? std::optional(transform.apply(film.at(x, y & mask).mean()))
                                   : std::nullopt;
                    if (untouchedStay && film.isUntouched(x, y)) continue;
                    row[static_cast<std::size_t>(x)] =
                        grid && film.samples(x, y) == 0
                            ? *grid
                            : transform.apply(shownAt(film, nullptr, mask, x, y));
                }
            },
            out);
    if (mask != -1)
        return eachBlock(
            film, -mask, [&](int x, int y) { return transform.apply(film.at(x, y).mean()); }, out);
    return eachRow(
        film, 1,
        [&](int y, std::span<std::uint32_t> row) {
            std::array<Rgb, Film::kTile> means;
            for (std::size_t x = 0; x < row.size(); x += means.size()) {
                const std::span part =
                    std::span(means).first(std::min(means.size(), row.size() - x));
                film.means(static_cast<int>(x), y, part);
                transform.apply(part, row.subspan(x, part.size()));
            }
        },
        out);
}

bool FramePainter::paintSurfaces(const Film& film, int mask, Painting& out) {
    const int width = film.width(), height = film.height(), stride = -mask;
    const auto paintGuides = [&](auto color) {
        return eachPixel(
            film, [&](int x, int y) { return color(guides_.at(x & mask, y & mask)); }, out);
    };
    switch (out.channel) {
        case Channel::Albedo:
            return paintGuides([](const GuideFilm::Pixel& g) {
                return plainColor({srgbFromLinear(g.albedo.x), srgbFromLinear(g.albedo.y),
                                   srgbFromLinear(g.albedo.z)});
            });
        case Channel::Normal:
            return paintGuides([](const GuideFilm::Pixel& g) {
                return g.object ? plainColor(g.normal * 0.5f + 0.5f) : idColor(0);
            });
        case Channel::Object:
            return paintGuides([](const GuideFilm::Pixel& g) { return idColor(g.object); });
        case Channel::Material:
            return paintGuides([](const GuideFilm::Pixel& g) { return idColor(g.material); });
        case Channel::Depth: {
            const Legend legend = depthScale(guides_, width, height, stride);
            out.legend = legend;
            return paintGuides([legend](const GuideFilm::Pixel& g) {
                return g.object ? falseColor(1 - placeOn(legend, g.depth)) : idColor(0);
            });
        }
        default:
            break;
    }
    // Position: each axis from the least to the largest value in view.
    std::array<Legend, 3> axes;
    for (int c = 0; c < 3; ++c)
        axes[static_cast<std::size_t>(c)] =
            rangeOf(guides_, width, height, stride,
                    [c](const GuideFilm::Pixel& g) { return g.position[c]; });
    return paintGuides([axes](const GuideFilm::Pixel& g) {
        return g.object
                   ? plainColor({placeOn(axes[0], g.position.x), placeOn(axes[1], g.position.y),
                                 placeOn(axes[2], g.position.z)})
                   : idColor(0);
    });
}

bool FramePainter::paintErrors(const Film& film, Painting& out) {
    out.legend = Legend{0.001, 1, true};
    return eachPixel(
        film,
        [&](int x, int y) {
            const auto bound = out.errors.at(x, y);
            return bound ? falseColor(placeOn(*out.legend, *bound))
                         : idColor(0);  // A tile without a second sample says nothing.
        },
        out);
}

bool FramePainter::paintScale(const Film& film, const Backdrop* backdrop, int mask,
                              const PaintSettings& settings, Painting& out) {
    const auto paint = [&](const Legend& legend, auto valueOf) {
        out.legend = legend;
        return eachPixel(
            film, [&, legend](int x, int y) { return falseColor(placeOn(legend, valueOf(x, y))); },
            out);
    };
    if (out.channel == Channel::Samples) {
        // As the picture: while it is coarse, the grid's pixels stand for those between.
        const auto samplesAt = [&](int x, int y) {
            const std::uint32_t own = film.samples(x, y);
            return own ? own : film.samples(x & mask, y & mask);
        };
        std::uint32_t most = 1;
        for (int y = 0; y < film.height(); ++y)
            for (int x = 0; x < film.width(); ++x) most = std::max(most, film.samples(x, y));
        return paint({0, static_cast<double>(most), false},
                     [&](int x, int y) { return static_cast<float>(samplesAt(x, y)); });
    }
    if (out.channel == Channel::Error) return paintErrors(film, out);
    // Luminance in stops over or under middle grey, which is 18 % of white, as exposed.
    constexpr double kStops = 6, kMiddleGrey = 0.18;
    const float scale = static_cast<float>(std::exp2(settings.display.exposureEv) / kMiddleGrey);
    return paint({-kStops, kStops, false}, [&](int x, int y) {
        return std::log2(std::max(luminance(shownAt(film, backdrop, mask, x, y)) * scale, 1e-30f));
    });
}

}  // namespace glint
