// What an edit would break: the rules of scene files, asked before an edit is made.
#pragma once

#include <QString>

#include "tracer/scene/scene.h"

namespace glint {

/// The first rule that `after` breaks and `before` does not, as a reason to show; empty if there is
/// none. Both hold the same entries in the same order.
[[nodiscard]] QString newProblem(const Scene& before, const Scene& after);

}  // namespace glint
