#include "tests/support/scenes.h"
#include "tests/support/paths.h"

#include <cmath>
#include <cstdlib>

namespace glint::test {

SceneBuilder::SceneBuilder() {
    scene_.film.width = scene_.film.height = 32;
    scene_.render.maxDepth = 16;
    scene_.render.spp = 64;
}

ObjectId SceneBuilder::object(const Shape& shape, MaterialId material, const DVec3& at,
                              const Color& emission) {
    Object object;
    object.name = "Object " + std::to_string(scene_.objects.size() + 1);
    object.shape = shape;
    object.material = material;
    object.transform.translate = at;
    object.emission = emission;
    return scene_.objects.add(std::move(object));
}

void SceneBuilder::pointLight(const DVec3& at, const Color& intensity) {
    scene_.lights.add(
        {"Light " + std::to_string(scene_.lights.size() + 1), PointLight{at, intensity}, true, ""});
}

void SceneBuilder::camera(const DVec3& from, const DVec3& to, double fovDegrees) {
    scene_.camera.position = from;
    scene_.camera.target = to;
    scene_.camera.verticalFovDegrees = fovDegrees;
    const DVec3 axis = glm::normalize(to - from);
    scene_.camera.up = std::abs(axis.y) > 0.9 ? DVec3(0, 0, -1) : DVec3(0, 1, 0);
}

void SceneBuilder::film(int width, int height, int spp) {
    scene_.film.width = width;
    scene_.film.height = height;
    scene_.render.spp = fullRun() ? 16 * spp : spp;
}

std::shared_ptr<const RenderScene> SceneBuilder::compile() const {
    AssetCache assets;
    auto compiled = glint::compile(scene_, inSource("scenes"), assets);
    EXPECT_TRUE(compiled.ok());
    return compiled.value().scene;
}

Rendering SceneBuilder::render(int threads) const {
    Rendering out = glint::render(compile(), {.threads = threads});
    EXPECT_EQ(out.nonfiniteSamples, 0u);
    return out;
}

Estimate estimateMean(const Image& image, int channel) {
    const auto count =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double v = image.rgb[3 * i + static_cast<std::size_t>(channel)];
        sum += v;
        squares += v * v;
    }
    const double n = static_cast<double>(count), mean = sum / n;
    return {mean, std::sqrt(std::max(0.0, squares / n - mean * mean) / (n - 1))};
}

PixelEstimates estimatePixels(SceneBuilder builder, int seeds) {
    PixelEstimates out;
    std::vector<double> sums, squares;
    for (int seed = 1; seed <= seeds; ++seed) {
        builder.scene().render.seed = seed;
        const Image image = builder.render().beauty;
        out.width = image.width;
        out.height = image.height;
        const std::size_t count = image.rgb.size() / 3;
        sums.resize(count);
        squares.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const double v = image.rgb[3 * i];
            sums[i] += v;
            squares[i] += v * v;
        }
    }
    const double n = seeds;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const double mean = sums[i] / n;
        out.pixels.push_back(
            {mean, std::sqrt(std::max(0.0, squares[i] / n - mean * mean) / (n - 1))});
    }
    return out;
}

namespace {

/// What the |z| of `pixels` pixels stay below at alpha = 1e-3 for all: the tail of Student's t with
/// that many degrees of freedom from the normal bound (Hill 1970, first terms).
double pixelBound(std::size_t pixels, double freedom) {
    const double alpha = 1e-3 / static_cast<double>(pixels);
    const double z = std::sqrt(-2 * std::log(alpha / 2));
    return z + (z * z * z + z) / (4 * freedom) +
           (5 * std::pow(z, 5) + 16 * z * z * z + 3 * z) / (96 * freedom * freedom);
}

}  // namespace

testing::AssertionResult pixelsAre(const std::vector<PixelTest>& pixels, int seeds, double unseen) {
    const double freedom = seeds - 1;
    if (pixels.empty() || freedom < 15)
        return testing::AssertionFailure() << "no pixels, or too few seeds for a bound";
    double squares = 0, worst = 0, bias = 0, variance = 0, rounding = 0;
    std::size_t noisy = 0;
    for (const PixelTest& p : pixels) {
        const double floor = 3e-7 * std::abs(p.exact) +
                             1e-9;  // Pictures, and refractive indices, are rounded to float.
        bias += p.estimate - p.exact;
        variance += p.sigma * p.sigma;
        rounding += floor;
        const double error = std::max(0.0, std::abs(p.estimate - p.exact) - floor - unseen);
        if (error == 0) continue;
        if (!(p.sigma > 0))
            return testing::AssertionFailure()
                   << "no noise, yet " << p.estimate << " instead of " << p.exact;
        const double z = error / p.sigma;
        squares += z * z;
        worst = std::max(worst, z);
        ++noisy;
    }
    if (!(std::abs(bias) <= 4 * std::sqrt(variance) + rounding))
        return testing::AssertionFailure()
               << "the mean over all pixels is " << bias / std::sqrt(variance) << " sigma off";
    if (!(worst <= pixelBound(pixels.size(), freedom)))
        return testing::AssertionFailure()
               << "the worst of " << pixels.size() << " pixels is " << worst << " sigma off";
    const double count = static_cast<double>(noisy), expected = count * freedom / (freedom - 2);
    if (!(squares <= expected * (1 + 6 / std::sqrt(std::max(1.0, count)))))
        return testing::AssertionFailure()
               << "the pixels deviate as a whole: " << squares << " instead of " << expected;
    return testing::AssertionSuccess();
}

void expectPixels(const std::vector<PixelTest>& pixels, int seeds, double unseen,
                  const std::string& what) {
    EXPECT_TRUE(pixelsAre(pixels, seeds, unseen)) << what;
}

Rgb pixelAt(const Image& image, int x, int y) {
    const std::size_t i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                               static_cast<std::size_t>(x));
    return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

testing::AssertionResult meanIs(const Image& image, double exact) {
    const Estimate e = estimateMean(image);
    const double error = std::abs(e.mean - exact), rounding = 2e-7 * std::abs(exact);
    const bool right =
        error <= 4 * e.sigma + rounding && (!fullRun() || error <= 1e-3 * std::abs(exact));
    return (right ? testing::AssertionSuccess() : testing::AssertionFailure())
           << "mean " << e.mean << ", exact " << exact << ", sigma " << e.sigma;
}

void expectMean(const Image& image, double exact, const std::string& what) {
    EXPECT_TRUE(meanIs(image, exact)) << what;
    EXPECT_LE(estimateMean(image).sigma, 1e-3 * std::abs(exact)) << what << ": too noisy to tell";
}

bool fullRun() { return std::getenv("GLINT_FULL") != nullptr; }

}  // namespace glint::test
