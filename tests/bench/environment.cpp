#include "tests/bench/environment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "tests/bench/clock.h"
#include "tests/bench/output.h"
#include "tracer/compile/compiler.h"
#include "tracer/lights/environment_map.h"
#include "tracer/math/frame.h"
#include "tracer/math/sobol.h"
#include "tracer/math/statistics.h"

namespace glint::bench {

namespace {

struct EnvironmentOptions {
    std::vector<std::string> files;
    int samples = 64, seeds = 400;
    std::string json;
};

// ---- Drawing ----

/// Draws a texel in constant time (Walker 1974; table by Vose 1991), then a place in it. Its
/// density is constant over a texel.
class AliasMap {
  public:
    explicit AliasMap(const EnvironmentMap& map)
        : map_(map), width_(map.image()->width), height_(map.image()->height) {
        // The mean of the bilinear picture over each texel, which its own value alone would miss
        // beside a sun.
        constexpr std::array kTent = {0.125, 0.75, 0.125};
        std::vector<double> weights;
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) {
                double mean = 1e-9;
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx)
                        mean +=
                            kTent[static_cast<std::size_t>(dx + 1)] *
                            kTent[static_cast<std::size_t>(dy + 1)] *
                            texel((x + dx + width_) % width_, std::clamp(y + dy, 0, height_ - 1));
                weights.push_back(mean * bandArea(y));
            }
        double sum = 0;
        for (const double w : weights) sum += w;
        entries_.resize(weights.size());
        std::vector<std::uint32_t> small, large;
        std::vector<double> scaled;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            entries_[i].density =
                static_cast<float>(weights[i] / sum / bandArea(static_cast<int>(i) / width_));
            scaled.push_back(weights[i] / sum * static_cast<double>(weights.size()));
            (scaled[i] < 1 ? small : large).push_back(static_cast<std::uint32_t>(i));
        }
        while (!small.empty() && !large.empty()) {
            const std::uint32_t less = small.back(), more = large.back();
            small.pop_back();
            entries_[less] = {static_cast<float>(scaled[less]), more, entries_[less].density};
            scaled[more] -= 1 - scaled[less];
            if (scaled[more] < 1) {
                large.pop_back();
                small.push_back(more);
            }
        }
    }
    [[nodiscard]] EnvironmentSample sample(const Vec2& u) const {
        const double at = static_cast<double>(u.x) * static_cast<double>(entries_.size());
        auto texel = static_cast<std::uint32_t>(at);
        double rest = at - texel;
        if (const Entry& entry = entries_[texel]; rest < static_cast<double>(entry.keep)) {
            rest /= static_cast<double>(entry.keep);
        } else {
            rest = (rest - static_cast<double>(entry.keep)) / (1 - static_cast<double>(entry.keep));
            texel = entry.alias;
        }
        const int x = static_cast<int>(texel) % width_, y = static_cast<int>(texel) / width_;
        const double phi = 2 * kPi * ((x + rest) / width_ - 0.5), top = std::cos(kPi * y / height_),
                     bottom = std::cos(kPi * (y + 1) / height_);
        const double up = top + static_cast<double>(u.y) * (bottom - top),
                     around = std::sqrt(std::max(0.0, 1 - up * up));
        EnvironmentSample out;
        out.direction = {around * std::sin(phi), up, -around * std::cos(phi)};
        out.pdf = static_cast<double>(entries_[texel].density);
        out.radiance = map_.radiance(out.direction);
        return out;
    }

  private:
    struct Entry {
        float keep = 1;
        std::uint32_t alias = 0;
        float density = 0;  ///< per solid angle
    };
    [[nodiscard]] double texel(int x, int y) const {
        const float* rgb =
            &map_.image()->rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                    static_cast<std::size_t>(x))];
        return static_cast<double>(luminance(Rgb{rgb[0], rgb[1], rgb[2]}));
    }
    /// Solid angle of a texel of the row.
    [[nodiscard]] double bandArea(int y) const {
        return 2 * kPi / width_ * (std::cos(kPi * y / height_) - std::cos(kPi * (y + 1) / height_));
    }

    const EnvironmentMap& map_;
    int width_, height_;
    std::vector<Entry> entries_;
};

/// Irradiance of a surface facing `normal`, from stratified samples.
template <class Map>
double irradiance(const Map& map, const DVec3& normal, int samples, std::uint32_t seed) {
    double sum = 0;
    for (int s = 0; s < samples; ++s) {
        const SampleBlock u = Sampler(seed, 0, static_cast<std::uint32_t>(s)).block(0);
        const EnvironmentSample sample = map.sample({u.x, u.y});
        if (sample.pdf > 0)
            sum += static_cast<double>(luminance(sample.radiance)) *
                   std::max(0.0, glm::dot(sample.direction, normal)) / sample.pdf;
    }
    return sum / samples;
}

/// Nanoseconds of a sample, and the relative error of the irradiance of six faces of a cube.
struct Figures {
    double nanoseconds = 0, error = 0;
};
template <class Map>
Figures measure(const Map& map, const EnvironmentOptions& options) {
    constexpr int kReference = 1 << 20;
    Figures out;
    double squares = 0;
    int count = 0;
    const Stopwatch watch;
    double reference = 0;
    for (int face = 0; face < 6; ++face) {
        DVec3 normal(0.0);
        normal[face % 3] = face < 3 ? 1 : -1;
        const double exact = irradiance(map, normal, kReference, 0);
        reference += exact;
        for (int seed = 1; seed <= options.seeds; ++seed, ++count) {
            const double error =
                irradiance(map, normal, options.samples, static_cast<std::uint32_t>(seed)) - exact;
            squares += error * error;
        }
    }
    out.nanoseconds = 1e9 * watch.threadSeconds() /
                      (6.0 * (kReference + static_cast<double>(options.seeds) * options.samples));
    out.error = std::sqrt(squares / count) / (reference / 6);
    return out;
}

// ---- Sharing with the surface's own directions ----

/// A sky of 1 with one texel of 1e5 as its sun (NUMERICS P11).
std::shared_ptr<const Image> skyWithSun() {
    auto image = std::make_shared<Image>(Image{512, 256, std::vector<float>(3 * 512 * 256, 1.0f)});
    std::fill_n(image->rgb.begin() + 3 * (70 * 512 + 200), 3, 1e5f);
    return image;
}

/// Irradiance of a surface facing `normal`, from as many samples of the map (null: none) as of the
/// surface's own cosine, shared by the balance heuristic.
double sharedIrradiance(const EnvironmentMap* drawn, const EnvironmentMap& seen, const Frame& frame,
                        int samples, std::uint32_t seed) {
    double sum = 0;
    const auto cosinePdf = [&](const DVec3& d) {
        return std::max(0.0, glm::dot(d, frame.n)) / kPi;
    };
    const auto add = [&](const DVec3& d, double density) {
        const double cosine = glm::dot(d, frame.n);
        if (cosine > 0 && density > 0)
            sum += static_cast<double>(luminance(seen.radiance(d))) * cosine / density;
    };
    const auto density = [&](const DVec3& d) {
        return cosinePdf(d) + (drawn ? drawn->pdf(d) : 0.0);
    };
    for (int s = 0; s < samples; ++s) {
        const auto [u, v] = Sampler(seed, 0, static_cast<std::uint32_t>(s)).blocks(0, 1);
        const DVec3 own = frame.toWorld(cosineHemisphere({u.x, u.y}));
        add(own, density(own));
        if (!drawn) continue;
        const EnvironmentSample sample = drawn->sample({v.x, v.y});
        if (sample.pdf > 0) add(sample.direction, density(sample.direction));
    }
    return sum / samples;
}

/// relMSE of the three ways, for surfaces that face all ways up.
void measureSharing(const EnvironmentOptions& options, Json& json) {
    const auto image = skyWithSun();
    const EnvironmentMap plain(image, EnvironmentMap::Density::Plain),
        compensated(image, EnvironmentMap::Density::Compensated);
    constexpr int kNormals = 32, kReference = 1 << 16;
    double errors[3] = {};
    for (int i = 0; i < kNormals; ++i) {
        const double up = (i + 0.5) / kNormals, around = std::sqrt(1 - up * up), phi = 2.4 * i;
        const Frame frame(DVec3(around * std::cos(phi), up, around * std::sin(phi)));
        const double exact = sharedIrradiance(&compensated, plain, frame, kReference, 0);
        const EnvironmentMap* ways[] = {nullptr, &plain, &compensated};
        for (std::size_t way = 0; way < 3; ++way)
            for (int seed = 1; seed <= options.seeds; ++seed)
                errors[way] += std::pow(sharedIrradiance(ways[way], plain, frame, options.samples,
                                                         static_cast<std::uint32_t>(seed)) /
                                                exact -
                                            1,
                                        2) /
                               (kNormals * options.seeds);
    }
    std::printf(
        "\nA sky of 1 with a texel of 1e5, %d samples, relMSE: the surface's own directions %.2e, "
        "shared with the picture's %.2e, with what it has above its mean %.2e\n",
        options.samples, errors[0], errors[1], errors[2]);
    json = {{"own_directions", errors[0]}, {"plain", errors[1]}, {"compensated", errors[2]}};
}

int runEnvironment(const EnvironmentOptions& options) {
    if (!canWrite(options.json)) return kCannotWrite;
    Table table({"environment", "way", "ns a sample",
                 format("error of %d samples", options.samples), "efficiency to the alias table"});
    Json json{{"drawing", Json::array()}};
    AssetCache assets;
    for (const std::string& file : options.files) {
        int loads = 0;
        const auto image = assets.image(file, ColorSpace::Auto, loads);
        if (!image) return complain(image.error(), kBadScene);
        const EnvironmentMap built(image.value(), EnvironmentMap::Density::Plain);
        const Figures alias = measure(AliasMap(built), options), ours = measure(built, options);
        const std::string name = std::filesystem::path(file).stem().string();
        const double gain = alias.error * alias.error * alias.nanoseconds /
                            (ours.error * ours.error * ours.nanoseconds);
        table.add({name, "alias table", format("%.0f", alias.nanoseconds),
                   format("%.2f %%", 100 * alias.error), ""});
        table.add({name, "2-D distribution", format("%.0f", ours.nanoseconds),
                   format("%.2f %%", 100 * ours.error), format("%.2f", gain)});
        json["drawing"].push_back({{"environment", name},
                                   {"alias_ns", alias.nanoseconds},
                                   {"alias_error", alias.error},
                                   {"distribution_ns", ours.nanoseconds},
                                   {"distribution_error", ours.error},
                                   {"gain", gain}});
    }
    std::printf("%s", table.markdown().c_str());
    measureSharing(options, json["sharing"]);
    return writeJson(options.json, json) ? kOk : kCannotWrite;
}

}  // namespace

Command environmentCommand(CLI::App& root) {
    auto options = std::make_shared<EnvironmentOptions>();
    CLI::App* app = root.add_subcommand(
        "environment",
        "How directions of an environment are drawn: the built 2-D distribution against an alias "
        "table, by the irradiance of a cube's faces; and how they share with a surface's own");
    app->add_option("FILES", options->files, "Pictures of environments")
        ->required()
        ->check(CLI::ExistingFile);
    app->add_option("--samples", options->samples, "Stratified samples of one irradiance")
        ->check(CLI::Range(1, 1 << 20))
        ->capture_default_str();
    app->add_option("--seeds", options->seeds, "Times that each is found")
        ->check(CLI::Range(2, 1 << 20))
        ->capture_default_str();
    app->add_option("--json", options->json, "Write the figures to this file as JSON");
    return {app, [options] { return runEnvironment(*options); }};
}

}  // namespace glint::bench
