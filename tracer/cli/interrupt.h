// Ctrl-C: asks the program to end with what it has. A second one ends it at once.
#pragma once

#include <atomic>

namespace glint {

/// Watches SIGINT and SIGTERM from now on. The flag becomes true at the first of them.
const std::atomic<bool>& watchInterrupts();

}  // namespace glint
