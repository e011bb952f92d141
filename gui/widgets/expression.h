// Arithmetic that a person may type in a number field: 1/3, 2*(3+4), sqrt(2), 35 cm, 90 deg, +=0.1.
// Pure functions.
#pragma once

#include <QString>
#include <optional>

namespace glint {

/// The value of `text`, or nothing where it is no arithmetic. Known: + - * / ^ ( ), pi, sqrt sin
/// cos tan abs (angles in degrees), a decimal point or comma. `current` is what += -= *= /= start
/// from. Units behind a number convert to `unit`, the field's own: lengths (mm cm m km in ft) to
/// "m", "rad" to "deg"; the field's unit itself may always stand.
[[nodiscard]] std::optional<double> evaluate(const QString& text, double current,
                                             const QString& unit);

}  // namespace glint
