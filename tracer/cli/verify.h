// glint-render --verify: renders a picture again from what its metadata says, and compares every
// bit.
#pragma once

#include <atomic>

#include "tracer/cli/exit_code.h"
#include "tracer/cli/options.h"

namespace glint {

/// Says on stderr how it came out. Done: the same bits; Different: other bits, or a picture of
/// another scene.
[[nodiscard]] ExitCode verifyPicture(const Options& options, const std::atomic<bool>& stop);

}  // namespace glint
