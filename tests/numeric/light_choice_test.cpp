// Choosing among lights: probabilities against frequencies, and against what the lights send.
#include <gtest/gtest.h>

#include <random>

#include "tests/support/scenes.h"
#include "tracer/math/frame.h"

namespace glint {
namespace {

constexpr int kDraws = 200'000;

std::vector<LightBounds> randomLights(std::size_t count, std::mt19937_64& random) {
    std::uniform_real_distribution<double> u(-1, 1);
    std::vector<LightBounds> lights;
    for (std::size_t i = 0; i < count; ++i)
        lights.push_back({{10 * u(random), 10 * u(random), 10 * u(random)},
                          i % 3 ? 0.1 : 0.0,
                          std::exp(2 * u(random))});
    if (count > 4) lights[4].radius = kInfinity;  // A sun.
    return lights;
}

TEST(LightChoice, ProbabilitiesSumToOneAndAreThoseOfTheChoice) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> u(0, 1);
    for (const std::size_t count : {1, 2, 3, 5, 17, 100, 1000}) {
        const LightChoice choice(randomLights(count, random));
        const DVec3 from(u(random), u(random), u(random)), normal(0, 1, 0);
        double sum = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const double p = choice.probability(from, normal, i);
            EXPECT_GT(p, 0) << "light " << i << " of " << count;
            sum += p;
        }
        EXPECT_NEAR(sum, 1, 1e-9) << count;
        std::vector<int> hits(count, 0);
        for (int i = 0; i < kDraws; ++i) {
            const auto chosen = choice.choose(from, normal, (i + u(random)) / kDraws);
            ASSERT_NEAR(chosen.probability, choice.probability(from, normal, chosen.light), 1e-12);
            ++hits[chosen.light];
        }
        // The draws are stratified: each light gets its share to a few strata for each time that
        // its intervals begin or end.
        for (std::uint32_t i = 0; i < count; ++i)
            EXPECT_NEAR(hits[i], kDraws * choice.probability(from, normal, i), 4)
                << "light " << i << " of " << count;
    }
}

/// Lights of all kinds that shine in some directions only, turned at random.
std::shared_ptr<const RenderScene> aimedLights(std::size_t count, std::mt19937_64& random) {
    std::uniform_real_distribution<double> u(-1, 1);
    test::SceneBuilder b;
    const MaterialId grey = b.material(Diffuse{});
    b.object(Sphere{0.1}, grey, {0, 0, 0});
    const auto place = [&](double size) { return size * DVec3(u(random), u(random), u(random)); };
    const Color white = test::grey(1);
    for (std::size_t i = 0; i < count; ++i) {
        const DVec3 at = place(5);
        const Shape flat = i % 2 ? Shape(Disk{0.5 + 0.4 * u(random)})
                                 : Shape(Quad{{1 + 0.9 * u(random), 1 + 0.9 * u(random)}});
        if (i % 4 < 2) {
            const ObjectId id = b.object(flat, {}, at, white);
            Object lamp = b.scene().objects.at(id);
            lamp.transform.rotateDegrees = place(180);
            lamp.transform.scale = {1, u(random) < 0 ? -1 : 1, 1 + 0.5 * u(random)};
            lamp.twoSided = i % 16 == 4;
            b.scene().objects.set(id, lamp);
        } else if (i % 4 == 2) {
            const double blend = i % 8 == 2 ? 0 : 0.5 + 0.5 * u(random);
            b.scene().lights.add({"Spot " + std::to_string(i),
                                  SpotLight{at, at + place(1), white, 90 + 85 * u(random), blend},
                                  true, ""});
        } else {
            b.scene().lights.add({"Sun " + std::to_string(i),
                                  SunLight{place(1), white, i % 8 == 3 ? 0 : 90 + 89 * u(random)},
                                  true, ""});
        }
    }
    return b.compile();
}

TEST(LightChoice, EveryLightThatReachesAPlaceCanBeChosenThere) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> u(0, 1);
    int reached = 0, never = 0;
    for (const std::size_t count : {5, 9, 40, 300}) {
        const auto scene = aimedLights(count, random);
        const LightTable& table = scene->lights;
        ASSERT_EQ(table.lights.size(), count);
        for (int i = 0; i < 300; ++i) {
            const DVec3 from = 12.0 * DVec3(u(random), u(random), u(random)) - 6.0;
            const DVec3 normal = glm::normalize(DVec3(u(random), u(random), u(random)) - 0.5);
            double sum = 0;
            for (std::uint32_t light = 0; light < count; ++light) {
                const double p = table.choice.probability(from, normal, light);
                sum += p;
                never += p == 0;
                const LightSample s =
                    sampleLight(table, scene->shapes, light, {from, normal, kNoShape, false}, {},
                                {u(random), u(random)});
                if (!(s.pdf > 0) || isBlack(s.radiance)) continue;
                ++reached;
                ASSERT_GT(p, 0) << "light " << light << " of " << count;
            }
            ASSERT_LE(sum, 1 + 1e-9);
            for (int draw = 0; draw < 8; ++draw) {
                const auto chosen = table.choice.choose(from, normal, u(random));
                ASSERT_TRUE(chosen.probability == 0 ||
                            std::abs(chosen.probability -
                                     table.choice.probability(from, normal, chosen.light)) < 1e-12);
            }
        }
    }
    EXPECT_GT(reached, 10'000);
    EXPECT_GT(never, 10'000);  // They are told apart.
}

/// At the rim of a spot without blend, where all that counts is on which side of the rim a place
/// is.
TEST(LightChoice, ASpotCanBeChosenAsFarAsItShines) {
    for (const double degrees : {1.0, 20.0, 60.0, 90.0, 120.0, 179.0, 180.0}) {
        test::SceneBuilder b;
        b.object(Sphere{0.1}, b.material(Diffuse{}), {9, 0, 0});
        b.scene().lights.add(
            {"Spot", SpotLight{{0, 0, 0}, {0, 0, -1}, test::grey(1), degrees, 0}, true, ""});
        b.pointLight({0, 5, 0}, test::grey(1));
        const auto scene = b.compile();
        const double rim = degreesToRadians(degrees / 2);
        int lit = 0;
        for (int i = -1000; i <= 1000; ++i) {
            const double angle = rim + 1e-10 * i * std::abs(i);
            const DVec3 from = scene->lights.lights[0].position +
                               3.0 * DVec3(std::sin(angle), 0, -std::cos(angle));
            const LightSample s = sampleLight(scene->lights, scene->shapes, 0,
                                              {from, {}, kNoShape, false}, {}, {0.5, 0.5});
            if (!(s.pdf > 0)) continue;
            ++lit;
            EXPECT_GT(scene->lights.choice.probability(from, {0, 0, 1}, 0), 0)
                << degrees << " " << i;
        }
        EXPECT_GT(lit, 500) << degrees;
        EXPECT_EQ(scene->lights.choice.probability(
                      scene->lights.lights[0].position + DVec3(0, 0, 3), {0, 0, 1}, 0),
                  0)
            << degrees;
    }
}

TEST(LightChoice, LightsThatAllShineElsewhereAreNotChosen) {
    const LightAim up({0, 1, 0}, 0, 0);
    for (const std::size_t count : {2, 30}) {
        std::vector<LightBounds> lights;
        for (std::size_t i = 0; i < count; ++i)
            lights.push_back({{static_cast<double>(i), 0, 0}, 0.1, 1, up});
        const LightChoice choice(lights);
        EXPECT_EQ(choice.choose({0, -9, 0}, {0, 1, 0}, 0.7).probability, 0);
        EXPECT_EQ(choice.probability({0, -9, 0}, {0, 1, 0}, 1), 0);
        EXPECT_GT(choice.probability({0, 9, 0}, {0, -1, 0}, 1), 0);
    }
}

TEST(LightChoice, ALightWithoutPowerIsChosenOnlyAmongItsLike) {
    const LightChoice dark({{{0, 0, 0}, 0, 0}, {{1, 0, 0}, 0, 0}});
    EXPECT_GT(dark.probability({0, 2, 0}, {0, -1, 0}, 0), 0);
    const LightChoice mixed({{{0, 0, 0}, 0, 0}, {{1, 0, 0}, 0, 1}});
    for (const double u : {0.0, 0.3, 1 - 0x1p-24})
        EXPECT_EQ(mixed.choose({0, 2, 0}, {0, -1, 0}, u).light, 1u);
}

}  // namespace
}  // namespace glint
