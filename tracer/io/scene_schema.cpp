// The JSON Schema of scene files, from the same field tables that read and write them.
#include "tracer/io/json_values.h"
#include "tracer/io/scene_json.h"

namespace glint {

namespace {

template <class T>
concept HasFields = requires {
    T::fields();
};

Json reference(std::string_view definition) {
    return Json{{"$ref", "#/$defs/" + std::string(definition)}};
}

Json nameOf(std::string_view what) {
    return Json{{"type", "string"}, {"description", "Name of a " + std::string(what)}};
}

Json numberSchema(const char* type, const FieldMeta& meta) {
    Json out{{"type", type}};
    if (meta.min > -kInfinity) out[meta.exclusiveMin ? "exclusiveMinimum" : "minimum"] = meta.min;
    if (meta.max < kInfinity) out["maximum"] = meta.max;
    return out;
}

Json listSchema(Json items, std::size_t least, std::size_t most) {
    Json out{{"type", "array"}, {"items", std::move(items)}, {"minItems", least}};
    out["maxItems"] = most;
    return out;
}

Json vectorSchema(const FieldMeta& meta, std::size_t size) {
    return listSchema(numberSchema("number", meta), size, size);
}

template <class Names>
Json choiceSchema(const Names& names) {
    Json list = Json::array();
    for (const std::string_view name : names) list.push_back(std::string(name));
    return Json{{"enum", std::move(list)}};
}

// valueSchema(): what a field of the type may hold; the value only names the type.
Json valueSchema(double, const FieldMeta& meta) { return numberSchema("number", meta); }
Json valueSchema(int, const FieldMeta& meta) { return numberSchema("integer", meta); }
Json valueSchema(bool, const FieldMeta&) { return Json{{"type", "boolean"}}; }
Json valueSchema(const std::string&, const FieldMeta& meta) {
    Json out{{"type", "string"}};
    if (meta.required) out["minLength"] = 1;
    return out;
}
Json valueSchema(const Color&, const FieldMeta& meta) { return vectorSchema(meta, 3); }
Json valueSchema(const DVec2&, const FieldMeta& meta) { return vectorSchema(meta, 2); }
Json valueSchema(const DVec3&, const FieldMeta& meta) { return vectorSchema(meta, 3); }
Json valueSchema(const std::array<double, 12>&, const FieldMeta& meta) {
    return vectorSchema(meta, 12);
}
Json valueSchema(const std::vector<Color>&, const FieldMeta& meta) {
    return Json{{"type", "array"}, {"items", vectorSchema(meta, 3)}};
}
Json valueSchema(const MaterialId&, const FieldMeta&) { return nameOf("material"); }
Json valueSchema(const GroupId&, const FieldMeta&) { return nameOf("group"); }
Json valueSchema(const MixPart&, const FieldMeta&) { return nameOf("material, or \"clear\""); }
Json valueSchema(const Shape&, const FieldMeta&) { return reference("shape"); }
Json valueSchema(const Transform&, const FieldMeta&) { return reference("transform"); }
template <class E>
requires std::is_enum_v<E> Json valueSchema(E value, const FieldMeta&) {
    return choiceSchema(enumNames(value));
}
template <HasFields T>
Json valueSchema(const T& value, const FieldMeta&);
template <class T>
Json valueSchema(const Textured<T>& textured, const FieldMeta& meta) {
    return Json{
        {"anyOf", Json::array({valueSchema(textured.value, meta), reference("texture_name")})}};
}
template <class T>
Json valueSchema(const std::optional<T>&, const FieldMeta& meta) {
    return valueSchema(T{}, meta);
}

// addDefault(): nothing for what has no value of its own in a file.
template <class T>
concept Plain = requires(const T& value) {
    toJson(value);
};
template <Plain T>
void addDefault(Json& schema, const T& value) {
    schema["default"] = toJson(value);
}
template <class T>
void addDefault(Json& schema, const Textured<T>& textured) {
    schema["default"] = toJson(textured.value);
}
template <class T>
void addDefault(Json&, const T&) {}

std::string described(const FieldMeta& meta) {
    std::string out(meta.doc);
    if (!meta.unit.empty()) out += " [" + std::string(meta.unit) + "]";
    return out;
}

template <class T>
void addFields(Json& schema, const T& defaults) {
    forEachField(defaults, [&](std::string_view name, const FieldMeta& meta, const auto& member) {
        Json field = valueSchema(member, meta);
        if (!meta.doc.empty()) field["description"] = described(meta);
        if (meta.required)
            schema["required"].push_back(std::string(name));
        else
            addDefault(field, member);
        schema["properties"][std::string(name)] = std::move(field);
    });
}

Json emptyObject() {
    return Json{{"type", "object"},
                {"properties", Json::object()},
                {"required", Json::array()},
                {"additionalProperties", false}};
}

template <class T>
Json objectSchema() {
    Json out = emptyObject();
    addFields(out, T{});
    return out;
}

template <HasFields T>
Json valueSchema(const T&, const FieldMeta&) {
    return objectSchema<T>();
}

/// One object schema for each kind of a list; `more` adds the keys around the kind's own.
template <class List, class More>
Json kindsSchema(More&& more) {
    Json kinds = Json::array();
    List::forEach([&](const auto& value) {
        Json kind = emptyObject();
        more(kind);
        kind["properties"]["type"] = Json{{"const", std::string(value.kind)}};
        kind["required"].push_back("type");
        addFields(kind, value);
        kinds.push_back(std::move(kind));
    });
    return Json{{"oneOf", std::move(kinds)}};
}

void addName(Json& schema) {
    schema["properties"]["name"] =
        Json{{"type", "string"}, {"minLength", 1}, {"description", "Unique name"}};
    schema["required"].push_back("name");
}

Json lightSchema() {
    return kindsSchema<AllLights>([](Json& kind) {
        addName(kind);
        kind["properties"]["visible"] =
            Json{{"type", "boolean"}, {"description", "Part of the picture"}, {"default", true}};
        kind["properties"]["light_group"] = Json{
            {"type", "string"}, {"description", "Group of lights it belongs to"}, {"default", ""}};
    });
}

Json definitions() {
    Json out = Json::object();
    out["texture_name"] = Json{{"type", "object"},
                               {"properties", {{"texture", nameOf("texture")}}},
                               {"required", {"texture"}},
                               {"additionalProperties", false}};
    out["transform"] = objectSchema<Transform>();
    out["shape"] = kindsSchema<AllShapes>([](Json&) {});
    out["camera"] = objectSchema<Camera>();
    out["named_camera"] = out["camera"];
    out["named_camera"]["required"] = {"name"};
    out["texture"] = objectSchema<Texture>();
    out["material"] = kindsSchema<AllMaterials>(addName);
    out["group"] = objectSchema<Group>();
    out["object"] = objectSchema<Object>();
    out["light"] = lightSchema();
    return out;
}

Json listOf(const char* definition) {
    return Json{{"type", "array"}, {"items", reference(definition)}};
}

}  // namespace

std::string sceneSchema() {
    Json properties = Json::object();
    properties["glint"] = Json{{"const", 1}, {"description", "Version of the format"}};
    properties["camera"] = Json{{"anyOf", Json::array({reference("camera"), nameOf("camera")})}};
    properties["cameras"] = listOf("named_camera");
    properties["views"] = listSchema(reference("camera"), 0, 9);
    properties["film"] = objectSchema<FilmSettings>();
    properties["display"] = objectSchema<Display>();
    properties["render"] = objectSchema<RenderSettings>();
    properties["environment"] = objectSchema<Environment>();
    properties["textures"] = listOf("texture");
    properties["materials"] = listOf("material");
    properties["groups"] = listOf("group");
    properties["objects"] = listOf("object");
    properties["lights"] = listOf("light");
    properties["editor"] =
        Json{{"type", "object"}, {"description", "Layout of the editor's window and the like"}};

    Json schema = Json::object();
    schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
    schema["title"] = "Glint scene, version 1";
    schema["type"] = "object";
    schema["properties"] = std::move(properties);
    schema["required"] = Json::array({"glint"});
    schema["additionalProperties"] = false;
    schema["$defs"] = definitions();
    return formatJson(schema);
}

}  // namespace glint
