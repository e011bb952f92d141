// Opening a scene in part: what has errors goes, and what referred to it says so.
#include <charconv>
#include <set>
#include <unordered_map>

#include "tracer/io/scene_reader.h"

namespace glint {

namespace {

/// What the errors' pointers name: entries of lists by index, and whole sections.
struct Faults {
    std::unordered_map<std::string, std::set<std::size_t>> entries;
    std::set<std::string> sections;
};

Faults faultsOf(const std::vector<Error>& errors) {
    Faults out;
    for (const Error& error : errors) {
        const std::vector<std::string> tokens = pointerTokens(error.pointer);
        if (tokens.empty()) continue;
        out.sections.insert(tokens[0]);
        std::size_t index = 0;
        if (tokens.size() < 2) continue;
        const std::string& token = tokens[1];
        if (std::from_chars(token.data(), token.data() + token.size(), index).ec == std::errc{})
            out.entries[tokens[0]].insert(index);
    }
    return out;
}

class Remover {
  public:
    Remover(Scene& scene, std::vector<Error>& errors)
        : scene_(scene), errors_(errors), faults_(faultsOf(errors)) {}

    void run() {
        if (faults_.sections.contains("camera")) scene_.camera = {};
        if (faults_.sections.contains("film")) scene_.film = {};
        if (faults_.sections.contains("display")) scene_.display = {};
        if (faults_.sections.contains("render")) scene_.render = {};
        if (faults_.sections.contains("environment")) scene_.environment = {};
        removeViews();
        remove(scene_.cameras, "cameras");
        remove(scene_.textures, "textures");
        remove(scene_.materials, "materials");
        remove(scene_.groups, "groups");
        remove(scene_.objects, "objects");
        remove(scene_.lights, "lights");
        mendReferences();
    }

  private:
    template <class Table>
    void remove(Table& table, const std::string& section) {
        // Entry i of a file has the id i + 1.
        const auto ids = table.ids();
        for (const std::size_t index : faults_.entries[section])
            if (index < ids.size()) table.erase(ids[index]);
    }

    void removeViews() {
        std::vector<Camera> kept;
        const std::set<std::size_t>& faulty = faults_.entries["views"];
        for (std::size_t i = 0; i < scene_.views.size(); ++i)
            if (!faulty.contains(i)) kept.push_back(scene_.views[i]);
        scene_.views = std::move(kept);
    }

    void mendReferences() {
        if (scene_.activeCamera && !scene_.cameras.find(scene_.activeCamera)) {
            scene_.activeCamera = {};
            say("/camera", "the scene's camera was left out", "the first view is a standard one");
        }
        mend(scene_.groups, "groups",
             [&](Group& group, const std::string& at) { mendParent(group, at); });
        mend(scene_.materials, "materials", [&](Material& material, const std::string& at) {
            std::visit([&](auto& value) { mendFields(value, at); }, material.value);
        });
        mend(scene_.objects, "objects", [&](Object& object, const std::string& at) {
            mendParent(object, at);
            if (!object.material || scene_.materials.find(object.material)) return;
            object.material = {};
            say(at + "/material", inQuotes(object.name) + " lost its material, which was left out",
                "give it another");
        });
    }

    /// Calls `mendOne(value, pointer)` on a copy of each entry and puts back the changed ones.
    template <class Table, class Mend>
    void mend(Table& table, const std::string& section, Mend&& mendOne) {
        for (const auto id : table.ids()) {
            const std::size_t said = errors_.size();
            auto value = table.at(id);
            mendOne(value, "/" + section + "/" + std::to_string(id.value - 1));
            if (errors_.size() > said) table.set(id, std::move(value));
        }
    }

    template <class T>
    void mendParent(T& value, const std::string& at) {
        if (!value.parent || scene_.groups.find(value.parent)) return;
        value.parent = {};
        say(at + "/parent", inQuotes(value.name) + " lost its group, which was left out",
            "check its place");
    }

    template <class T>
    void mendFields(T& material, const std::string& at) {
        forEachField(material, [&](std::string_view name, const FieldMeta&, auto& member) {
            mendField(member, at + "/" + std::string(name));
        });
    }

    template <class T>
    void mendField(Textured<T>& field, const std::string& at) {
        if (!field.texture || scene_.textures.find(field.texture)) return;
        field.texture = {};
        say(at, "lost its texture, which was left out", "give it another");
    }

    void mendField(MixPart& part, const std::string& at) {
        if (part.clear || scene_.materials.find(part.material)) return;
        part = {{}, true};
        say(at, "lost its material, which was left out; it is clear now", "give it another");
    }

    template <class T>
    void mendField(T&, const std::string&) {}

    void say(std::string pointer, std::string message, std::string remedy) {
        errors_.push_back({.message = std::move(message),
                           .pointer = std::move(pointer),
                           .remedy = std::move(remedy)});
    }

    Scene& scene_;
    std::vector<Error>& errors_;
    Faults faults_;
};

}  // namespace

Scene withoutFaults(Scene scene, std::vector<Error>& errors) {
    Remover(scene, errors).run();
    return scene;
}

}  // namespace glint
