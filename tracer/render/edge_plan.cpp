#include "tracer/render/edge_plan.h"

#include <algorithm>

namespace glint {

namespace {

/// Differences below this share of the brightness are no edges (measured on tests/bench/scenes/classic: half of it doubles the
/// time of smooth parts and gains nothing, twice of it leaves steps).
constexpr float kVisible = 0.02f;
/// Pixels: edges farther away than the neighbours are not looked for.
constexpr double kWidestFilter = 1.5;
/// Darker than this share of the picture's mean, differences count as if it were so bright.
constexpr float kDark = 0.1f;

/// The film's means within a rectangle, with a way to ask beyond its border.
class Means {
  public:
    Means(const Film& film, const PixelRect& rect) : film_(film), rect_(rect) {
        DVec3 sum(0.0);
        values_.reserve(static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height));
        for (int y = 0; y < rect.height; ++y)
            for (int x = 0; x < rect.width; ++x) {
                values_.push_back(film.at(rect.x + x, rect.y + y).mean());
                sum += toDouble(values_.back());
            }
        floor_ = kDark * static_cast<float>(maxComponent(sum) / static_cast<double>(std::max<std::size_t>(1, values_.size())));
    }

    [[nodiscard]] bool isOnEdge(int x, int y) const {
        const FilmPixel pixel = film_.at(rect_.x + x, rect_.y + y);
        const double half = 0.5 * pixel.samples;
        if (isVisible(toFloat(pixel.sumA / half) - toFloat(pixel.sumB / half), at(x, y))) return true;
        constexpr int kWays[4][2] = {{1, 0}, {0, 1}, {1, 1}, {1, -1}};
        return std::ranges::any_of(kWays, [&](const auto& way) {
            const Rgb *before = find(x - way[0], y - way[1]), *after = find(x + way[0], y + way[1]);
            if (before && after) return isVisible(*before + *after - 2.0f * at(x, y), at(x, y));
            return false;
        });
    }

  private:
    [[nodiscard]] const Rgb& at(int x, int y) const { return values_[static_cast<std::size_t>(y) * static_cast<std::size_t>(rect_.width) + static_cast<std::size_t>(x)]; }
    [[nodiscard]] const Rgb* find(int x, int y) const { return x >= 0 && y >= 0 && x < rect_.width && y < rect_.height ? &at(x, y) : nullptr; }
    [[nodiscard]] bool isVisible(const Rgb& difference, const Rgb& value) const {
        for (int c = 0; c < 3; ++c)
            if (std::abs(difference[c]) > kVisible * (value[c] + floor_)) return true;
        return false;
    }

    const Film& film_;
    const PixelRect& rect_;
    std::vector<Rgb> values_;
    float floor_ = 0;
};

}  // namespace

bool isPiecewiseSmooth(const RenderScene& scene) {
    const auto lacks = [&](Feature feature) { return !has(scene.features, feature); };
    return scene.settings.integrator == Integrator::Classic && scene.film.filterRadius <= kWidestFilter && lacks(Feature::AreaLights) &&
           lacks(Feature::Lens) && scene.lights.sunDiscs.empty() && scene.settings.clamp == 0;
}

std::vector<std::uint32_t> edgeGoals(const Film& film, const PixelRect& rect, const std::vector<std::uint8_t>& chances, std::uint32_t spp) {
    std::vector<std::uint32_t> goals(static_cast<std::size_t>(film.width()) * static_cast<std::size_t>(film.height()));
    std::uint32_t most = 0;
    for (int y = rect.y; y < rect.y + rect.height; ++y)
        for (int x = rect.x; x < rect.x + rect.width; ++x) most = std::max(most, film.samples(x, y));
    const bool uniform = most < std::min(kFewSamples, spp);
    const std::uint32_t next = std::min(spp, most == 0 ? 1 : 2 * most);
    const Means means(film, rect);
    for (int y = 0; y < rect.height; ++y)
        for (int x = 0; x < rect.width; ++x) {
            const std::uint32_t now = film.samples(rect.x + x, rect.y + y);
            const std::size_t pixel = static_cast<std::size_t>(rect.y + y) * static_cast<std::size_t>(film.width()) + static_cast<std::size_t>(rect.x + x);
            goals[pixel] = uniform || (now == most && (chances[pixel] || means.isOnEdge(x, y))) ? next : now;
        }
    return goals;
}

}  // namespace glint
