#include "tracer/io/film_exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

#include "tracer/io/atomic_file.h"
#include "tracer/io/exr_check.h"

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

/// `held`: bytes of the file behind its attributes.
ExrFile readPixels(Imf::InputFile& input, std::uintmax_t held) {
    const auto window = input.header().dataWindow();
    const auto width = std::int64_t{window.max.x} - window.min.x + 1,
               height = std::int64_t{window.max.y} - window.min.y + 1;
    if (width < 1 || height < 1 || width * height > kMostImagePixels)
        throw std::runtime_error("more than 1 Gpixel");
    const Imf::ChannelList& channels = input.header().channels();
    std::uintmax_t count = 0;
    for (auto it = channels.begin(); it != channels.end(); ++it) ++count;
    checkPixels(held, static_cast<std::uintmax_t>(width * height) * count * sizeof(Imath::half),
                input.header().compression());
    ExrFile out{static_cast<int>(width), static_cast<int>(height), {}, metadataOf(input.header())};
    reserveChannels(out, channels, static_cast<std::size_t>(width * height));

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
        const std::uintmax_t held = checkExr(path);
        Imf::InputFile input(path.c_str(), 0);
        return readPixels(input, held);
    } catch (const std::exception& problem) {
        return exrError(path, "is not a readable EXR picture", problem.what(), "export it again");
    }
}

}  // namespace glint
