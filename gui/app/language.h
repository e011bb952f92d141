// The language of the program's words: English as written in the code, others from
// resources/translations.
#pragma once

#include <QString>

namespace glint {

enum class Language { System, English, Chinese };

/// Makes the whole program speak it, at once: every top-level widget gets QEvent::LanguageChange.
void applyLanguage(Language language);

/// The language's own name for itself; "System" in the present one.
[[nodiscard]] QString nameOf(Language language);

}  // namespace glint
