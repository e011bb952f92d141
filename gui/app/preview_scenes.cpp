#include "gui/app/preview_scenes.h"

#include <algorithm>
#include <map>

#include "gui/app/text.h"
#include "tracer/io/scene_json.h"

namespace glint {

namespace {

constexpr int kBallSpp = 96, kThumbnailSpp = 64;

void addQuad(Scene& scene, const DVec3& at, const DVec3& turn, const DVec2& size,
             MaterialId material, const Color& emission = {}) {
    Object quad;
    quad.name = "Quad " + std::to_string(scene.objects.size());
    quad.shape = Quad{size};
    quad.material = material;
    quad.emission = emission;
    quad.transform.translate = at;
    quad.transform.rotateDegrees = turn;
    scene.objects.add(quad);
}

/// Dark squares in front of a light wall, and on the floor.
void addChequers(Scene& scene, MaterialId dark) {
    constexpr double kSide = 0.8, kFront = 0.004;
    for (int column = -5; column < 5; ++column)
        for (int row = 0; row < 4; ++row) {
            if ((column + row) % 2 != 0) continue;
            const double x = (column + 0.5) * kSide, along = (row + 0.5) * kSide;
            addQuad(scene, {x, along, -2.2 + kFront}, {90, 0, 0}, {kSide, kSide}, dark);
            addQuad(scene, {x, kFront, -2.2 + along}, {0, 0, 0}, {kSide, kSide}, dark);
        }
}

void addStudio(Scene& scene) {
    const MaterialId light = scene.materials.add({"Light grey", Diffuse{{Color{0.5, 0.5, 0.5}}}});
    const MaterialId dark = scene.materials.add({"Dark grey", Diffuse{{Color{0.12, 0.12, 0.12}}}});
    Object floor;
    floor.name = "Floor";
    floor.shape = Plane{};
    floor.material = light;
    scene.objects.add(floor);
    addQuad(scene, {0, 2, -2.2}, {90, 0, 0}, {12, 8}, light);
    addChequers(scene, dark);
    addQuad(scene, {-2.6, 4.2, 2.4}, {-125, -35, 0}, {2.4, 2.4}, {}, {11, 11, 11});
    addQuad(scene, {4.2, 1.8, 0.6}, {0, 0, 105}, {3.2, 0.9}, {}, {5, 5, 5});
    scene.environment.color = Color{0.32, 0.33, 0.35};
}

/// Copies a material with all that it is made of; gives the copy's id.
class MaterialCopy {
  public:
    MaterialCopy(const Scene& from, Scene& to) : from_(from), to_(to) {}

    MaterialId operator()(MaterialId id) {
        if (!id || !from_.materials.find(id)) return {};
        if (const auto found = copies_.find(id); found != copies_.end()) return found->second;
        Material material = from_.materials.at(id);
        if (auto* mix = std::get_if<Mix>(&material.value)) {
            mix->a.material = (*this)(mix->a.material);
            mix->b.material = (*this)(mix->b.material);
        }
        // The name is no part of the look: a renamed material keeps its picture.
        material.name = "Material " + std::to_string(copies_.size());
        return copies_[id] = to_.materials.add(std::move(material));
    }

  private:
    const Scene& from_;
    Scene& to_;
    std::map<MaterialId, MaterialId> copies_;
};

bool usesTextures(const Material& material) {
    bool uses = false;
    const auto look = [&](const auto& m) {
        forEachField(m, [&](std::string_view, const FieldMeta&, const auto& value) {
            if constexpr (requires { value.texture; }) uses = uses || value.texture;
        });
    };
    std::visit(look, material.value);
    return uses;
}

}  // namespace

Scene materialPreview(const Scene& scene, MaterialId material, QSize size) {
    Scene out;
    Object ball;
    ball.name = "Ball";
    ball.shape = Sphere{1};
    ball.material = MaterialCopy(scene, out)(material);
    ball.transform.translate = {0, 1, 0};
    bool textured = false;
    out.materials.forEach(
        [&](MaterialId, const Material& m) { textured = textured || usesTextures(m); });
    if (textured) out.textures = scene.textures;
    out.objects.add(ball);
    addStudio(out);
    out.camera.position = {0, 1.7, 5.2};
    out.camera.target = {0, 0.98, 0};
    out.camera.verticalFovDegrees = 25.5;
    out.film.width = std::max(1, size.width());
    out.film.height = std::max(1, size.height());
    out.render.spp = kBallSpp;
    out.render.clamp = 20;
    return out;
}

Scene thumbnailOf(Scene scene, QSize size) {
    const QSize fitted = QSize(scene.film.width, scene.film.height)
                             .scaled(size, Qt::KeepAspectRatio)
                             .expandedTo({1, 1});
    scene.film.width = fitted.width();
    scene.film.height = fitted.height();
    scene.render.spp = kThumbnailSpp;
    scene.render.clamp = 20;
    return scene;
}

QString previewKey(const Scene& preview) { return toQString(sceneHash(preview)); }

}  // namespace glint
