#include "tests/bench/peers/peer_scene.h"

#include "tests/bench/scene_list.h"
#include "tracer/compile/compiler.h"
#include "tracer/io/scene_json.h"

namespace glint::bench {

namespace {

namespace fs = std::filesystem;

std::array<double, 12> rowsOf(const Affine& affine) {
    const Transform transform = toTransform(affine);
    if (transform.matrix) return *transform.matrix;
    std::array<double, 12> rows{};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            rows[static_cast<std::size_t>(4 * row + column)] = affine.linear[column][row];
        rows[static_cast<std::size_t>(4 * row + 3)] = affine.translation[row];
    }
    return rows;
}

void flattenObjects(Scene& scene) {
    for (const ObjectId id : scene.objects.ids()) {
        Object object = scene.objects.at(id);
        if (!isVisible(scene, object)) {
            scene.objects.erase(id);
            continue;
        }
        const std::array<double, 12> rows = rowsOf(worldFromObject(scene, object));
        object.transform = {};
        object.transform.matrix = rows;
        object.parent = {};
        scene.objects.set(id, object);
    }
    scene.groups = {};
    for (const LightId id : scene.lights.ids())
        if (!scene.lights.at(id).visible) scene.lights.erase(id);
}

/// A picture's absolute path; a computed sky is written as one.
Status flattenEnvironment(Scene& scene, const fs::path& sceneFolder, const fs::path& folder) {
    Environment& environment = scene.environment;
    if (!environment.image.empty()) {
        environment.image =
            fs::absolute(sceneFolder / environment.image).lexically_normal().string();
    } else if (environment.sky) {
        AssetCache assets;
        const fs::path picture = folder / "sky.exr";
        const Status saved = saveLinear(picture, *assets.sky(*environment.sky), {});
        if (!saved) return saved.error();
        environment.image = picture.string();
        environment.sky.reset();
    }
    return Done{};
}

}  // namespace

Result<PeerScene> loadPeerScene(const fs::path& file, int width, int threads,
                                const fs::path& folder) {
    Result<Scene> loaded = loadScene(file);
    if (!loaded) return loaded.error();
    PeerScene out{file.stem().string(), std::move(loaded).value(), threads, false,
                  fs::absolute(folder)};
    Scene& scene = out.scene;
    scaleFilm(scene, width);
    scene.film.filter = Filter::Box;
    scene.film.filterRadius = 0.5;
    scene.render.timeSeconds = scene.render.errorPercent = scene.render.clamp = 0;
    scene.camera = scene.viewCamera();
    scene.camera.name.clear();
    scene.activeCamera = {};
    scene.cameras = {};
    scene.views.clear();
    scene.editor.clear();
    flattenObjects(scene);
    const Status environment = flattenEnvironment(scene, file.parent_path(), out.folder);
    if (!environment) return environment.error();
    return out;
}

}  // namespace glint::bench
