// Preferences: what a person wants of the program, whatever the scene. Kept between runs, applied
// at once.
#pragma once

#include <QObject>

#include "gui/app/language.h"
#include "gui/app/memory.h"
#include "gui/app/theme.h"

namespace glint {

struct PreferenceValues {
    Theme theme = Theme::Dark;
    Language language = Language::System;
    int renderThreads = 0;     ///< 0: one for each processor
    int autosaveSeconds = 20;  ///< 0: never
    bool invertWheel = false;  ///< the wheel towards the hand comes closer
    bool orbitSelection =
        false;              ///< orbit about the selection instead of the point under the pointer
    bool startPage = true;  ///< shown when the program starts without a scene

    bool operator==(const PreferenceValues&) const = default;
};

class Preferences : public QObject {
    Q_OBJECT

  public:
    /// Reads what was kept, or starts with the defaults.
    explicit Preferences(Memory memory, QObject* parent = nullptr);

    [[nodiscard]] const PreferenceValues& values() const { return values_; }
    /// Takes over and keeps `values`; numbers are brought into their range.
    void set(PreferenceValues values);

  signals:
    /// values() differ from `before`.
    void changed(const glint::PreferenceValues& before);

  private:
    Memory memory_;
    PreferenceValues values_;
};

/// Most threads that may be asked for.
inline constexpr int kMostThreads = 256;
/// Longest pause between two automatic saves.
inline constexpr int kMostAutosaveSeconds = 3600;

}  // namespace glint
