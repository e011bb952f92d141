#include "tracer/io/exr_check.h"

#include <ImfHeader.h>
#include <openexr.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace glint {

namespace {

/// In pixels; larger pictures are refused by their header.
constexpr int kLongestSide = 1 << 20;

/// Lets the library refuse absurd headers before it makes tables for them. A setting of the whole
/// program: made once.
void limitImageSize() {
    static const bool done = (Imf::Header::setMaxImageSize(kLongestSide, kLongestSide), true);
    static_cast<void>(done);
}

/// No file is smaller by more: deflate makes at most 1032 bytes of one, PXR24 before that 4 of 3,
/// and DWA 64 numbers of one.
std::uintmax_t mostCompression(Imf::Compression method) {
    const bool dwa = method == Imf::DWAA_COMPRESSION || method == Imf::DWAB_COMPRESSION;
    return dwa ? 100'000 : 1'400;
}

/// What a header claims of the picture.
struct Claim {
    std::uintmax_t bytes = 0;  ///< of its pixels
    std::uintmax_t chunks = 0;
    Imf::Compression method = Imf::NO_COMPRESSION;
};

/// Has the library's core, which holds every size in the header against that of the file, look at
/// it first: the rest of the library makes room for whatever it claims.
Claim readClaim(const std::filesystem::path& path) {
    exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
    settings.error_handler_fn = [](exr_const_context_t, exr_result_t, const char*) {};
    settings.max_image_width = settings.max_image_height = kLongestSide;
    exr_context_t file = nullptr;
    exr_result_t result = exr_start_read(&file, path.c_str(), &settings);
    Claim out;
    exr_compression_t method = EXR_COMPRESSION_NONE;
    std::uint64_t chunkSize = 0;
    std::int32_t chunks = 0;
    if (result == EXR_ERR_SUCCESS) result = exr_get_compression(file, 0, &method);
    if (result == EXR_ERR_SUCCESS) result = exr_get_chunk_unpacked_size(file, 0, &chunkSize);
    if (result == EXR_ERR_SUCCESS) result = exr_get_chunk_count(file, 0, &chunks);
    exr_finish(&file);
    if (result != EXR_ERR_SUCCESS) throw std::runtime_error(exr_get_default_error_message(result));
    out.chunks = static_cast<std::uintmax_t>(std::max(1, chunks));
    if (chunkSize > std::numeric_limits<std::uintmax_t>::max() / out.chunks)
        throw std::runtime_error("the picture is larger than the file can hold");
    out.bytes = chunkSize * out.chunks;
    out.method = static_cast<Imf::Compression>(method);
    return out;
}

/// In bytes, of the types whose size no value changes.
constexpr std::array<std::pair<std::string_view, std::uint32_t>, 24> kAttributeSizes{
    {{"box2f", 16},
     {"box2i", 16},
     {"chromaticities", 32},
     {"compression", 1},
     {"deepImageState", 1},
     {"double", 8},
     {"envmap", 1},
     {"float", 4},
     {"int", 4},
     {"keycode", 28},
     {"lineOrder", 1},
     {"m33d", 72},
     {"m33f", 36},
     {"m44d", 128},
     {"m44f", 64},
     {"rational", 8},
     {"tiledesc", 9},
     {"timecode", 8},
     {"v2d", 16},
     {"v2f", 8},
     {"v2i", 8},
     {"v3d", 24},
     {"v3f", 12},
     {"v3i", 12}}};

/// Walks the attributes as Imf::InputFile will and throws where one is longer than the rest of the
/// file: the core lets some of them pass (see tests/fuzz/corpus/exr). The bytes that follow them.
std::uintmax_t checkAttributes(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary | std::ios::ate);
    const std::streamoff end = in.tellg();
    in.seekg(8);  // The magic number, version and flags, which the core has checked.
    const auto text = [&] {
        std::string out;
        std::getline(in, out, '\0');
        return out;
    };
    std::set<std::string> names;
    for (std::string name = text(); !name.empty(); name = text()) {
        // The core may keep the first and the library the last.
        if (!names.insert(name).second) throw std::runtime_error("an attribute comes twice");
        const std::string type = text();
        std::array<unsigned char, 4> bytes{};
        in.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
        const std::uint32_t size =
            bytes[0] | bytes[1] << 8U | bytes[2] << 16U | std::uint32_t{bytes[3]} << 24U;
        if (!in || std::streamoff{size} > end - in.tellg())
            throw std::runtime_error("an attribute is longer than the file");
        // Whatever size is stated, the library reads a number as long as its type is, and a list
        // of channels to its empty name.
        const auto* fixed = std::find_if(kAttributeSizes.begin(), kAttributeSizes.end(),
                                         [&](const auto& entry) { return entry.first == type; });
        if (fixed != kAttributeSizes.end() ? size != fixed->second : type == "preview" && size == 0)
            throw std::runtime_error("an attribute is not as long as its type");
        if (type != "chlist")
            in.seekg(size, std::ios::cur);
        else
            while (!text().empty()) in.seekg(16, std::ios::cur);
    }
    return in ? static_cast<std::uintmax_t>(end - in.tellg()) : 0;
}

}  // namespace

void checkPixels(std::uintmax_t held, std::uintmax_t bytes, Imf::Compression method) {
    if (bytes / mostCompression(method) > held)
        throw std::runtime_error("the picture is larger than the file can hold");
}

std::uintmax_t checkExr(const std::filesystem::path& path) {
    limitImageSize();
    const Claim claim = readClaim(path);
    const std::uintmax_t held = checkAttributes(path);
    if (sizeof(std::uint64_t) * claim.chunks > held)
        throw std::runtime_error("the file ends within its table of rows");
    checkPixels(held, claim.bytes, claim.method);
    return held;
}

}  // namespace glint
