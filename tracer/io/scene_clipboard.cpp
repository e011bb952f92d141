// Objects as text, with all that they refer to, and back into another scene.
#include <unordered_map>

#include "tracer/io/scene_json.h"
#include "tracer/scene/edit.h"

namespace glint {

namespace {

/// Copies things from one scene into another, each once, together with what they refer to. A
/// material, texture or group that is already there under the same name with the same content is
/// used, not copied.
class Transplant {
  public:
    Transplant(const Scene& from, Scene to) : from_(from), to_(std::move(to)) {
        index(to_.materials, materialNames_);
        index(to_.textures, textureNames_);
        index(to_.groups, groupNames_);
    }

    ObjectId object(ObjectId id) {
        Object copy = from_.objects.at(id);
        copy.material = material(copy.material);
        copy.parent = group(copy.parent);
        copy.name = freeObjectName(to_, copy.name);
        return to_.objects.add(std::move(copy));
    }

    LightId light(LightId id) {
        Light copy = from_.lights.at(id);
        copy.name = freeLightName(to_, copy.name);
        return to_.lights.add(std::move(copy));
    }
    CameraId camera(CameraId id) {
        Camera copy = from_.cameras.at(id);
        copy.name = freeCameraName(to_, copy.name);
        return to_.cameras.add(std::move(copy));
    }

    [[nodiscard]] Scene take() { return std::move(to_); }

  private:
    template <class IdType>
    using Names = std::unordered_map<std::string, IdType>;

    template <class Table, class IdType>
    static void index(const Table& table, Names<IdType>& names) {
        table.forEach([&](IdType id, const auto& value) { names.emplace(value.name, id); });
    }

    /// The id in `to` for a copy whose references are already those of `to`.
    template <class Table, class Value, class IdType, class FreeName>
    IdType place(Table& table, Names<IdType>& names, Value copy, FreeName&& freeName) {
        const auto same = names.find(copy.name);
        if (same != names.end() && table.at(same->second) == copy) return same->second;
        copy.name = freeName(to_, copy.name);
        const std::string name = copy.name;
        return names[name] = table.add(std::move(copy));
    }

    MaterialId material(MaterialId id) {
        if (!id || materials_.contains(id.value)) return id ? materials_[id.value] : id;
        Material copy = from_.materials.at(id);
        std::visit(
            [&](auto& value) {
                forEachField(value, [&](std::string_view, const FieldMeta&, auto& member) {
                    follow(member);
                });
            },
            copy.value);
        return materials_[id.value] =
                   place(to_.materials, materialNames_, std::move(copy), freeMaterialName);
    }

    GroupId group(GroupId id) {
        if (!id || groups_.contains(id.value)) return id ? groups_[id.value] : id;
        Group copy = from_.groups.at(id);
        copy.parent = group(copy.parent);
        return groups_[id.value] = place(to_.groups, groupNames_, std::move(copy), freeGroupName);
    }

    TextureId texture(TextureId id) {
        if (!id || textures_.contains(id.value)) return id ? textures_[id.value] : id;
        return textures_[id.value] = place(to_.textures, textureNames_, from_.textures.at(id),
                                           [](const Scene& scene, std::string name) {
                                               while (hasTexture(scene, name)) name += " 2";
                                               return name;
                                           });
    }

    static bool hasTexture(const Scene& scene, const std::string& name) {
        bool found = false;
        scene.textures.forEach(
            [&](TextureId, const Texture& texture) { found = found || texture.name == name; });
        return found;
    }

    template <class T>
    void follow(Textured<T>& field) {
        field.texture = texture(field.texture);
    }
    void follow(MixPart& part) { part.material = material(part.material); }
    template <class T>
    void follow(T&) {}

    const Scene& from_;
    Scene to_;
    Names<MaterialId> materialNames_;
    Names<TextureId> textureNames_;
    Names<GroupId> groupNames_;
    std::unordered_map<std::uint32_t, MaterialId> materials_;
    std::unordered_map<std::uint32_t, TextureId> textures_;
    std::unordered_map<std::uint32_t, GroupId> groups_;
};

}  // namespace

std::string formatObjects(const Scene& scene, const std::vector<ObjectId>& objects,
                          const std::vector<LightId>& lights,
                          const std::vector<CameraId>& cameras) {
    Transplant copy(scene, Scene{});
    for (const ObjectId id : objects) copy.object(id);
    for (const LightId id : lights) copy.light(id);
    for (const CameraId id : cameras) copy.camera(id);
    return formatScene(copy.take());
}

Result<PastedObjects> pasteObjects(const Scene& scene, std::string_view text) {
    const auto pasted = parseScene(text, "clipboard");
    if (!pasted) return pasted.error();
    Transplant copy(pasted.value(), scene);
    PastedObjects out;
    for (const ObjectId id : pasted.value().objects.ids()) out.added.push_back(copy.object(id));
    for (const LightId id : pasted.value().lights.ids()) out.lights.push_back(copy.light(id));
    for (const CameraId id : pasted.value().cameras.ids()) out.cameras.push_back(copy.camera(id));
    out.scene = copy.take();
    return out;
}

}  // namespace glint
