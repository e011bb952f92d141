// PreferencesDialog: shows the preferences; each change counts at once, nothing is to be confirmed.
#pragma once

#include <QDialog>
#include <vector>

#include "gui/app/preferences.h"

class QFormLayout;

namespace glint {

class Actions;

class PreferencesDialog : public QDialog {
    Q_OBJECT

  public:
    PreferencesDialog(Preferences& preferences, Actions& actions, QWidget* parent = nullptr);

  private:
    [[nodiscard]] QWidget* buildGeneral();
    [[nodiscard]] QWidget* buildNavigation();
    /// A list of choices for the member that `get` gives.
    template <class T>
    void addChoice(QFormLayout* form, const QString& label, const QString& tip,
                   const std::vector<std::pair<QString, T>>& choices, T PreferenceValues::*member);
    void addSwitch(QFormLayout* form, const QString& label, const QString& tip,
                   bool PreferenceValues::*member);
    void addNumber(QFormLayout* form, const QString& label, const QString& tip, int max,
                   const QString& unit, int PreferenceValues::*member);

    Preferences& preferences_;
};

}  // namespace glint
