// The film keeps its accuracy over millions of samples, also beside one that is a million times
// brighter.
#include <gtest/gtest.h>

#include "tests/support/rays.h"
#include "tracer/render/film.h"

namespace glint {
namespace {

/// The same sums in float: the wrong twin, which the bar must reject.
struct FloatPixel {
    Rgb sum{0.0f};
    std::uint32_t samples = 0;
    void add(const Rgb& value) {
        sum += value;
        ++samples;
    }
    [[nodiscard]] Rgb mean() const { return sum / static_cast<float>(samples); }
};

/// A film of one pixel.
struct OnePixelFilm {
    Film film{1, 1};
    void add(const Rgb& value) { film.add(0, 0, value, {}, 0); }
    [[nodiscard]] Rgb mean() const { return film.at(0, 0).mean(); }
};

constexpr int kSamples = 20'000'000;
constexpr double kUnit = 0x1p-26, kSpike = 1e5;

struct Means {
    Rgb found{0.0f};
    double exact = 0;  ///< of red; green is 3/4 and blue 1/4 of it
    [[nodiscard]] double error(int channel) const {
        constexpr double kShare[3] = {1, 0.75, 0.25};
        return std::abs(found[channel] / (exact * kShare[channel]) - 1);
    }
};

/// Adds samples of mean 0.1 and, after a third of them, one spike. All are whole multiples of
/// kUnit, so that their sum is known exactly.
template <class Pixel>
Means accumulate() {
    Pixel pixel;
    test::Random random(1);
    std::uint64_t sum = 0;
    for (int i = 0; i < kSamples; ++i) {
        // k is below 2^22 and has the mean 0.1 / (4 kUnit).
        const bool spike = i == kSamples / 3;
        const std::uint64_t k = spike ? static_cast<std::uint64_t>(kSpike / (4 * kUnit))
                                      : (std::uint64_t{random.next()} * 3'355'443) >> 32;
        sum += k;
        const double unit = static_cast<double>(k) * kUnit;
        pixel.add(toFloat(DVec3(4 * unit, 3 * unit, unit)));
    }
    return {pixel.mean(), 4 * kUnit * static_cast<double>(sum) / kSamples};
}

TEST(Film, SumsTwentyMillionSamplesAndASpike) {  // T24
    const Means means = accumulate<OnePixelFilm>();
    EXPECT_NEAR(means.exact, 0.1 + kSpike / kSamples, 1e-4);
    for (int c = 0; c < 3; ++c) EXPECT_LE(means.error(c), 1e-6) << "channel " << c;
    // No shift of hue: the channels' ratios are those of the samples, to the rounding of the mean.
    EXPECT_NEAR(means.found.y / means.found.x, 0.75, 1e-7);
    EXPECT_NEAR(means.found.z / means.found.x, 0.25, 1e-7);
}

TEST(Film, SumsInFloatWouldFail) {
    const Means means = accumulate<FloatPixel>();
    EXPECT_GT(means.error(0), 1e-6);
    EXPECT_GT(std::abs(means.found.y / means.found.x - 0.75), 1e-7);
}

}  // namespace
}  // namespace glint
