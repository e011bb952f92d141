#include "gui/panels/field_editors.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QToolButton>
#include <QToolTip>

#include "gui/widgets/color_button.h"
#include "gui/widgets/drag_number.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/ignore_wheel.h"

namespace glint {

namespace {

NumberRange rangeOf(const FieldMeta& meta, bool integer) {
    return {meta.min, meta.max, meta.exclusiveMin, integer};
}

/// A DragNumber bound to a double or an int.
template <class Number>
FieldEditor makeNumber(const FieldBinding<Number>& binding, QWidget* parent) {
    auto* number = new DragNumber(parent);
    number->setRange(rangeOf(binding.meta, std::is_integral_v<Number>));
    number->setUnit(toQString(binding.meta.unit));
    number->setObjectName(binding.path);
    number->setAccessibleName(binding.label);
    QObject::connect(number, &DragNumber::previewed, number,
                     [binding](double v) { binding.preview(static_cast<Number>(v)); });
    QObject::connect(number, &DragNumber::edited, number, [binding, number](double v) {
        if (const QString reason = binding.edit(static_cast<Number>(v)); !reason.isEmpty())
            number->refuse(reason);
    });
    QObject::connect(number, &DragNumber::canceled, number,
                     [binding] { binding.document->cancelPreview(); });
    return {number, [binding, number](const Scene& scene) {
                const auto common = binding.common(scene);
                number->setEnabled(common.value != nullptr);
                if (common.mixed || !common.value)
                    number->setMixed();
                else
                    number->setValue(static_cast<double>(*common.value));
            }};
}

/// Several numbers side by side, `columns` in a row.
template <class Vector>
FieldEditor makeNumbers(const FieldBinding<Vector>& binding, std::size_t count, int columns,
                        QWidget* parent) {
    auto* box = new QWidget(parent);
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(2);
    std::vector<std::function<void(const Scene&)>> refreshes;
    for (std::size_t i = 0; i < count; ++i) {
        auto part = binding.part(componentOf(binding.lens, i), QStringLiteral(".%1").arg(i), 0.0);
        // A unit behind each of three narrow numbers would crowd them out: the label's tool tip
        // tells it.
        part.meta.unit = binding.meta.unit == "deg" ? "deg" : "";
        const FieldEditor editor = makeNumber(part, box);
        const auto index = static_cast<int>(i);
        grid->addWidget(editor.widget, index / columns, index % columns);
        refreshes.push_back(editor.refresh);
    }
    return {box, [refreshes](const Scene& scene) {
                for (const auto& refresh : refreshes) refresh(scene);
            }};
}

}  // namespace

FieldEditor makeEditor(const FieldBinding<double>& binding, QWidget* parent) {
    return makeNumber(binding, parent);
}
FieldEditor makeEditor(const FieldBinding<int>& binding, QWidget* parent) {
    return makeNumber(binding, parent);
}

FieldEditor makeEditor(const FieldBinding<DVec2>& binding, QWidget* parent) {
    return makeNumbers(binding, 2, 3, parent);
}
FieldEditor makeEditor(const FieldBinding<DVec3>& binding, QWidget* parent) {
    return makeNumbers(binding, 3, 3, parent);
}
FieldEditor makeEditor(const FieldBinding<std::array<double, 12>>& binding, QWidget* parent) {
    return makeNumbers(binding, 12, 4, parent);
}

FieldEditor makeEditor(const FieldBinding<bool>& binding, QWidget* parent) {
    auto* box = new QCheckBox(parent);
    box->setObjectName(binding.path);
    box->setAccessibleName(binding.label);
    QObject::connect(box, &QCheckBox::clicked, box, [binding, box] {
        if (box->checkState() != Qt::PartiallyChecked) binding.edit(box->isChecked());
    });
    return {box, [binding, box](const Scene& scene) {
                const auto common = binding.common(scene);
                box->setEnabled(common.value != nullptr);
                box->setTristate(common.mixed);
                box->setCheckState(common.mixed                    ? Qt::PartiallyChecked
                                   : common.value && *common.value ? Qt::Checked
                                                                   : Qt::Unchecked);
                // A click on a mixed box must choose, not cycle back to "mixed".
                box->setTristate(false);
            }};
}

FieldEditor makeEditor(const FieldBinding<std::string>& binding, QWidget* parent) {
    auto* line = new QLineEdit(parent);
    line->setObjectName(binding.path);
    line->setAccessibleName(binding.label);
    const auto show = [binding, line](const Scene& scene) {
        const auto common = binding.common(scene);
        line->setEnabled(common.value != nullptr);
        line->setPlaceholderText(common.mixed ? QStringLiteral("—") : QString());
        const QString text = common.value && !common.mixed ? toQString(*common.value) : QString();
        if (line->text() != text) line->setText(text);
        line->setModified(false);
    };
    QObject::connect(line, &QLineEdit::editingFinished, line, [binding, line, show] {
        if (!line->isModified()) return;
        line->setModified(false);
        const QString reason = binding.edit(line->text().toStdString());
        if (reason.isEmpty()) return;
        QToolTip::showText(line->mapToGlobal(QPoint(0, line->height())), reason, line);
        show(binding.document->scene());
    });
    return {line, show};
}

FieldEditor makeEditor(const FieldBinding<Color>& binding, QWidget* parent) {
    auto* button = new ColorButton(parent);
    button->setRange(binding.meta.min, binding.meta.max);
    button->setObjectName(binding.path);
    button->setAccessibleName(binding.label);
    QObject::connect(button, &ColorButton::previewed, button,
                     [binding](const Color& c) { binding.preview(c); });
    QObject::connect(button, &ColorButton::edited, button, [binding, button](const Color& c) {
        if (const QString reason = binding.edit(c); !reason.isEmpty()) button->refuse(reason);
    });
    QObject::connect(button, &ColorButton::canceled, button,
                     [binding] { binding.document->cancelPreview(); });
    return {button, [binding, button](const Scene& scene) {
                const auto common = binding.common(scene);
                button->setEnabled(common.value != nullptr);
                if (common.mixed || !common.value)
                    button->setMixed();
                else
                    button->setValue(*common.value);
            }};
}

FieldEditor makeEditor(const FieldBinding<std::vector<Color>>& binding, QWidget* parent) {
    auto* box = new QWidget(parent);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    const auto current = [binding] {
        const auto common = binding.common(binding.document->committed());
        return common.value ? *common.value : std::vector<Color>();
    };
    const auto rebuild = [binding, box, row, current](const Scene& scene) {
        const auto common = binding.common(scene);
        const std::size_t count = common.value ? common.value->size() : 0;
        while (static_cast<std::size_t>(row->count()) > count) {
            QLayoutItem* item = row->takeAt(row->count() - 1);
            item->widget()->deleteLater();
            delete item;
        }
        for (auto i = static_cast<std::size_t>(row->count()); i < count; ++i) {
            auto* button = new ColorButton(box);
            button->setRange(binding.meta.min, binding.meta.max);
            button->setObjectName(binding.path + QStringLiteral(".%1").arg(i));
            QObject::connect(button, &ColorButton::edited, button,
                             [binding, current, i](const Color& c) {
                                 auto colors = current();
                                 if (i < colors.size()) colors[i] = c;
                                 binding.edit(colors);
                             });
            row->addWidget(button);
        }
        for (std::size_t i = 0; i < count; ++i)
            static_cast<ColorButton*>(row->itemAt(static_cast<int>(i))->widget())
                ->setValue((*common.value)[i]);
    };
    auto* whole = new QWidget(parent);
    auto* layout = new QHBoxLayout(whole);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(box, 1);
    const auto addButton = [&](const QString& name, const QString& text, auto change) {
        auto* button = new QToolButton(whole);
        button->setIcon(icon(name));
        button->setToolTip(text);
        button->setAutoRaise(true);
        QObject::connect(button, &QToolButton::clicked, button, [binding, current, change] {
            auto colors = current();
            change(colors);
            binding.edit(colors);
        });
        layout->addWidget(button);
    };
    addButton("add", QCoreApplication::translate("FieldEditor", "Add a colour"),
              [](std::vector<Color>& c) {
                  c.push_back(c.empty() ? Color{1, 1, 1} : c.back());
              });
    addButton("remove", QCoreApplication::translate("FieldEditor", "Remove the last colour"),
              [](std::vector<Color>& c) {
                  if (!c.empty()) c.pop_back();
              });
    return {whole, rebuild};
}

FieldEditor makeChoiceEditor(std::function<std::vector<Choice>(const Scene&)> choices,
                             std::function<bool(const Scene&)> mixed, const QString& path,
                             QWidget* parent) {
    auto* combo = new QComboBox(parent);
    combo->setObjectName(path);
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    combo->setMinimumContentsLength(6);
    combo->setFocusPolicy(Qt::StrongFocus);
    combo->installEventFilter(new IgnoreWheel(combo));
    auto shown = std::make_shared<std::vector<Choice>>();
    const auto refresh = [combo, choices, mixed, shown](const Scene& scene) {
        *shown = choices(scene);
        int current = -1;
        bool sameTexts = combo->count() == static_cast<int>(shown->size());
        for (int i = 0; i < static_cast<int>(shown->size()); ++i) {
            const Choice& choice = (*shown)[static_cast<std::size_t>(i)];
            sameTexts = sameTexts && combo->itemText(i) == choice.text;
            if (current < 0 && choice.isCurrent && choice.isCurrent(scene)) current = i;
        }
        if (!sameTexts) {
            combo->clear();
            for (const Choice& choice : *shown) combo->addItem(choice.text);
        }
        combo->setPlaceholderText(QStringLiteral("—"));
        combo->setCurrentIndex(mixed(scene) ? -1 : current);
    };
    QObject::connect(combo, &QComboBox::activated, combo, [combo, shown](int index) {
        // A copy: choosing changes the document, which refreshes the list.
        const Choice choice = shown->at(static_cast<std::size_t>(index));
        if (const QString reason = choice.choose(); !reason.isEmpty())
            QToolTip::showText(combo->mapToGlobal(QPoint(0, combo->height())), reason, combo);
    });
    return {combo, refresh};
}

}  // namespace glint
