// The window's colours: neutral greys that do not tint the eye's judgement of the picture, and one
// accent. Dark and light.
#pragma once

#include <QString>

namespace glint {

enum class Theme { Dark, Light };

/// Sets style, palette and style sheet of the application.
void applyTheme(Theme theme);

}  // namespace glint
