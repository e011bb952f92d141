// Any bytes as an EXR file: an error, or channels of the size that the header states.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "tracer/io/film_exr.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // Memory rather than a disk; one file a process, so that several may run at once.
    static const std::string path = "/dev/shm/glint-fuzz-" + std::to_string(getpid()) + ".exr";
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    const glint::Result<glint::ExrFile> file = glint::loadExr(path);
    std::remove(path.c_str());
    if (!file) return 0;
    const auto pixels = static_cast<std::size_t>(file.value().width) *
                        static_cast<std::size_t>(file.value().height);
    for (const glint::ExrChannel& channel : file.value().channels)
        if (channel.values.size() != pixels) std::abort();
    return 0;
}
