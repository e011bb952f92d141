// Editors for one field each, by the field's type: numbers, colours, switches, texts, choices.
// makeEditor() gives a widget and how to show the scene's value in it; the widget writes through
// the binding. Start at FormBuilder (form_builder.h), which chooses among them.
#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gui/app/text.h"
#include "gui/panels/field_binding.h"

class QComboBox;

namespace glint {

/// A widget that edits a field. `refresh` is called after each change of the document.
struct FieldEditor {
    QWidget* widget = nullptr;
    std::function<void(const Scene&)> refresh;
};

FieldEditor makeEditor(const FieldBinding<double>& binding, QWidget* parent);
FieldEditor makeEditor(const FieldBinding<int>& binding, QWidget* parent);
FieldEditor makeEditor(const FieldBinding<bool>& binding, QWidget* parent);
FieldEditor makeEditor(const FieldBinding<std::string>& binding, QWidget* parent);
FieldEditor makeEditor(const FieldBinding<Color>& binding, QWidget* parent);
FieldEditor makeEditor(const FieldBinding<DVec2>& binding, QWidget* parent);
FieldEditor makeEditor(const FieldBinding<DVec3>& binding, QWidget* parent);
FieldEditor makeEditor(const FieldBinding<std::array<double, 12>>& binding, QWidget* parent);
FieldEditor makeEditor(const FieldBinding<std::vector<Color>>& binding, QWidget* parent);
FieldEditor makeEditor(const FieldBinding<MaterialId>& binding, QWidget* parent);
FieldEditor makeEditor(const FieldBinding<GroupId>& binding, QWidget* parent);
FieldEditor makeEditor(const FieldBinding<TextureId>& binding, QWidget* parent);
FieldEditor makeEditor(const FieldBinding<MixPart>& binding, QWidget* parent);

/// A list of choices bound to a field of any type.
struct Choice {
    QString text;
    std::function<bool(const Scene&)> isCurrent;
    std::function<QString()> choose;  ///< the reason if refused
};
/// `choices` is asked again after each change, as names come and go.
FieldEditor makeChoiceEditor(std::function<std::vector<Choice>(const Scene&)> choices,
                             std::function<bool(const Scene&)> mixed, const QString& path,
                             QWidget* parent);

template <class Enum>
requires std::is_enum_v<Enum> FieldEditor makeEditor(const FieldBinding<Enum>& binding,
                                                     QWidget* parent) {
    const auto choices = [binding](const Scene&) {
        std::vector<Choice> out;
        for (std::size_t i = 0; i < enumNames(Enum{}).size(); ++i) {
            const auto value = static_cast<Enum>(i);
            out.push_back({labelOf(enumNames(Enum{})[i]),
                           [binding, value](const Scene& scene) {
                               const auto common = binding.common(scene);
                               return common.value && *common.value == value;
                           },
                           [binding, value] { return binding.edit(value); }});
        }
        return out;
    };
    return makeChoiceEditor(
        choices, [binding](const Scene& scene) { return binding.common(scene).mixed; },
        binding.path, parent);
}

}  // namespace glint
