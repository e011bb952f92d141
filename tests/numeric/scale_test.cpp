// T11, and the part of T25 about interruptions: the picture depends neither on the size of the
// scene nor on its place, and a render that is cancelled and taken up again gives the bits of one
// that was not.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "tests/support/rays.h"
#include "tracer/render/scheduler.h"

namespace glint {
namespace {

using test::SceneBuilder;

/// The same still life `size` times as large, with everything that has a length or an intensity
/// following, moved by `away`.
SceneBuilder stillLife(double size, const DVec3& away, int spp,
                       Integrator integrator = Integrator::Path) {
    SceneBuilder b;
    const auto place = [&](double x, double y, double z) { return size * DVec3(x, y, z) + away; };
    const MaterialId grey = b.material(Diffuse{}), mirror = b.material(Mirror{});
    const MaterialId glass = b.material(Glass{1.5, Color{0.5 / size, 0.1 / size, 0.2 / size}});
    const MaterialId gold = b.material(Metal{{}, 0.2});
    b.object(Plane{}, grey, place(0, 0, 0));
    b.object(Sphere{size}, mirror, place(-1.3, 1, 0));
    b.object(Sphere{0.8 * size}, glass, place(1.2, 0.8, 0));
    b.object(Box{size * DVec3(1, 0.7, 0.9)}, grey, place(0, 0.35, 1.5));
    b.object(Cylinder{0.4 * size, 1.5 * size}, glass, place(2.6, 0.75, 0.3));
    b.object(Cone{0.5 * size, 1.2 * size}, gold, place(-2.8, 0.6, 0.8));
    b.object(Torus{0.5 * size, 0.15 * size}, gold, place(0.2, 0.15, 2.6));
    b.object(Disk{0.6 * size}, mirror, place(-0.2, 2.4, -0.6));
    b.object(Quad{size * DVec2(1.5, 1)}, {}, place(-1, 4, 1.5), {9, 8, 7});
    b.object(Sphere{0.3 * size}, {}, place(1.5, 3.5, 2), {25, 22, 20});
    // Turned, stretched and sheared by a group.
    Group group{.name = "Lean"};
    group.transform.rotateDegrees = {0, 20, 35};
    group.transform.scale = {1.2, 0.7, 1};
    group.transform.translate = place(3, 1.5, -1);
    const GroupId lean = b.scene().groups.add(group);
    const ObjectId id = b.object(Box{size * DVec3(0.8, 0.8, 0.8)}, grey, size * DVec3(0.1, 0.2, 0));
    Object leaning = b.scene().objects.at(id);
    leaning.parent = lean;
    leaning.transform.rotateDegrees = {30, 10, 0};
    b.scene().objects.set(id, leaning);
    b.pointLight(place(-2, 5, 3), Color{30 * size * size, 28 * size * size, 26 * size * size});
    b.scene().lights.add(
        {.name = "Spot",
         .value = SpotLight{.position = place(3, 5, 2),
                            .target = place(1, 0, 0),
                            .intensity = {40 * size * size, 40 * size * size, 20 * size * size},
                            .coneDegrees = 50}});
    b.scene().lights.add(
        {.name = "Sun",
         .value = SunLight{
             .direction = {-1, -2, -0.5}, .irradiance = {0.8, 0.7, 0.6}, .angleDegrees = 2}});
    b.scene().environment.color = Color{0.15, 0.2, 0.3};
    b.camera(place(0.3, 2.2, 7), place(0, 0.9, 0), 45);
    b.scene().camera.apertureRadius = 0.02 * size;
    b.scene().camera.focusDistance = 6.5 * size;
    b.film(64, 64, spp);
    b.scene().render.integrator = integrator;
    return b;
}

/// Every material on every shape, a lamp of every shape, groups that shear and mirror, a computed
/// sky with its sun, and a camera without perspective.
SceneBuilder gallery(double size) {
    SceneBuilder b;
    const MaterialId matt = b.material(Diffuse{Color{0.6, 0.4, 0.3}}),
                     glossy = b.material(Glossy{Color{0.2, 0.5, 0.3}, 1.5, 0.3});
    const Color absorption{0.4 / size, 0.2 / size, 0.1 / size};
    const std::vector<MaterialId> materials = {
        matt,
        glossy,
        b.material(Mirror{}),
        b.material(Metal{Color{0.9, 0.7, 0.3}, 0.0}),
        b.material(Metal{Color{0.9, 0.7, 0.3}, 0.4}),
        b.material(Glass{1.5, absorption}),
        b.material(Glass{1.4, absorption, 0.3}),
        b.material(Glass{1.5, Color{}, 0.0, true}),
        b.material(Glass{1.5, Color{}, 0.4, true}),
        b.material(Translucent{}),
        b.material(Glossy{Color{0.2, 0.5, 0.3}, 1.5, 0.0}),
        b.material(Phong{Color{0.5, 0.5, 0.8}, 0.5, 0.3, 32.0, 0.1, 0.1, 1.3, absorption}),
        b.material(Mix{{.material = matt}, {.material = glossy}, 0.3})};
    const std::vector<Shape> shapes = {Sphere{0.4 * size},
                                       Box{size * DVec3(0.6, 0.7, 0.5)},
                                       Quad{size * DVec2(0.8, 0.6)},
                                       Disk{0.4 * size},
                                       Cylinder{0.3 * size, 0.8 * size},
                                       Cone{0.4 * size, 0.8 * size},
                                       Torus{0.3 * size, 0.1 * size}};
    b.object(Plane{}, matt, {0, -size, 0});
    Group group{.name = "Lean"};
    group.transform.rotateDegrees = {0, 20, 35};
    group.transform.scale = {1.2, -0.7, 1};
    const GroupId lean = b.scene().groups.add(group);
    for (std::size_t i = 0; i < materials.size() * shapes.size(); ++i) {
        const std::size_t column = i % materials.size(), row = i / materials.size();
        const ObjectId id = b.object(
            shapes[row], materials[(column + row) % materials.size()],
            size * DVec3(static_cast<double>(column) - 6, static_cast<double>(row) - 3, 0));
        Object object = b.scene().objects.at(id);
        object.transform.rotateDegrees = {30.0 + static_cast<double>(i), 10, 0};
        object.transform.scale = {1, 1.3, 0.8};
        if (i % 3 == 0) object.parent = lean;
        b.scene().objects.set(id, object);
    }
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const ObjectId id = b.object(
            shapes[i], {}, size * DVec3(2.0 * static_cast<double>(i) - 6, 4.5, 2), {5, 4, 3});
        Object lamp = b.scene().objects.at(id);
        lamp.transform.scale = {2, 0.5, 1};
        b.scene().objects.set(id, lamp);
    }
    b.scene().environment.sky = Sky{};
    b.camera(size * DVec3(1, 2, 14), DVec3(0.0), 40);
    b.scene().camera.projection = Projection::Orthographic;
    b.scene().camera.orthoHeight = 10 * size;
    b.film(64, 40, 1);
    return b;
}

void expectSameGallery(int step, int spp) {
    const auto picture = [&](double size) {
        SceneBuilder b = gallery(size);
        b.film(64, 40, spp);
        return b.render().beauty.rgb;
    };
    const std::vector<float> whole = picture(1);
    test::Tally tally;
    for (int k = -20; k <= 20; k += step) {
        ++tally.checks;
        if (picture(std::ldexp(1.0, k)) != whole) tally.fail("times 2^" + std::to_string(k));
    }
    tally.print("sizes, every material, shape and lamp");
    EXPECT_EQ(tally.failures, 0u) << tally.first;
}

void expectSameBits(int step, int spp) {
    for (const Integrator integrator : {Integrator::Path, Integrator::Classic}) {
        const auto picture = [&](double size) {
            return stillLife(size, DVec3(0.0), spp, integrator).render().beauty.rgb;
        };
        const std::vector<float> whole = picture(1);
        test::Tally tally;
        for (int k = -20; k <= 20; k += step) {
            ++tally.checks;
            if (picture(std::ldexp(1.0, k)) != whole) tally.fail("times 2^" + std::to_string(k));
        }
        tally.print(integrator == Integrator::Path ? "sizes, path" : "sizes, classic");
        EXPECT_EQ(tally.failures, 0u) << tally.first;
    }
}

using ScaleFull = test::FullRun;
TEST(Scale, APowerOfTwoLeavesEveryBit) {
    expectSameBits(5, 4);
    expectSameGallery(10, 1);
}
TEST_F(ScaleFull, APowerOfTwoLeavesEveryBit) {
    expectSameBits(1, 4);
    expectSameGallery(1, 4);
}

/// What a camera sees first through each pixel's middle.
struct Seen {
    std::uint32_t shape = kNoShape;
    double distance = 0;
    DVec3 normal{0.0};
};
std::vector<Seen> primaryHits(const RenderScene& scene) {
    std::vector<Seen> out;
    for (int y = 0; y < scene.film.height; ++y)
        for (int x = 0; x < scene.film.width; ++x) {
            const Ray ray = scene.camera.ray(x + 0.5, y + 0.5, DVec2(0.5));
            const ShapeHit hit = scene.lists->closest(ray, scene.cameraMedia);
            if (!hit.found()) {
                out.emplace_back();
                continue;
            }
            const ShapeInstance& shape = scene.shapes[hit.shape];
            const DVec3 local = shape.localPoint(ray.at(hit.t));
            const DVec3 normal = std::visit(
                [&](const auto& s) { return s.normal(s.project(local, hit.face), hit.face); },
                shape.shape);
            out.push_back({hit.shape, hit.t, glm::normalize(normal * shape.localFromWorld)});
        }
    return out;
}

struct Change {
    double size;
    DVec3 away;
};
const Change kChanges[] = {{1e-3, DVec3(0.0)},    {1e3, DVec3(0.0)},     {1e-6, DVec3(0.0)},
                           {1, {1e5, 2e4, -3e5}}, {1, {1e6, -1e6, 1e6}}, {1e3, {1e9, 0, 1e9}}};

TEST(Scale, FirstHitsAgreeInOtherSizesAndPlaces) {
    const std::vector<Seen> before = primaryHits(*stillLife(1, DVec3(0.0), 1).compile());
    for (const Change& change : kChanges) {
        const std::vector<Seen> after =
            primaryHits(*stillLife(change.size, change.away, 1).compile());
        int others = 0;
        for (std::size_t i = 0; i < before.size(); ++i) {
            if (after[i].shape != before[i].shape) {
                ++others;
                continue;
            }
            if (before[i].shape == kNoShape) continue;
            EXPECT_NEAR(after[i].distance / change.size, before[i].distance,
                        1e-6 * before[i].distance);
            EXPECT_LT(glm::length(after[i].normal - before[i].normal), 1e-6);
        }
        EXPECT_EQ(others, 0) << "pixels see another object";
    }
}

void expectSameLight(int spp) {
    const Image before = stillLife(1, DVec3(0.0), spp).render().beauty;
    test::Tally tally;  // Numbers of the pictures, and the largest share that another path changed.
    for (const Change& change : kChanges) {
        const Image after = stillLife(change.size, change.away, spp).render().beauty;
        // A pixel may differ where a path went another way at a silhouette.
        int others = 0;
        double sum = 0, squares = 0;
        for (std::size_t i = 0; i < before.rgb.size(); ++i) {
            const double d = static_cast<double>(after.rgb[i]) - before.rgb[i];
            others += std::abs(d) > 1e-4 * std::max(1e-3, static_cast<double>(before.rgb[i]));
            sum += d, squares += d * d;
        }
        const double n = static_cast<double>(before.rgb.size()), mean = sum / n,
                     sigma = std::sqrt(squares / n / n);
        tally.checks += before.rgb.size();
        tally.error(others / n);
        EXPECT_LE(others, 0.001 * n) << "size " << change.size << ", moved to " << change.away.x;
        EXPECT_LE(std::abs(mean), 4 * sigma + 1e-9);  // A hundredth of a float's last place.
    }
    tally.print("light in other sizes and places");
}
TEST(Scale, LightAgreesInOtherSizesAndPlaces) { expectSameLight(4); }
TEST_F(ScaleFull, LightAgreesInOtherSizesAndPlaces) { expectSameLight(64); }

/// Cancels after every few samples by moving the epoch from within the kernel's own check, from
/// another thread.
TEST(Interruption, CancelledAndResumedPassesGiveTheSameBits) {
    const auto scene = stillLife(1, DVec3(0.0), 6).compile();
    const PixelRect all{0, 0, scene->film.width, scene->film.height};
    WorkerPool pool(2);
    Scheduler scheduler(pool);
    Film whole(all.width, all.height), broken(all.width, all.height);
    RenderCounts counts;
    ASSERT_EQ(scheduler.renderPass(*scene, whole, nullptr, all, 1, {.samples = 6}, {}, counts),
              PassResult::Done);

    std::atomic<std::uint64_t> epoch{0};
    int cancelled = 0;
    {
        std::jthread impatient([&](const std::stop_token& end) {
            while (!end.stop_requested()) {
                std::this_thread::sleep_for(std::chrono::milliseconds(3));
                epoch.fetch_add(1);
            }
        });
        // Coarse passes first, as the viewport does; each call takes up where the last one was
        // stopped.
        for (const int stride : {4, 1})
            while (scheduler.renderPass(*scene, broken, nullptr, all, stride,
                                        {.samples = stride == 1 ? 6u : 1u}, {&epoch, epoch.load()},
                                        counts) == PassResult::Cancelled)
                ++cancelled;
    }
    EXPECT_GT(cancelled, 0) << "nothing was interrupted";
    EXPECT_EQ(broken.image().rgb, whole.image().rgb);
    EXPECT_EQ(counts.nonfinite, 0u);
}

}  // namespace
}  // namespace glint
