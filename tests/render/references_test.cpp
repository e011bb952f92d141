// Pictures against stored ones of another method: every sample drawn independently of all others,
// no path split, none left to chance, every light as likely to be chosen as any other, the power
// heuristic. Beside each scene of tests/render/references lie the mean of its reference and the
// variance of that mean, a number a pixel and channel. `GLINT_WRITE_REFERENCES=1 glint_tests_render
// --gtest_filter=References.*` makes them anew.
#include <gtest/gtest.h>

#include <cstdlib>
#include <future>

#include "tests/support/chi2.h"
#include "tests/support/paths.h"
#include "tests/support/scenes.h"
#include "tests/support/ztest.h"
#include "tracer/io/image_file.h"
#include "tracer/io/scene_json.h"
#include "tracer/render/kernel.h"
#include "tracer/render/path.h"

namespace glint {
namespace {

constexpr const char* kScenes[] = {"room", "glass", "lights"};

struct NoEffort : UsualEffort {
    static constexpr int kMostSplits = 0;
    static constexpr float kDim = 0, kDimBranch = 0;
};

std::filesystem::path fileOf(const std::string& scene, const std::string& ending) {
    return test::inSource("tests/render/references") / (scene + ending);
}

test::SceneBuilder sceneNamed(const std::string& name) {
    test::SceneBuilder b;
    const Result<Scene> loaded = loadScene(fileOf(name, ".json"));
    EXPECT_TRUE(loaded) << loaded.error().text();
    if (loaded) b.scene() = loaded.value();
    return b;
}

/// Mean and variance of that mean of one channel.
using Moments = std::array<test::RunningMoments, 3>;

/// Row `y` of a picture by plain Monte Carlo: the first sample under each of `samples` seeds.
std::vector<Moments> referenceRow(RenderScene scene, int y, int samples) {
    scene.lights.choice = LightChoice(
        std::vector<LightBounds>(scene.lights.lights.size(), {DVec3(0.0), kInfinity, 1}));
    KernelState state{scene, {}, {}, false};
    std::vector<Moments> row(static_cast<std::size_t>(scene.film.width));
    for (int s = 0; s < samples; ++s) {
        scene.settings.seed = 0x5eed0000 + s;
        for (int x = 0; x < scene.film.width; ++x) {
            const Sampler sampler = samplerFor(scene, x, y, 0);
            PathTracer<kAllFeatures, PowerHeuristic, NoEffort> tracer(state, sampler);
            const Rgb value =
                tracer.radiance(cameraRay<kAllFeatures>(scene, sampler, x, y, state.work));
            for (int c = 0; c < 3; ++c)
                row[static_cast<std::size_t>(x)][static_cast<std::size_t>(c)].add(
                    static_cast<double>(value[c]));
        }
    }
    return row;
}

void writeReference(const std::string& name) {
    constexpr int kSamples = 8192;
    const auto scene = sceneNamed(name).compile();
    Image mean{scene->film.width, scene->film.height, {}}, variance = mean;
    for (int y = 0; y < mean.height; y += 2) {
        auto other =
            std::async(std::launch::async, [&] { return referenceRow(*scene, y + 1, kSamples); });
        for (const auto& row : {referenceRow(*scene, y, kSamples), other.get()})
            for (const Moments& pixel : row)
                for (const test::RunningMoments& m : pixel) {
                    mean.rgb.push_back(static_cast<float>(m.mean()));
                    variance.rgb.push_back(static_cast<float>(m.varianceOfMean()));
                }
    }
    ASSERT_TRUE(saveLinear(fileOf(name, ".mean.exr"), mean, {}));
    ASSERT_TRUE(saveLinear(fileOf(name, ".variance.exr"), variance, {}));
}

std::vector<float> channelsOf(const std::filesystem::path& file) {
    const auto loaded = loadImage(file);
    EXPECT_TRUE(loaded) << loaded.error().text();
    return loaded ? loaded.value()->rgb : std::vector<float>();
}

struct Agreement {
    double inside = 0;  ///< share of channels of pixels that agree
    double global = 0;  ///< difference of the means, in standard errors
};

/// `factor`: what the picture is multiplied by before it is compared.
Agreement agreementWith(const std::string& name, const std::vector<Image>& renders, double factor) {
    const std::vector<float> mean = channelsOf(fileOf(name, ".mean.exr")),
                             variance = channelsOf(fileOf(name, ".variance.exr"));
    const double level = test::sidak(0.01, static_cast<int>(mean.size()));
    double inside = 0, difference = 0, spread = 0;
    for (std::size_t i = 0; i < mean.size(); ++i) {
        test::RunningMoments moments;
        for (const Image& image : renders) moments.add(factor * static_cast<double>(image.rgb[i]));
        const double expected = static_cast<double>(mean[i]),
                     both = moments.varianceOfMean() + static_cast<double>(variance[i]);
        inside += test::zTest(moments.mean(), both, expected, 1e-6 * expected) > level ? 1 : 0;
        difference += moments.mean() - expected;
        spread += both;
    }
    return {inside / static_cast<double>(mean.size()), difference / std::sqrt(spread)};
}

class References : public testing::TestWithParam<const char*> {};

TEST_P(References, PicturesAgreeWithPlainMonteCarlo) {  // T23
    if (std::getenv("GLINT_WRITE_REFERENCES")) writeReference(GetParam());
    constexpr int kSeeds = 32;
    test::SceneBuilder b = sceneNamed(GetParam());
    b.film(b.scene().film.width, b.scene().film.height, b.scene().render.spp);
    std::vector<Image> renders;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        b.scene().render.seed = seed;
        renders.push_back(b.render().beauty);
    }
    const Agreement found = agreementWith(GetParam(), renders, 1);
    std::printf("%s: %.2f %% of the channels inside, mean %.2f sigma off\n", GetParam(),
                100 * found.inside, found.global);
    EXPECT_GE(found.inside, 0.9975);
    EXPECT_LE(std::abs(found.global), 3);
    // The wrong twin: everything 1 % brighter.
    EXPECT_GT(std::abs(agreementWith(GetParam(), renders, 1.01).global), 3);
}

INSTANTIATE_TEST_SUITE_P(Stored, References, testing::ValuesIn(kScenes),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace glint
