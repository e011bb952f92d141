// Whether an EXR file can hold what its header claims. The library makes room for any claim before
// it reads on, so a file of some hundred bytes may cost gigabytes and seconds.
#pragma once

#include <filesystem>

namespace glint {

/// Throws std::runtime_error with the reason where the file cannot hold its attributes or its
/// pixels.
void checkExr(const std::filesystem::path& path);

}  // namespace glint
