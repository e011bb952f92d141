#include "gui/app/preferences_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QTabWidget>
#include <QVBoxLayout>

#include "gui/app/shortcut_page.h"
#include "gui/widgets/drag_number.h"

namespace glint {

PreferencesDialog::PreferencesDialog(Preferences& preferences, Actions& actions, QWidget* parent)
    : QDialog(parent), preferences_(preferences) {
    setWindowTitle(tr("Preferences"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* tabs = new QTabWidget(this);
    tabs->setDocumentMode(true);
    tabs->addTab(buildGeneral(), tr("General"));
    tabs->addTab(buildNavigation(), tr("Navigation"));
    tabs->addTab(new ShortcutPage(actions, this), tr("Shortcuts"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(tabs);
    resize(fontMetrics().averageCharWidth() * 80, fontMetrics().height() * 24);
}

namespace {

QFormLayout* makePage(QWidget* page) {
    auto* form = new QFormLayout(page);
    form->setContentsMargins(16, 16, 16, 16);
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(8);
    form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
    return form;
}

void addRow(QFormLayout* form, const QString& label, const QString& tip, QWidget* editor) {
    auto* title = new QLabel(label, form->parentWidget());
    title->setToolTip(tip);
    title->setBuddy(editor);
    editor->setToolTip(tip);
    editor->setAccessibleName(label);
    form->addRow(title, editor);
}

}  // namespace

template <class T>
void PreferencesDialog::addChoice(QFormLayout* form, const QString& label, const QString& tip,
                                  const std::vector<std::pair<QString, T>>& choices,
                                  T PreferenceValues::*member) {
    auto* combo = new QComboBox(form->parentWidget());
    for (const auto& [text, value] : choices) {
        combo->addItem(text);
        if (value == preferences_.values().*member) combo->setCurrentIndex(combo->count() - 1);
    }
    connect(combo, &QComboBox::activated, this, [this, choices, member](int index) {
        PreferenceValues values = preferences_.values();
        values.*member = choices[static_cast<std::size_t>(index)].second;
        preferences_.set(values);
    });
    addRow(form, label, tip, combo);
}

void PreferencesDialog::addSwitch(QFormLayout* form, const QString& label, const QString& tip,
                                  bool PreferenceValues::*member) {
    auto* box = new QCheckBox(form->parentWidget());
    box->setChecked(preferences_.values().*member);
    connect(box, &QCheckBox::toggled, this, [this, member](bool on) {
        PreferenceValues values = preferences_.values();
        values.*member = on;
        preferences_.set(values);
    });
    addRow(form, label, tip, box);
}

void PreferencesDialog::addNumber(QFormLayout* form, const QString& label, const QString& tip,
                                  int max, const QString& unit, int PreferenceValues::*member) {
    auto* number = new DragNumber(form->parentWidget());
    number->setRange({.min = 0, .max = static_cast<double>(max), .integer = true});
    number->setUnit(unit);
    number->setValue(preferences_.values().*member);
    connect(number, &DragNumber::previewed, number, &DragNumber::setValue);
    connect(number, &DragNumber::edited, this, [this, number, member](double value) {
        PreferenceValues values = preferences_.values();
        values.*member = static_cast<int>(value);
        preferences_.set(values);
        number->setValue(preferences_.values().*member);
    });
    addRow(form, label, tip, number);
}

QWidget* PreferencesDialog::buildGeneral() {
    auto* page = new QWidget(this);
    QFormLayout* form = makePage(page);
    addChoice<Theme>(
        form, tr("Theme"), tr("Both are neutral grey, so that they do not tint the picture"),
        {{tr("Dark"), Theme::Dark}, {tr("Light"), Theme::Light}}, &PreferenceValues::theme);
    std::vector<std::pair<QString, Language>> languages;
    for (const Language language : {Language::System, Language::English, Language::Chinese})
        languages.emplace_back(nameOf(language), language);
    addChoice<Language>(form, tr("Language"), tr("Changes at once"), languages,
                        &PreferenceValues::language);
    addNumber(form, tr("Render threads"),
              tr("Threads that draw the picture; 0: one for each processor"), kMostThreads, {},
              &PreferenceValues::renderThreads);
    addNumber(form, tr("Save automatically every"),
              tr("A copy for recovery, beside the file; 0: never"), kMostAutosaveSeconds, "s",
              &PreferenceValues::autosaveSeconds);
    addSwitch(form, tr("Start page"),
              tr("Show demos and recent files when the program starts without a scene"),
              &PreferenceValues::startPage);
    return page;
}

QWidget* PreferencesDialog::buildNavigation() {
    auto* page = new QWidget(this);
    QFormLayout* form = makePage(page);
    addSwitch(form, tr("Wheel backwards"), tr("Turning the wheel towards you comes closer"),
              &PreferenceValues::invertWheel);
    addSwitch(form, tr("Orbit about the selection"), tr("Off: about the point under the pointer"),
              &PreferenceValues::orbitSelection);
    return page;
}

}  // namespace glint
