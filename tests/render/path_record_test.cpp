// The record of a sample: its contributions add up to the sample, for both integrators, and it
// names what was met.
#include <gtest/gtest.h>

#include "tests/support/scenes.h"
#include "tracer/render/path_record.h"

namespace glint {
namespace {

using test::SceneBuilder;

Rgb sumOf(const PathRecord& record) {
    DVec3 sum(0.0);
    for (const PathVertex& vertex : record.vertices)
        for (const PathLight& light : vertex.lights) sum += toDouble(light.value);
    return toFloat(sum);
}

SceneBuilder glassAndMirror() {
    SceneBuilder b;
    Glass tinted;
    tinted.absorption = Color{0.5, 1, 2};
    b.object(Plane{}, b.material(Diffuse{}));
    b.object(Sphere{1}, b.material(tinted), {-1, 1, 0});
    b.object(Sphere{1}, b.material(Mirror{}), {1, 1, 0});
    b.object(Sphere{0.3}, b.material(Diffuse{}), {0, 4, 0}, {20, 20, 20});
    b.pointLight({2, 3, 2}, {10, 9, 8});
    b.scene().environment.color = Color{0.4, 0.5, 0.6};
    b.camera({0, 2, 6}, {0, 0.8, 0}, 40);
    b.scene().film.width = 48;
    b.scene().film.height = 32;
    return b;
}

TEST(PathRecord, ContributionsAddUpToTheSample) {
    for (const Integrator integrator : {Integrator::Path, Integrator::Classic})
        for (const double clamp : {0.0, 0.3}) {
            SceneBuilder b = glassAndMirror();
            b.scene().render.integrator = integrator;
            b.scene().render.clamp = clamp;
            const auto scene = b.compile();
            for (int y = 0; y < 32; ++y)
                for (int x = 0; x < 48; ++x)
                    for (int sample = 0; sample < 3; ++sample) {
                        const PathRecord record = recordSample(*scene, {x, y, sample});
                        const Rgb value = renderSample(*scene, {x, y, sample});
                        ASSERT_EQ(record.value, value) << x << "," << y << "," << sample;
                        const Rgb sum = sumOf(record);
                        for (int c = 0; c < 3; ++c)
                            ASSERT_NEAR(sum[c], value[c], 2e-6f * value[c] + 1e-12f)
                                << x << "," << y << "," << sample;
                    }
        }
}

TEST(PathRecord, NamesWhatThePathMet) {
    SceneBuilder b = glassAndMirror();
    const auto scene = b.compile();
    bool reflected = false, refracted = false, absorbed = false, direct = false;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 48; ++x) {
            const PathRecord record = recordSample(*scene, {x, y, 0});
            ASSERT_FALSE(record.vertices.empty());
            for (std::size_t i = 0; i < record.vertices.size(); ++i) {
                const PathVertex& v = record.vertices[i];
                ASSERT_LT(v.parent, static_cast<int>(i));
                reflected = reflected || v.event == PathEvent::Reflection;
                refracted = refracted || v.event == PathEvent::Refraction;
                if (v.absorbedLength > 0 && v.hit) {
                    absorbed = true;
                    // Green is absorbed at 1 per metre.
                    ASSERT_NEAR(v.transmitted.y, std::exp(-v.absorbedLength), 1e-5);
                }
                for (const PathLight& light : v.lights)
                    direct = direct || light.kind == PathLight::Kind::Direct;
            }
            EXPECT_FALSE(pathText(record, b.scene()).empty());
        }
    EXPECT_TRUE(reflected && refracted && absorbed && direct);
}

TEST(PathRecord, TotalsOfRowsAreTheSample) {
    SceneBuilder b = glassAndMirror();
    const auto scene = b.compile();
    for (int x = 0; x < 48; ++x) {
        const PathRecord record = recordSample(*scene, {x, 16, 1});
        const std::vector<PathRow> rows = pathRows(record, b.scene());
        ASSERT_FALSE(rows.empty());
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(rows.front().total[c], record.value[c], 2e-6f * record.value[c] + 1e-12f);
    }
}

}  // namespace
}  // namespace glint
