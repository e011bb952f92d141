// FormBuilder: from a field table to a form. Walks a struct's fields() and puts one row for each
// into sections: plain fields into the struct's own, nested structs and variants into sections of
// theirs.
#pragma once

#include <QString>
#include <functional>
#include <type_traits>
#include <vector>

#include "gui/app/text.h"
#include "gui/panels/field_editors.h"
#include "gui/widgets/section.h"

class QVBoxLayout;

namespace glint {

template <class T>
concept HasFields = requires {
    T::fields();
};
template <class T>
inline constexpr bool kIsVariant = false;
template <class... Ts>
inline constexpr bool kIsVariant<std::variant<Ts...>> = true;
template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;
template <class T>
inline constexpr bool kIsTextured = false;
template <class T>
inline constexpr bool kIsTextured<Textured<T>> = true;

class FormBuilder {
  public:
    /// Sections are added to `parent`'s layout; `document` and `targets` go into every binding.
    FormBuilder(Document& document, Targets targets, QWidget* parent);

    /// A section for a struct with the prefix of its paths, e.g. "object".
    template <HasFields T>
    void addStruct(const QString& title, const QString& path, const Lens<T>& lens) {
        Section* section = addSection(title);
        const T initial{};
        std::apply(
            [&](const auto&... field) { (addField(section, path, lens, field, initial), ...); },
            T::fields());
    }

    /// A choice of the type and the fields of the one that the targets hold. Fields of other types
    /// are left out.
    template <class List>
    void addVariant(const QString& title, const QString& path,
                    const Lens<typename List::Variant>& lens,
                    std::function<QString(std::string_view)> changeKind) {
        addVariantRows<List>(addSection(title), path, lens, std::move(changeKind));
    }
    template <class List>
    void addVariantRows(Section* section, const QString& path,
                        const Lens<typename List::Variant>& lens,
                        std::function<QString(std::string_view)> changeKind) {
        addKind<List>(section, path, lens, std::move(changeKind));
        addAlternatives<List>(section, path, lens);
    }

    Section* addSection(const QString& title);
    [[nodiscard]] Document& document() const { return document_; }
    [[nodiscard]] const Targets& targets() const { return targets_; }

    template <class T>
    [[nodiscard]] FieldBinding<T> bind(const Lens<T>& lens, const QString& path,
                                       std::string_view name, const FieldMeta& meta,
                                       T initial) const {
        return {&document_,    lens, targets_,          path + '.' + toQString(name),
                labelOf(name), meta, std::move(initial)};
    }

    /// One row of a section.
    template <class T>
    void addRow(Section* section, const FieldBinding<T>& binding) {
        if constexpr (kIsOptional<T>)
            addOptional(section, binding);
        else if constexpr (kIsTextured<T>)
            addTextured(section, binding);
        else
            placeRow(section, binding.label, binding.meta, makeEditor(binding, section),
                     resetOf(binding));
    }
    /// Whether a row's value differs from its default, and how to go back to that.
    struct Reset {
        std::function<bool(const Scene&)> differs;
        std::function<void()> run;
    };
    void placeRow(Section* section, const QString& label, const FieldMeta& meta, FieldEditor editor,
                  const Reset& reset);
    void addRefresh(std::function<void(const Scene&)> refresh) {
        refreshes_.push_back(std::move(refresh));
    }
    [[nodiscard]] std::vector<std::function<void(const Scene&)>> takeRefreshes() {
        return std::move(refreshes_);
    }

  private:
    template <class T>
    static Reset resetOf(const FieldBinding<T>& binding) {
        return {[binding](const Scene& scene) {
                    const auto common = binding.common(scene);
                    return common.mixed || (common.value && !(*common.value == binding.initial));
                },
                [binding] { binding.edit(binding.initial); }};
    }

    template <class Owner, class Member>
    void addField(Section* section, const QString& path, const Lens<Owner>& lens,
                  const Field<Owner, Member>& field, const Owner& initial) {
        const QString name = toQString(field.name);
        const Lens<Member> member = memberOf(lens, field.member);
        if constexpr (HasFields<Member>) {
            addStruct(labelOf(field.name), path + '.' + name, member);
        } else if constexpr (kIsVariant<Member>) {
            static_assert(!sizeof(Member), "variants have their own sections: see PropertyPanel");
        } else {
            addRow(section, bind(member, path, field.name, field.meta, initial.*field.member));
        }
    }

    template <class List>
    void addKind(Section* section, const QString& path, const Lens<typename List::Variant>& lens,
                 std::function<QString(std::string_view)> changeKind) {
        const FieldBinding<typename List::Variant> whole{&document_, lens, targets_, path + ".type",
                                                         {},         {},   {}};
        const auto choices = [whole, changeKind](const Scene&) {
            std::vector<Choice> out;
            for (const std::string_view kind : List::kinds)
                out.push_back({labelOf(kind),
                               [whole, kind](const Scene& scene) {
                                   const auto common = whole.common(scene);
                                   return common.value && kindOf(*common.value) == kind;
                               },
                               [changeKind, kind] { return changeKind(kind); }});
            return out;
        };
        const auto mixed = [whole](const Scene& scene) {
            std::string_view first;
            for (const std::uint32_t target : *whole.targets)
                if (const auto* value = whole.lens.get(scene, target)) {
                    if (!first.empty() && kindOf(*value) != first) return true;
                    first = kindOf(*value);
                }
            return false;
        };
        placeRow(section, QCoreApplication::translate("Field", "Type"), {},
                 makeChoiceEditor(choices, mixed, path + ".type", section), {});
    }

    template <class List>
    void addAlternatives(Section* section, const QString& path,
                         const Lens<typename List::Variant>& lens) {
        const std::string_view kind = commonKind(lens);
        List::withKind(kind, [&]<class T>(const T& initial) {
            const Lens<T> alternative = alternativeOf<T>(lens);
            std::apply(
                [&](const auto&... field) {
                    (addField(section, path, alternative, field, initial), ...);
                },
                T::fields());
        });
    }

    /// The kind that all targets hold; empty if they differ.
    template <class Variant>
    std::string_view commonKind(const Lens<Variant>& lens) const {
        std::string_view kind;
        for (const std::uint32_t target : *targets_) {
            const Variant* value = lens.get(document_.scene(), target);
            if (!value || (!kind.empty() && kindOf(*value) != kind)) return {};
            kind = kindOf(*value);
        }
        return kind;
    }

    /// A check box in front of the editor: on gives the default value, off empties the field.
    template <class T>
    void addOptional(Section* section, const FieldBinding<std::optional<T>>& binding) {
        const FieldBinding<T> content =
            binding.part(contentOf(binding.lens), QString(), contentDefault<T>());
        const auto isSet = [binding](const Scene& scene) {
            const auto common = binding.common(scene);
            return common.value && common.value->has_value();
        };
        const auto set = [binding, content](bool on) {
            return binding.edit(on ? std::optional<T>(content.initial) : std::nullopt);
        };
        if constexpr (HasFields<T>) {
            placeRow(section, binding.label, binding.meta,
                     makeSwitch(nullptr, binding.path, isSet, set, section), {});
            if (isSet(document_.scene())) addStruct(binding.label, binding.path, content.lens);
        } else {
            const FieldEditor inner = makeEditor(content, section);
            FieldEditor row = makeSwitch(inner.widget, binding.path, isSet, set, section);
            placeRow(
                section, binding.label, binding.meta,
                {row.widget,
                 [row, inner](const Scene& scene) { inner.refresh(scene), row.refresh(scene); }},
                {});
        }
    }

    /// The constant, and a choice of texture once the scene holds any.
    template <class T>
    void addTextured(Section* section, const FieldBinding<Textured<T>>& binding) {
        const auto value = binding.part(memberOf(binding.lens, &Textured<T>::value), QString(),
                                        binding.initial.value);
        addRow(section, value);
        if (document_.scene().textures.empty()) return;
        auto texture =
            binding.part(memberOf(binding.lens, &Textured<T>::texture), ".texture", TextureId{});
        texture.label = QCoreApplication::translate("Field", "  by texture");
        addRow(section, texture);
    }

    /// What an empty optional becomes when it is switched on.
    template <class T>
    [[nodiscard]] static T contentDefault() {
        if constexpr (std::is_same_v<T, Color>)
            return {1, 1, 1};
        else if constexpr (std::is_same_v<T, double>)
            return 1;
        else if constexpr (std::is_same_v<T, std::array<double, 12>>)
            return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
        else
            return {};
    }

    FieldEditor makeSwitch(QWidget* content, const QString& path,
                           std::function<bool(const Scene&)> isSet,
                           std::function<QString(bool)> set, QWidget* parent);

    Document& document_;
    Targets targets_;
    QWidget* parent_;
    QVBoxLayout* layout_;
    std::vector<std::function<void(const Scene&)>> refreshes_;
};

}  // namespace glint
