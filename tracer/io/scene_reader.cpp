#include "tracer/io/scene_reader.h"

#include "tracer/io/field_reader.h"

namespace glint {

namespace {

constexpr FieldMeta kRequired{.required = true};
constexpr FieldMeta kOptional{};

const std::vector<std::string_view>& sectionNames() {
    static const std::vector<std::string_view> names{
        "glint",       "camera",   "cameras",   "views",  "film",    "display", "render",
        "environment", "textures", "materials", "groups", "objects", "lights",  "editor"};
    return names;
}

void indexNames(const Json& root, std::string_view section, NameIndex& names, FieldReader& reader) {
    const auto list = root.find(section);
    if (list == root.end() || !list->is_array()) return;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Json& entry = (*list)[i];
        const auto name = entry.is_object() ? entry.find("name") : entry.end();
        if (!entry.is_object() || name == entry.end() || !name->is_string()) continue;
        const std::string& text = name->get_ref<const std::string&>();
        if (names.add(text, static_cast<std::uint32_t>(i + 1))) continue;
        const JsonPath top, sectionAt = top.child(section), at = sectionAt.child(i);
        reader.fail(at.child("name"),
                    "the name " + inQuotes(text) + " is taken by /" + std::string(section) + "/" +
                        std::to_string(names.find(text) - 1),
                    "give each a name of its own");
    }
}

SceneNames sceneNames(const Json& root, std::vector<Error>& errors) {
    SceneNames names;
    FieldReader reader(names);
    indexNames(root, "objects", names.objects, reader);
    indexNames(root, "groups", names.groups, reader);
    indexNames(root, "materials", names.materials, reader);
    indexNames(root, "textures", names.textures, reader);
    indexNames(root, "lights", names.lights, reader);
    indexNames(root, "cameras", names.cameras, reader);
    errors = std::move(reader.errors());
    return names;
}

class SceneReader {
  public:
    SceneReader(const Json& root, const SceneNames& names) : root_(root), reader_(names) {}

    Scene read() {
        readVersion();
        reader_.checkKeys(root_, top_, sectionNames());
        readCamera();
        readTable("cameras", scene_.cameras,
                  [&](const Json& json, const JsonPath& at, Camera& camera) {
                      reader_.readFields(json, at, camera, {});
                      std::string name;
                      reader_.readMember(json, at, "name", kRequired, name);
                  });
        readViews();
        readSection("film", scene_.film);
        readSection("display", scene_.display);
        readSection("render", scene_.render);
        readSection("environment", scene_.environment);
        readTable("textures", scene_.textures,
                  [&](const Json& json, const JsonPath& at, Texture& texture) {
                      reader_.readFields(json, at, texture, {});
                  });
        readTable("materials", scene_.materials,
                  [&](const Json& json, const JsonPath& at, Material& material) {
                      reader_.readMember(json, at, "name", kRequired, material.name);
                      reader_.readKind<AllMaterials>(json, at, material.value, {"name"});
                  });
        readTable("groups", scene_.groups, [&](const Json& json, const JsonPath& at, Group& group) {
            reader_.readFields(json, at, group, {});
        });
        readTable("objects", scene_.objects,
                  [&](const Json& json, const JsonPath& at, Object& object) {
                      reader_.readFields(json, at, object, {});
                  });
        readTable("lights", scene_.lights, [&](const Json& json, const JsonPath& at, Light& light) {
            reader_.readMember(json, at, "name", kRequired, light.name);
            reader_.readKind<AllLights>(json, at, light.value, {"name", "visible", "light_group"});
            reader_.readMember(json, at, "visible", kOptional, light.visible);
            reader_.readMember(json, at, "light_group", kOptional, light.lightGroup);
        });
        readEditor();
        return std::move(scene_);
    }

    [[nodiscard]] std::vector<Error>& errors() { return reader_.errors(); }

  private:
    void readVersion() {
        int version = 1;
        reader_.readMember(root_, top_, "glint", {.min = 1, .required = true}, version);
        if (version > 1)
            reader_.fail(top_.child("glint"),
                         "the file has version " + std::to_string(version) +
                             " of the format, this program knows 1",
                         "open it with a newer Glint");
    }

    void readCamera() {
        const auto found = root_.find("camera");
        if (found != root_.end() && found->is_string())
            reader_.read(*found, kOptional, top_.child("camera"), scene_.activeCamera);
        else
            readSection("camera", scene_.camera);
    }

    void readViews() {
        const Json* list = findList("views");
        const JsonPath at = top_.child("views");
        for (std::size_t i = 0; list && i < list->size(); ++i)
            scene_.views.push_back(
                entry<Camera>((*list)[i], at.child(i),
                              [&](const Json& json, const JsonPath& where, Camera& view) {
                                  reader_.readFields(json, where, view, {});
                              }));
    }

    void readEditor() {
        const auto found = root_.find("editor");
        if (found == root_.end()) return;
        if (found->is_object())
            scene_.editor = formatJsonLine(*found);
        else
            reader_.fail(top_.child("editor"), "expected an object", "remove it");
    }

    template <class T>
    void readSection(std::string_view section, T& out) {
        const auto found = root_.find(section);
        if (found == root_.end()) return;
        out = entry<T>(*found, top_.child(section),
                       [&](const Json& json, const JsonPath& at, T& value) {
                           reader_.readFields(json, at, value, {});
                       });
    }

    template <class T, class IdType, class Read>
    void readTable(std::string_view section, Table<T, IdType>& out, Read&& read) {
        const Json* list = findList(section);
        if (!list) return;
        const JsonPath at = top_.child(section);
        std::vector<T> values;
        values.reserve(list->size());
        for (std::size_t i = 0; i < list->size(); ++i)
            values.push_back(entry<T>((*list)[i], at.child(i), read));
        out.addAll(std::move(values));
    }

    /// One value; a default one if it has errors.
    template <class T, class Read>
    T entry(const Json& json, const JsonPath& at, Read&& read) {
        const std::size_t before = reader_.errors().size();
        T value{};
        read(json, at, value);
        return reader_.errors().size() == before ? value : T{};
    }

    const Json* findList(std::string_view section) {
        const auto found = root_.find(section);
        if (found == root_.end()) return nullptr;
        if (found->is_array()) return &*found;
        reader_.fail(top_.child(section), "expected a list", "write it as [...]");
        return nullptr;
    }

    const Json& root_;
    const JsonPath top_;
    FieldReader reader_;
    Scene scene_;
};

}  // namespace

SceneReading readScene(const Json& root) {
    if (!root.is_object())
        return {{},
                {{.message = "a scene is a JSON object", .remedy = "begin with {\"glint\": 1"}}};
    SceneReading out;
    const SceneNames names = sceneNames(root, out.errors);
    SceneReader reader(root, names);
    out.scene = reader.read();
    out.errors.insert(out.errors.end(), reader.errors().begin(), reader.errors().end());
    return out;
}

}  // namespace glint
