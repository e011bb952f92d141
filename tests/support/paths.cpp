#include "tests/support/paths.h"

namespace glint::test {

std::filesystem::path inSource(std::string_view relative) {
    return std::filesystem::path(GLINT_SOURCE_DIR) / relative;
}

std::string renderProgram() { return GLINT_RENDER_PATH; }

}  // namespace glint::test
