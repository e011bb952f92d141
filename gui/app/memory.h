// Memory: what a window keeps between runs.
#pragma once

namespace glint {

/// Layout, theme and recent files go into the person's settings; or nowhere, as in tests.
enum class Memory { Settings, None };

}  // namespace glint
