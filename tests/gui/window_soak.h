// The soak of glint-window-bench: the window in use for as long as asked, and whether its memory
// stays flat.
#pragma once

#include "gui/app/main_window.h"
#include "tests/bench/output.h"

namespace glint::bench {

/// Edits, undoes, redoes, resizes, pauses, changes channels and selects at random for so many
/// minutes, on one render thread. Prints the memory every minute, and how the median of the last
/// third differs from that of the middle third.
void soak(MainWindow& window, double minutes, Json& json);

}  // namespace glint::bench
