// Any bytes as a picture file of any format: an error, or a picture of the size that it states with
// finite values. The first byte chooses the file's ending; the rest is the file.
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "tracer/io/image_file.h"

namespace {

// Memory rather than a disk; one file a process, so that several may run at once.
std::string pathFor(const char* ending) {
    return "/dev/shm/glint-fuzz-" + std::to_string(getpid()) + ending;
}

auto load(const std::string& path, const std::uint8_t* data, std::size_t size) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    auto loaded = glint::loadImage(path);
    std::remove(path.c_str());
    return loaded;
}

}  // namespace

/// Has the image library opened, which takes longer than any input may.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
    static_cast<void>(load(pathFor(".png"), nullptr, 0));
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static constexpr std::array kEndings{".png", ".jpg", ".hdr", ".tif",
                                         ".exr", ".bmp", ".tga", ".pnm"};
    if (size == 0) return 0;
    const auto loaded = load(pathFor(kEndings[data[0] % kEndings.size()]), data + 1, size - 1);
    if (!loaded) return 0;
    const glint::Image& image = *loaded.value();
    if (image.rgb.size() !=
        3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height))
        std::abort();
    for (const float value : image.rgb)
        if (!std::isfinite(value)) std::abort();
    return 0;
}
