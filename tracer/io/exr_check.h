// Whether an EXR file can hold what its header claims. The library makes room for any claim before
// it reads on, so a file of some hundred bytes may cost gigabytes and seconds.
#pragma once

#include <ImfCompression.h>

#include <cstdint>
#include <filesystem>

namespace glint {

/// Throws std::runtime_error with the reason where the file cannot hold its attributes or its
/// pixels. Returns the bytes that follow the attributes.
std::uintmax_t checkExr(const std::filesystem::path& path);
/// Throws where `held` bytes cannot be so many bytes of pixels: of a header that misses something
/// the library's two readers may make different pictures.
void checkPixels(std::uintmax_t held, std::uintmax_t bytes, Imf::Compression method);

}  // namespace glint
