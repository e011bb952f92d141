#include "tests/bench/viewport_scene.h"

#include <cmath>

namespace glint::bench {

namespace {

double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

Color randomColor(std::mt19937& random) {
    return {uniform(random, 0.05, 0.9), uniform(random, 0.05, 0.9), uniform(random, 0.05, 0.9)};
}

template <class Id>
Id oneOf(const std::vector<Id>& ids, std::mt19937& random) {
    return ids[std::uniform_int_distribution<std::size_t>(0, ids.size() - 1)(random)];
}

/// As orbiting does: about what is looked at.
void moveCamera(Scene& scene, std::mt19937& random) {
    Camera camera = scene.viewCamera();
    const double turn = uniform(random, -0.03, 0.03), c = std::cos(turn), s = std::sin(turn);
    const DVec3 from = camera.position - camera.target;
    camera.position =
        camera.target + DVec3(c * from.x + s * from.z, from.y, c * from.z - s * from.x);
    if (scene.activeCamera)
        scene.cameras.set(scene.activeCamera, camera);
    else
        scene.camera = camera;
}

/// Colour or intensity of a light, a lamp or the environment: what the mix of light groups is for;
/// one in four moves a light.
void editLight(Scene& scene, std::mt19937& random) {
    const double factor = uniform(random, 0.5, 2);
    if (!scene.lights.empty() && random() % 2 == 0) {
        const LightId id = oneOf(scene.lights.ids(), random);
        Light light = scene.lights.at(id);
        auto* point = std::get_if<PointLight>(&light.value);
        if (point && random() % 2 == 0)
            point->position.x += uniform(random, -0.1, 0.1);
        else
            lightColor(light) = Color{lightColor(light).r * factor, lightColor(light).g * factor,
                                      lightColor(light).b * factor};
        scene.lights.set(id, light);
        return;
    }
    scene.environment.intensity = std::clamp(scene.environment.intensity * factor, 0.05, 20.0);
}

void editTransform(Scene& scene, std::mt19937& random) {
    const ObjectId id = oneOf(scene.objects.ids(), random);
    Object object = scene.objects.at(id);
    object.transform.translate.x += uniform(random, -0.05, 0.05);
    object.transform.translate.y += uniform(random, 0, 0.01);
    scene.objects.set(id, object);
}

}  // namespace

std::string nameOf(EditKind kind) {
    constexpr std::array names = {"camera", "material", "light", "transform"};
    return names[static_cast<std::size_t>(kind)];
}

bool recolor(Material& material, std::mt19937& random) {
    return std::visit(
        [&](auto& value) {
            if constexpr (requires { value.color.value = Color{}; })
                value.color.value = randomColor(random);
            else if constexpr (requires { value.absorption.value = Color{}; })
                value.absorption.value = randomColor(random);
            else
                return false;
            return true;
        },
        material.value);
}

void editScene(Scene& scene, EditKind kind, std::mt19937& random) {
    if (kind == EditKind::Material && !scene.materials.empty()) {
        const MaterialId id = oneOf(scene.materials.ids(), random);
        Material material = scene.materials.at(id);
        if (recolor(material, random)) return scene.materials.set(id, material);
    }
    if (kind == EditKind::Light) return editLight(scene, random);
    if (kind == EditKind::Transform && !scene.objects.empty()) return editTransform(scene, random);
    moveCamera(scene, random);
}

Scene manyShapes(int count) {
    Scene out;
    std::mt19937 random(1);
    std::vector<MaterialId> materials;
    for (int i = 0; i < 5; ++i)
        materials.push_back(
            out.materials.add({"Clay " + std::to_string(i + 1), Diffuse{randomColor(random)}}));
    materials.push_back(out.materials.add({"Mirror", Mirror{}}));
    materials.push_back(out.materials.add({"Glass", Glass{}}));
    materials.push_back(out.materials.add({"Gloss", Glossy{}}));
    out.objects.add({.name = "Ground", .shape = Plane{}, .material = materials[0]});
    const int side = static_cast<int>(std::ceil(std::sqrt(count)));
    for (int i = 1; i < count; ++i) {
        Object object{.name = "Shape " + std::to_string(i),
                      .material = materials[random() % materials.size()]};
        const double size = uniform(random, 0.2, 0.4);
        if (i % 2)
            object.shape = Sphere{size};
        else
            object.shape = Box{{size, 2 * size, size}};
        object.transform.translate = {i % side - 0.5 * side, size, i / side - 0.5 * side};
        out.objects.add(object);
    }
    out.environment.color = Color{0.4, 0.5, 0.7};
    for (int i = 0; i < 3; ++i)
        out.lights.add({"Lamp " + std::to_string(i + 1),
                        PointLight{.position = {6.0 * i - 6, 8, 2}, .intensity = {40, 38, 35}},
                        true, ""});
    out.camera.position = {0, 9, 0.8 * side};
    out.camera.target = {0, 0, 0};
    out.render.spp = 4096;
    return out;
}

}  // namespace glint::bench
