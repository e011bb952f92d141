#include "tracer/io/film_exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <openexr.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>

#include "tracer/io/atomic_file.h"

namespace glint {

namespace {

/// The writing library's view of a sibling file. Unlike its own stream it lets no failed write
/// pass.
class ExrStream : public Imf::OStream {
  public:
    ExrStream(std::FILE* stream, const std::string& name)
        : OStream(name.c_str()), stream_(stream) {}
    void write(const char* bytes, int count) override {
        if (std::fwrite(bytes, 1, static_cast<std::size_t>(count), stream_) !=
            static_cast<std::size_t>(count))
            throw std::runtime_error(std::strerror(errno));
    }
    std::uint64_t tellp() override { return static_cast<std::uint64_t>(std::ftell(stream_)); }
    void seekp(std::uint64_t position) override {
        if (std::fseek(stream_, static_cast<long>(position), SEEK_SET) != 0)
            throw std::runtime_error(std::strerror(errno));
    }

  private:
    std::FILE* stream_;
};

constexpr float kLargestHalf = 65504;

bool isHalf(const ExrFile& file, const ExrChannel& channel) {
    return file.halfColors &&
           std::string_view("RGBA").find(channel.name.back()) != std::string_view::npos;
}

Imf::Header headerOf(const ExrFile& file) {
    Imf::Header header(file.width, file.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const ExrChannel& channel : file.channels)
        header.channels().insert(channel.name,
                                 Imf::Channel(isHalf(file, channel) ? Imf::HALF : Imf::FLOAT));
    for (const auto& [key, value] : file.metadata) header.insert(key, Imf::StringAttribute(value));
    return header;
}

/// A slice for `values`, whose first element is the pixel (xMin, yMin). The library addresses from
/// pixel (0, 0).
Imf::Slice sliceOf(const float* values, int xMin, int yMin, int width) {
    auto* bytes = reinterpret_cast<char*>(const_cast<float*>(values));
    const std::ptrdiff_t first = std::ptrdiff_t{yMin} * width + xMin;
    return {Imf::FLOAT, bytes - first * static_cast<std::ptrdiff_t>(sizeof(float)), sizeof(float),
            sizeof(float) * static_cast<std::size_t>(width)};
}

void writePixels(Imf::OStream& stream, const ExrFile& file) {
    Imf::OutputFile output(stream, headerOf(file), 0);
    Imf::FrameBuffer buffer;
    std::vector<std::vector<Imath::half>> halves(file.channels.size());
    for (std::size_t i = 0; i < halves.size(); ++i) {
        const ExrChannel& channel = file.channels[i];
        if (!isHalf(file, channel)) {
            buffer.insert(channel.name, sliceOf(channel.values.data(), 0, 0, file.width));
            continue;
        }
        // What is brighter than a half can say becomes its largest number, not infinity.
        for (const float value : channel.values)
            halves[i].emplace_back(std::clamp(value, -kLargestHalf, kLargestHalf));
        buffer.insert(
            channel.name,
            Imf::Slice(Imf::HALF, reinterpret_cast<char*>(halves[i].data()), sizeof(Imath::half),
                       sizeof(Imath::half) * static_cast<std::size_t>(file.width)));
    }
    output.setFrameBuffer(buffer);
    output.writePixels(file.height);
}

ImageMetadata metadataOf(const Imf::Header& header) {
    ImageMetadata out;
    for (auto it = header.begin(); it != header.end(); ++it)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute()))
            out[it.name()] = text->value();
    return out;
}

/// Makes the channels with room for all pixels, but fills in none: a file that only claims to be
/// large costs no memory.
void reserveChannels(ExrFile& out, const Imf::ChannelList& channels, std::size_t pixels) {
    for (auto it = channels.begin(); it != channels.end(); ++it) {
        if (it.channel().xSampling != 1 || it.channel().ySampling != 1)
            throw std::runtime_error("channel " + std::string(it.name()) +
                                     " has fewer samples than pixels");
        out.channels.push_back({it.name(), {}});
        out.channels.back().values.reserve(pixels);
    }
}

ExrFile readPixels(Imf::InputFile& input) {
    const auto window = input.header().dataWindow();
    const auto width = std::int64_t{window.max.x} - window.min.x + 1,
               height = std::int64_t{window.max.y} - window.min.y + 1;
    if (width < 1 || height < 1 || width * height > kMostImagePixels)
        throw std::runtime_error("more than 1 Gpixel");
    ExrFile out{static_cast<int>(width), static_cast<int>(height), {}, metadataOf(input.header())};
    reserveChannels(out, input.header().channels(), static_cast<std::size_t>(width * height));

    Imf::FrameBuffer buffer;
    for (const ExrChannel& channel : out.channels)
        buffer.insert(channel.name,
                      sliceOf(channel.values.data(), window.min.x, window.min.y, out.width));
    input.setFrameBuffer(buffer);
    // A few megabytes a channel at a time: a broken file ends the reading before it has cost much.
    const int most = std::clamp((1 << 20) / out.width, 1, 64);
    for (int done = 0; done < out.height; done += most) {
        const int rows = std::min(most, out.height - done);
        for (ExrChannel& channel : out.channels)
            channel.values.resize(static_cast<std::size_t>(done + rows) *
                                  static_cast<std::size_t>(out.width));
        input.readPixels(window.min.y + done, window.min.y + done + rows - 1);
    }
    return out;
}

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
std::uintmax_t mostCompression(exr_compression_t method) {
    const bool dwa = method == EXR_COMPRESSION_DWAA || method == EXR_COMPRESSION_DWAB;
    return dwa ? 100'000 : 1'400;
}

/// Has the library's core, which holds every size in the header against that of the file, look at
/// it first: the rest of the library makes room for whatever an attribute, or a tile, claims to be.
void checkHeader(const std::filesystem::path& path) {
    exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
    settings.error_handler_fn = [](exr_const_context_t, exr_result_t, const char*) {};
    settings.max_image_width = settings.max_image_height = kLongestSide;
    exr_context_t file = nullptr;
    exr_result_t result = exr_start_read(&file, path.c_str(), &settings);
    std::uint64_t chunkSize = 0;
    std::int32_t chunks = 0;
    exr_compression_t method = EXR_COMPRESSION_NONE;
    if (result == EXR_ERR_SUCCESS) result = exr_get_compression(file, 0, &method);
    if (result == EXR_ERR_SUCCESS) result = exr_get_chunk_unpacked_size(file, 0, &chunkSize);
    if (result == EXR_ERR_SUCCESS) result = exr_get_chunk_count(file, 0, &chunks);
    exr_finish(&file);
    if (result != EXR_ERR_SUCCESS) throw std::runtime_error(exr_get_default_error_message(result));
    const std::uintmax_t size = std::filesystem::file_size(path);
    if (chunkSize >
        mostCompression(method) * size / static_cast<std::uint64_t>(std::max(1, chunks)))
        throw std::runtime_error("the picture is larger than the file can hold");
    if (sizeof(std::uint64_t) * static_cast<std::uint64_t>(chunks) > size)
        throw std::runtime_error("the file ends within its table of rows");
}

/// In bytes, of the types whose size no value changes.
const std::map<std::string, std::uint32_t> kAttributeSizes{{"box2f", 16},
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
                                                           {"v3i", 12}};

/// Walks the attributes as Imf::InputFile will and throws where one is longer than the rest of the
/// file: the core lets some of them pass (see tests/fuzz/corpus/exr).
void checkAttributes(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary | std::ios::ate);
    const std::streamoff end = in.tellg();
    in.seekg(8);  // The magic number, version and flags, which the core has checked.
    const auto text = [&] {
        std::string out;
        std::getline(in, out, '\0');
        return out;
    };
    while (!text().empty()) {
        const std::string type = text();
        std::array<unsigned char, 4> bytes{};
        in.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
        const std::uint32_t size =
            bytes[0] | bytes[1] << 8U | bytes[2] << 16U | std::uint32_t{bytes[3]} << 24U;
        if (!in || std::streamoff{size} > end - in.tellg())
            throw std::runtime_error("an attribute is longer than the file");
        // Whatever size is stated, the library reads a number as long as its type is, and a list
        // of channels to its empty name.
        const auto fixed = kAttributeSizes.find(type);
        if (fixed != kAttributeSizes.end() ? size != fixed->second : type == "preview" && size == 0)
            throw std::runtime_error("an attribute is not as long as its type");
        if (type != "chlist")
            in.seekg(size, std::ios::cur);
        else
            while (!text().empty()) in.seekg(16, std::ios::cur);
    }
}

Error exrError(const std::filesystem::path& path, const std::string& what, const std::string& why,
               std::string remedy) {
    return {.message = what + ": " + why, .file = path.string(), .remedy = std::move(remedy)};
}

}  // namespace

Status saveExr(const std::filesystem::path& path, const ExrFile& file) {
    for (const ExrChannel& channel : file.channels)
        GLINT_CHECK(channel.values.size() ==
                    static_cast<std::size_t>(file.width) * static_cast<std::size_t>(file.height));
    auto created = SiblingFile::create(path);
    if (!created) return created.error();
    SiblingFile sibling = std::move(created).value();
    try {
        ExrStream stream(sibling.stream(), path.string());
        writePixels(stream, file);
    } catch (const std::exception& problem) {
        return exrError(path, "could not be written", problem.what(),
                        "free some space, or write elsewhere");
    }
    return sibling.commit();
}

Result<ExrFile> loadExr(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored))
        return exrError(path, "cannot be read", "no such file", "check the path");
    try {
        limitImageSize();
        checkHeader(path);
        checkAttributes(path);
        Imf::InputFile input(path.c_str(), 0);
        return readPixels(input);
    } catch (const std::exception& problem) {
        return exrError(path, "is not a readable EXR picture", problem.what(), "export it again");
    }
}

}  // namespace glint
