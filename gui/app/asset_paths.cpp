#include "gui/app/asset_paths.h"

#include <variant>

namespace glint {

std::string assetPath(const std::filesystem::path& asset, const std::filesystem::path& sceneFile) {
    const auto absolute = std::filesystem::absolute(asset).lexically_normal();
    if (sceneFile.empty()) return absolute.generic_string();
    const auto relative = absolute.lexically_relative(
        std::filesystem::absolute(sceneFile).lexically_normal().parent_path());
    return (relative.empty() ? absolute : relative).generic_string();
}

Scene withAssetsFrom(Scene scene, const std::filesystem::path& from,
                     const std::filesystem::path& sceneFile) {
    const auto rebase = [&](std::string& path) {
        if (path.empty()) return false;
        const std::string rebased = assetPath(from / path, sceneFile);
        if (std::filesystem::path(path).lexically_normal().generic_string() == rebased)
            return false;
        path = rebased;
        return true;
    };
    rebase(scene.environment.image);
    for (const TextureId id : scene.textures.ids()) {
        Texture texture = scene.textures.at(id);
        if (rebase(texture.file)) scene.textures.set(id, std::move(texture));
    }
    for (const ObjectId id : scene.objects.ids()) {
        if (!std::holds_alternative<Mesh>(scene.objects.at(id).shape)) continue;
        Object object = scene.objects.at(id);
        if (rebase(std::get<Mesh>(object.shape).file)) scene.objects.set(id, std::move(object));
    }
    return scene;
}

}  // namespace glint
