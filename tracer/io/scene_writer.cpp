#include "tracer/io/scene_writer.h"

#include "tracer/io/json_values.h"

namespace glint {

namespace {

class SceneWriter {
  public:
    SceneWriter(const Scene& scene, Defaults defaults)
        : scene_(scene), all_(defaults == Defaults::Written) {}

    Json run() {
        Json out = Json::object();
        out["glint"] = 1;
        if (scene_.activeCamera)
            out["camera"] = scene_.cameras.at(scene_.activeCamera).name;
        else
            addSection(out, "camera", scene_.camera);
        addTable(out, "cameras", scene_.cameras,
                 [&](const Camera& camera) { return fields(camera); });
        for (const Camera& view : scene_.views) out["views"].push_back(fields(view));
        addSection(out, "film", scene_.film);
        addSection(out, "display", scene_.display);
        addSection(out, "render", scene_.render);
        addSection(out, "environment", scene_.environment);
        addTable(out, "textures", scene_.textures,
                 [&](const Texture& texture) { return fields(texture); });
        addTable(out, "materials", scene_.materials,
                 [&](const Material& material) { return value(material); });
        addTable(out, "groups", scene_.groups, [&](const Group& group) { return fields(group); });
        addTable(out, "objects", scene_.objects,
                 [&](const Object& object) { return fields(object); });
        addTable(out, "lights", scene_.lights, [&](const Light& light) { return value(light); });
        addEditor(out);
        return out;
    }

  private:
    template <class T>
    void addSection(Json& out, const char* section, const T& value) {
        if (all_ || value != T{}) out[section] = fields(value);
    }

    template <class Table, class Entry>
    void addTable(Json& out, const char* section, const Table& table, Entry&& entry) {
        if (table.empty()) return;
        Json& list = out[section] = Json::array();
        table.forEach([&](auto, const auto& value) { list.push_back(entry(value)); });
    }

    void addEditor(Json& out) {
        if (scene_.editor.empty()) return;
        auto parsed = parseJson(scene_.editor, "");
        if (parsed && parsed.value().is_object()) out["editor"] = std::move(parsed).value();
    }

    template <class T>
    Json fields(const T& value) {
        Json out = Json::object();
        addFields(out, value);
        return out;
    }

    template <class T>
    void addFields(Json& out, const T& value) {
        [[maybe_unused]] static const T defaults{};
        std::apply(
            [&](const auto&... field) {
                (addField(out, field.name, field.meta, value.*field.member, defaults.*field.member),
                 ...);
            },
            T::fields());
    }

    template <class Member>
    void addField(Json& out, std::string_view name, const FieldMeta& meta, const Member& member,
                  const Member& byDefault) {
        if (!all_ && !meta.required && member == byDefault) return;
        Json json = value(member);
        if (!json.is_null()) out[std::string(name)] = std::move(json);
    }

    // value(): null where there is nothing to write.
    template <class T>
    Json value(const T& plain) {
        return toJson(plain);
    }
    Json value(MaterialId id) { return nameIn(scene_.materials, id); }
    Json value(GroupId id) { return nameIn(scene_.groups, id); }

    template <class T>
    Json value(const std::optional<T>& optional) {
        return optional ? value(*optional) : Json();
    }
    template <class T>
    Json value(const Textured<T>& textured) {
        if (!textured.texture) return toJson(textured.value);
        return Json{{"texture", nameIn(scene_.textures, textured.texture)}};
    }
    /// A part that was never chosen lets light through.
    Json value(const MixPart& part) {
        return part.material ? nameIn(scene_.materials, part.material) : Json("clear");
    }
    Json value(const Sky& sky) { return fields(sky); }
    /// The matrix replaces the other three, and a file must not hold both.
    Json value(const Transform& transform) {
        if (!transform.matrix) return fields(transform);
        return Json{{"matrix", toJson(*transform.matrix)}};
    }
    Json value(const Shape& shape) {
        Json out = Json::object();
        addKind(out, shape);
        return out;
    }
    Json value(const Material& material) {
        Json out{{"name", material.name}};
        addKind(out, material.value);
        return out;
    }
    Json value(const Light& light) {
        Json out{{"name", light.name}};
        addKind(out, light.value);
        addField(out, "visible", {}, light.visible, true);
        addField(out, "light_group", {}, light.lightGroup, std::string());
        return out;
    }

    template <class... Ts>
    void addKind(Json& out, const std::variant<Ts...>& variant) {
        out["type"] = std::string(kindOf(variant));
        std::visit([&](const auto& alternative) { addFields(out, alternative); }, variant);
    }

    template <class Table, class IdType>
    static Json nameIn(const Table& table, IdType id) {
        const auto* found = table.find(id);
        return found ? Json(found->name) : Json();
    }

    const Scene& scene_;
    bool all_;
};

}  // namespace

Json sceneJson(const Scene& scene, Defaults defaults) { return SceneWriter(scene, defaults).run(); }

}  // namespace glint
