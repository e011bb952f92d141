#include "tests/support/schema_check.h"

#include <algorithm>
#include <set>

namespace glint::test {

namespace {

using Json = nlohmann::json;

class Validator {
  public:
    explicit Validator(const Json& root) : root_(root) {}

    std::string fault(const Json& schema, const Json& value, const std::string& at) const {
        static const std::set<std::string> handled{"$schema",
                                                   "$defs",
                                                   "title",
                                                   "description",
                                                   "default",
                                                   "$ref",
                                                   "const",
                                                   "enum",
                                                   "type",
                                                   "minimum",
                                                   "maximum",
                                                   "exclusiveMinimum",
                                                   "minLength",
                                                   "items",
                                                   "minItems",
                                                   "maxItems",
                                                   "properties",
                                                   "required",
                                                   "additionalProperties",
                                                   "anyOf",
                                                   "oneOf"};
        for (const auto& [keyword, unused] : schema.items())
            if (!handled.contains(keyword)) return at + ": unknown keyword " + keyword;
        if (schema.contains("$ref")) {
            const std::string reference = schema["$ref"];
            return fault(root_.at(Json::json_pointer(reference.substr(1))), value, at);
        }
        for (const auto check : {&Validator::scalarFault, &Validator::listFault,
                                 &Validator::objectFault, &Validator::choiceFault})
            if (std::string found = (this->*check)(schema, value, at); !found.empty()) return found;
        return "";
    }

  private:
    static bool hasType(const Json& value, const std::string& type) {
        if (type == "integer") return value.is_number_integer();
        if (type == "number") return value.is_number();
        return value.type_name() == type;
    }

    std::string scalarFault(const Json& schema, const Json& value, const std::string& at) const {
        if (schema.contains("type") && !hasType(value, schema["type"]))
            return at + ": not of type " + schema["type"].dump();
        if (schema.contains("const") && schema["const"] != value)
            return at + ": not " + schema["const"].dump();
        if (schema.contains("enum") &&
            std::find(schema["enum"].begin(), schema["enum"].end(), value) == schema["enum"].end())
            return at + ": not one of " + schema["enum"].dump();
        if (!value.is_number()) return "";
        const double number = value;
        const bool good = number >= schema.value("minimum", number) &&
                          number <= schema.value("maximum", number) &&
                          (!schema.contains("exclusiveMinimum") ||
                           number > schema["exclusiveMinimum"].get<double>());
        return good ? "" : at + ": out of range";
    }

    std::string listFault(const Json& schema, const Json& value, const std::string& at) const {
        if (!value.is_array()) return "";
        if (value.size() < schema.value("minItems", std::size_t{0}) ||
            value.size() > schema.value("maxItems", value.size()))
            return at + ": wrong number of items";
        for (std::size_t i = 0; schema.contains("items") && i < value.size(); ++i)
            if (std::string found = fault(schema["items"], value[i], at + "/" + std::to_string(i));
                !found.empty())
                return found;
        return "";
    }

    std::string objectFault(const Json& schema, const Json& value, const std::string& at) const {
        if (!value.is_object() || !schema.contains("properties")) return "";
        for (const auto& name : schema.value("required", Json::array()))
            if (!value.contains(name.get<std::string>())) return at + ": lacks " + name.dump();
        for (const auto& [name, member] : value.items()) {
            if (!schema["properties"].contains(name)) return at + ": has the unknown " + name;
            if (std::string found = fault(schema["properties"][name], member, at + "/" + name);
                !found.empty())
                return found;
        }
        return "";
    }

    std::string choiceFault(const Json& schema, const Json& value, const std::string& at) const {
        for (const char* keyword : {"anyOf", "oneOf"}) {
            if (!schema.contains(keyword)) continue;
            const auto fits =
                std::count_if(schema[keyword].begin(), schema[keyword].end(),
                              [&](const Json& option) { return fault(option, value, at).empty(); });
            if (fits == 0 || (fits > 1 && std::string(keyword) == "oneOf"))
                return at + ": fits " + std::to_string(fits) + " of the " + keyword;
        }
        return "";
    }

    const Json& root_;
};

}  // namespace

std::string schemaFault(const Json& schema, const Json& value) {
    return Validator(schema).fault(schema, value, "");
}

}  // namespace glint::test
