// The scenes scenes/verify/scale_*: the same still life at every size, planets of true size, and a
// ball that rests on a floor.
#include <gtest/gtest.h>

#include <array>

#include "tests/support/paths.h"
#include "tests/support/scenes.h"
#include "tracer/io/scene_json.h"

namespace glint {
namespace {

Scene load(const std::string& name) {
    auto scene = loadScene(test::inSource("scenes/verify/" + name + ".json"));
    EXPECT_TRUE(scene.ok()) << name;
    return std::move(scene).value();
}
std::shared_ptr<const RenderScene> compiled(const Scene& scene) {
    AssetCache assets;
    auto out = compile(scene, test::inSource("scenes/verify"), assets);
    EXPECT_TRUE(out.ok());
    EXPECT_TRUE(out.value().warnings.empty());
    return out.value().scene;
}
Image picture(Scene scene, int width, int height, int spp) {
    scene.film.width = width, scene.film.height = height, scene.render.spp = spp;
    const Rendering out = render(compiled(scene), {.threads = 2});
    EXPECT_EQ(out.nonfiniteSamples, 0u);
    return out.beauty;
}

/// The bars of scale_test.cpp, on the files: 99.9 % of the numbers within 1e-4, and the mean.
TEST(ScaleScenes, TheStillLifeIsTheSameAtEverySizeAndPlace) {
    const Image metre = picture(load("scale_metre"), 96, 60, 8);
    for (const char* name :
         {"scale_micrometre", "scale_megametre", "scale_gigametre", "scale_far_away"}) {
        const Image other = picture(load(name), 96, 60, 8);
        double sum = 0, squares = 0;
        int apart = 0;
        for (std::size_t i = 0; i < metre.rgb.size(); ++i) {
            const double a = static_cast<double>(metre.rgb[i]),
                         d = static_cast<double>(other.rgb[i]) - a;
            apart += std::abs(d) > 1e-4 * std::max(1e-3, a) ? 1 : 0;
            sum += d, squares += d * d;
        }
        const auto n = static_cast<double>(metre.rgb.size());
        EXPECT_LE(apart, 0.001 * n) << name;
        EXPECT_LE(std::abs(sum / n), 4 * std::sqrt(squares) / n + 1e-9) << name;
    }
}

/// A direction at `angle` from `axis`, turned about it by `around`.
DVec3 beside(const DVec3& axis, long double angle, double around) {
    const Frame frame(axis);
    const auto s = static_cast<double>(std::sin(angle)), c = static_cast<double>(std::cos(angle));
    return glm::normalize(frame.toWorld(DVec3(s * std::cos(around), s * std::sin(around), c)));
}
/// Whether a ray from the camera meets the object of that name first.
bool sees(const RenderScene& scene, const Scene& document, const std::string& name,
          const DVec3& direction) {
    const ShapeHit hit =
        scene.lists->closest({scene.camera.position(), direction}, scene.cameraMedia);
    return hit.found() && document.objects.at(scene.shapes[hit.shape].object).name == name;
}

/// From 22 000 km and from 2 m above the ground: the limb is where sin(angle) = R / (R + h), to
/// 1e-9 of a radian, though the sun stands at the origin, 1.5e11 m away. (Rounding of 1.5e11 m
/// to 1.5e-5 m over the camera's height is a part of that.)
TEST(ScaleScenes, PlanetsEndWhereTheirRadiiSay) {
    const Scene document = load("scale_planets_space");
    const auto scene = compiled(document);
    for (const auto& [name, radius] : {std::pair{"Earth", 6371000.0L},
                                       {"Moon", 1737400.0L},
                                       {"Venus", 6051800.0L},
                                       {"Jupiter", 69911000.0L},
                                       {"Sun", 695700000.0L}}) {
        const auto ball = std::find_if(
            scene->shapes.begin(), scene->shapes.end(),
            [&](const ShapeInstance& s) { return document.objects.at(s.object).name == name; });
        ASSERT_NE(ball, scene->shapes.end());
        const DVec3 to = ball->center - scene->camera.position();
        const long double limb = std::asin(radius / static_cast<long double>(glm::length(to)));
        for (int i = 0; i < 64; ++i) {
            EXPECT_TRUE(sees(*scene, document, name,
                             beside(glm::normalize(to), limb - 1e-9L * std::max(limb, 1e-3L), i)))
                << name;
            EXPECT_FALSE(sees(*scene, document, name,
                              beside(glm::normalize(to), limb + 1e-9L * std::max(limb, 1e-3L), i)))
                << name;
        }
    }
}

/// A Lambert ball in place of Venus, seen from the sun's side: rho L (R / d)^2 cos(theta), the
/// sun's disc being seen whole.
TEST(ScaleScenes, PlanetsAreLitByASunOfTrueSize) {
    Scene document = load("scale_planets_space");
    document.environment.color = Color{0, 0, 0};
    const DVec3 venus(103328488207.873, 0, -31963247020.0555);
    const double distance = glm::length(venus), ground = distance - 6051800;
    document.camera.position = venus - glm::normalize(venus) * 20e6;
    document.camera.target = venus;
    document.camera.verticalFovDegrees = 0.01;
    const Image seen = picture(document, 8, 8, 16);
    // Venus reflects 0.75, 0.7, 0.6. From the camera no other planet is in the way.
    const double irradiance = std::pow(695700000 / ground, 2);
    const std::array<double, 3> exact = {0.75 * 2e7 * irradiance, 0.7 * 1.9e7 * irradiance,
                                         0.6 * 1.8e7 * irradiance};
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(test::estimateMean(seen, c).mean, exact[static_cast<std::size_t>(c)],
                    1e-3 * exact[static_cast<std::size_t>(c)]);
}

/// Rays within the crevice, from 3 s beside the contact down to places of the floor s beside it:
/// each meets the floor or the ball, none passes between them, down to s of a ten millionth of the
/// radius.
TEST(ScaleScenes, NothingPassesBetweenABallAndItsFloorBehindGlass) {
    const Scene document = load("scale_contact_through_glass");
    const auto scene = compiled(document);
    const auto nameAt = [&](const ShapeHit& hit) {
        return hit.found() ? document.objects.at(scene->shapes[hit.shape].object).name
                           : std::string("nothing");
    };
    int floor = 0, ball = 0;
    for (int i = 0; i < 2000; ++i) {
        const double s = 1e-2 * std::pow(1e-5, (i % 40) / 39.0), turn = 0.1 * i;
        const DVec3 contact = -scene->origin, out(std::cos(turn), 0, std::sin(turn)),
                    aside(-out.z, 0, out.x);
        const DVec3 from = contact + 3 * s * out + DVec3(0, (0.1 + 4.2 * (i % 7) / 6) * s * s, 0);
        const DVec3 to = contact + s * (0.5 * out + 0.5 * (i % 5 - 2) * aside);
        const std::string name =
            nameAt(scene->lists->closest({from, glm::normalize(to - from)}, {}));
        floor += name == "Floor" ? 1 : 0;
        ball += name == "Ball" ? 1 : 0;
    }
    EXPECT_EQ(floor + ball, 2000);
    EXPECT_GT(floor, 100);
    EXPECT_GT(ball, 100);
    // The whole picture, through both glasses.
    const Image seen = picture(document, 48, 30, 16);
    EXPECT_GT(test::estimateMean(seen).mean, 0.05);
}

}  // namespace
}  // namespace glint
