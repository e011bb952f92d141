#include "gui/app/resources.h"

#include <QCoreApplication>

#include "gui/app/text.h"

namespace glint {

namespace {

namespace fs = std::filesystem;

/// share/glint beside bin, where `cmake --install` puts what the program needs.
fs::path installedFolder() {
    return toPath(QCoreApplication::applicationDirPath()).parent_path() / "share" / "glint";
}

fs::path folderOf(const char* installed, const char* inSources) {
    std::error_code ignored;
    const fs::path there = installedFolder() / installed;
    return fs::is_directory(there, ignored) ? there : fs::path(GLINT_SOURCE_FOLDER) / inSources;
}

}  // namespace

fs::path environmentFolder() { return folderOf("resources/env", "resources/env"); }
fs::path demoFolder() { return folderOf("scenes/demo", "scenes/demo"); }
fs::path templateFolder() { return folderOf("resources/templates", "resources/templates"); }

}  // namespace glint
