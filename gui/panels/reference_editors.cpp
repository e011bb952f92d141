// Editors for fields that refer to something by name: material, group, texture, part of a mix.
#include <algorithm>
#include <set>

#include "gui/panels/field_editors.h"
#include "tracer/scene/edit.h"

namespace glint {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(FieldEditor)
};

template <class T>
Choice choiceOf(const FieldBinding<T>& binding, const QString& text, T value) {
    return {text,
            [binding, value](const Scene& scene) {
                const auto common = binding.common(scene);
                return common.value && *common.value == value;
            },
            [binding, value] { return binding.edit(value); }};
}

template <class T>
FieldEditor makeReference(const FieldBinding<T>& binding,
                          std::function<std::vector<Choice>(const Scene&)> choices,
                          QWidget* parent) {
    FieldEditor editor = makeChoiceEditor(
        std::move(choices), [binding](const Scene& scene) { return binding.common(scene).mixed; },
        binding.path, parent);
    editor.widget->setAccessibleName(binding.label);
    return editor;
}

/// Materials that `material` is made of, directly or by others, with itself.
void collectParts(const Scene& scene, MaterialId material, std::set<MaterialId>& out) {
    if (!material || !out.insert(material).second) return;
    if (const auto* mix = std::get_if<Mix>(&scene.materials.at(material).value)) {
        collectParts(scene, mix->a.material, out);
        collectParts(scene, mix->b.material, out);
    }
}

/// A mix may hold `part` if that does not hold one of the mixes itself.
bool canHold(const Scene& scene, const std::vector<std::uint32_t>& mixes, MaterialId part) {
    std::set<MaterialId> parts;
    collectParts(scene, part, parts);
    return std::none_of(mixes.begin(), mixes.end(),
                        [&](std::uint32_t mix) { return parts.contains(MaterialId{mix}); });
}

bool isWithin(const Scene& scene, GroupId group, const std::vector<std::uint32_t>& ancestors) {
    for (; group; group = scene.groups.at(group).parent)
        if (std::find(ancestors.begin(), ancestors.end(), group.value) != ancestors.end())
            return true;
    return false;
}

}  // namespace

FieldEditor makeEditor(const FieldBinding<MaterialId>& binding, QWidget* parent) {
    const auto choices = [binding](const Scene& scene) {
        std::vector<Choice> out{choiceOf(binding, Text::tr("None (black)"), MaterialId{})};
        scene.materials.forEach([&](MaterialId id, const Material& m) {
            out.push_back(choiceOf(binding, toQString(m.name), id));
        });
        out.push_back({Text::tr("New material"), {}, [binding] {
                           auto [next, id] = withMaterial(binding.document->committed(),
                                                          Material{"Material", Diffuse{}});
                           QString reason = binding.apply(next, id);
                           if (reason.isEmpty())
                               binding.document->edit(std::move(next), Text::tr("New material"));
                           return reason;
                       }});
        return out;
    };
    return makeReference(binding, choices, parent);
}

FieldEditor makeEditor(const FieldBinding<GroupId>& binding, QWidget* parent) {
    const bool ofGroups = binding.path.startsWith(QLatin1String("group"));
    const auto choices = [binding, ofGroups](const Scene& scene) {
        std::vector<Choice> out{choiceOf(binding, Text::tr("None"), GroupId{})};
        scene.groups.forEach([&](GroupId id, const Group& group) {
            if (!ofGroups || !isWithin(scene, id, *binding.targets))
                out.push_back(choiceOf(binding, toQString(group.name), id));
        });
        return out;
    };
    return makeReference(binding, choices, parent);
}

FieldEditor makeEditor(const FieldBinding<TextureId>& binding, QWidget* parent) {
    const auto choices = [binding](const Scene& scene) {
        std::vector<Choice> out{choiceOf(binding, Text::tr("No texture"), TextureId{})};
        scene.textures.forEach([&](TextureId id, const Texture& t) {
            out.push_back(choiceOf(binding, toQString(t.name), id));
        });
        return out;
    };
    return makeReference(binding, choices, parent);
}

FieldEditor makeEditor(const FieldBinding<MixPart>& binding, QWidget* parent) {
    const auto choices = [binding](const Scene& scene) {
        std::vector<Choice> out;
        // A scene may hold at most one "clear" in a mix; the lens refuses the second with its
        // reason.
        out.push_back(choiceOf(binding, Text::tr("Clear"), MixPart{{}, true}));
        scene.materials.forEach([&](MaterialId id, const Material& m) {
            if (canHold(scene, *binding.targets, id))
                out.push_back(choiceOf(binding, toQString(m.name), MixPart{id, false}));
        });
        return out;
    };
    return makeReference(binding, choices, parent);
}

}  // namespace glint
