#include "gui/app/preferences.h"

#include <QSettings>
#include <algorithm>

namespace glint {

namespace {

/// Calls `visit(key, member)` for each preference: the one list that reading and writing share.
template <class Values, class Visit>
void forEachPreference(Values& values, Visit&& visit) {
    visit("theme", values.theme);
    visit("language", values.language);
    visit("renderThreads", values.renderThreads);
    visit("autosaveSeconds", values.autosaveSeconds);
    visit("invertWheel", values.invertWheel);
    visit("orbitSelection", values.orbitSelection);
    visit("startPage", values.startPage);
}

PreferenceValues sound(PreferenceValues values) {
    values.theme = std::clamp(values.theme, Theme::Dark, Theme::Light);
    values.language = std::clamp(values.language, Language::System, Language::Chinese);
    values.renderThreads = std::clamp(values.renderThreads, 0, kMostThreads);
    values.autosaveSeconds = std::clamp(values.autosaveSeconds, 0, kMostAutosaveSeconds);
    return values;
}

PreferenceValues stored() {
    PreferenceValues values;
    QSettings settings;
    settings.beginGroup("preferences");
    forEachPreference(values, [&]<class T>(const char* key, T& value) {
        value = static_cast<T>(settings.value(key, static_cast<int>(value)).toInt());
    });
    return sound(values);
}

void store(const PreferenceValues& values) {
    QSettings settings;
    settings.beginGroup("preferences");
    forEachPreference(values, [&](const char* key, const auto& value) {
        settings.setValue(key, static_cast<int>(value));
    });
}

}  // namespace

Preferences::Preferences(Memory memory, QObject* parent) : QObject(parent), memory_(memory) {
    if (memory_ == Memory::Settings) values_ = stored();
}

void Preferences::set(PreferenceValues values) {
    values = sound(values);
    if (values == values_) return;
    const PreferenceValues before = std::exchange(values_, values);
    if (memory_ == Memory::Settings) store(values_);
    emit changed(before);
}

}  // namespace glint
