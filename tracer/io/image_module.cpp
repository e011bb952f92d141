#include "tracer/io/image_module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

/// Rows of scanlines read at a time: some megabytes, so that a broken file ends the reading before
/// the whole picture's memory is touched.
int rowsAtATime(int width) { return std::clamp((1 << 20) / width, 1, 64); }
constexpr int kJpegQuality = 95;

std::string reason(std::string text) {
    if (text.empty()) text = "unknown reason";
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

/// A file in memory. OpenImageIO's own cannot be read back while it is written, which TIFF needs.
class MemoryFile : public OIIO::Filesystem::IOProxy {
  public:
    MemoryFile() : IOProxy("", Write) {}
    [[nodiscard]] const char* proxytype() const override { return "memory"; }
    std::size_t read(void* out, std::size_t count) override {
        const std::size_t got = pread(out, count, m_pos);
        m_pos += static_cast<std::int64_t>(got);
        return got;
    }
    std::size_t write(const void* bytes, std::size_t count) override {
        pwrite(bytes, count, m_pos);
        m_pos += static_cast<std::int64_t>(count);
        return count;
    }
    std::size_t pread(void* out, std::size_t count, std::int64_t offset) override {
        const std::size_t at = std::min(static_cast<std::size_t>(offset), bytes_.size());
        const std::size_t got = std::min(count, bytes_.size() - at);
        std::copy_n(bytes_.data() + at, got, static_cast<unsigned char*>(out));
        return got;
    }
    std::size_t pwrite(const void* bytes, std::size_t count, std::int64_t offset) override {
        const auto at = static_cast<std::size_t>(offset);
        if (at + count > bytes_.size()) bytes_.resize(at + count);
        std::copy_n(static_cast<const unsigned char*>(bytes), count, bytes_.data() + at);
        return count;
    }
    [[nodiscard]] std::size_t size() const override { return bytes_.size(); }
    [[nodiscard]] const std::vector<unsigned char>& bytes() const { return bytes_; }

  private:
    std::vector<unsigned char> bytes_;
};

[[noreturn]] void fail(const std::string& why) { throw std::runtime_error(why); }

/// Runs `work` and turns what it throws into the error text.
template <class Work>
int guarded(char* error, std::size_t errorSize, Work&& work) {
    try {
        OIIO::attribute("threads", 1);
        work();
        return 1;
    } catch (const std::exception& problem) {
        const std::string text = reason(problem.what());
        const std::size_t length = std::min(text.size(), errorSize - 1);
        text.copy(error, length);
        error[length] = '\0';
        return 0;
    }
}

void readRows(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, int begin, int end,
              int channels, float* out) {
    const int y0 = spec.y + begin, y1 = spec.y + end;
    const bool good =
        spec.tile_width > 0
            ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, y0, y1, spec.z, spec.z + 1, 0,
                               channels, OIIO::TypeFloat, out)
            : input.read_scanlines(0, 0, y0, y1, spec.z, 0, channels, OIIO::TypeFloat, out);
    if (!good) fail(input.geterror());
}

/// Spreads `count` pixels of grey (and alpha) at the beginning of `out` over colours, from the
/// back.
void spreadGrey(float* out, std::size_t count, std::size_t alpha) {
    const std::size_t from = 1 + alpha, to = 3 + alpha;
    for (std::size_t i = count; i-- > 0;) {
        const float grey = out[from * i], opacity = out[from * i + alpha];
        std::fill_n(out + to * i, 3, grey);
        if (alpha) out[to * i + 3] = opacity;
    }
}

void readPicture(const char* path, const GlintPictureSink& sink) {
    OIIO::ImageSpec config;
    config["oiio:UnassociatedAlpha"] = 1;
    const auto input = OIIO::ImageInput::open(path, &config);
    if (!input) fail(OIIO::geterror());
    const OIIO::ImageSpec spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1)
        throw std::runtime_error("it has no pixels");
    const int alpha = sink.alpha && (spec.nchannels == 2 || spec.nchannels >= 4) ? 1 : 0;
    if (!sink.begin(sink.context, spec.width, spec.height, 3 + alpha,
                    spec.format.is_floating_point() ? 0 : 1))
        throw std::runtime_error("more than 1 Gpixel, or than the memory holds");
    if (sink.describe) {
        const std::string text = spec.get_string_attribute("ImageDescription");
        if (!sink.describe(sink.context, text.c_str())) fail("not enough memory");
    }

    const int channels = (spec.nchannels >= 3 ? 3 : 1) + alpha;
    const int step = spec.tile_width > 0 ? spec.tile_height : rowsAtATime(spec.width);
    for (int y = 0; y < spec.height; y += step) {
        const int count = std::min(step, spec.height - y);
        float* rows = sink.rows(sink.context, count);
        if (!rows) throw std::runtime_error("not enough memory");
        readRows(*input, spec, y, y + count, channels, rows);
        if (channels < 3)
            spreadGrey(rows, static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(count),
                       static_cast<std::size_t>(alpha));
    }
}

OIIO::TypeDesc typeOf(GlintSample sample) {
    switch (sample) {
        case GlintSample::Byte:
            return OIIO::TypeUInt8;
        case GlintSample::Word:
            return OIIO::TypeUInt16;
        case GlintSample::Float:
            break;
    }
    return OIIO::TypeFloat;
}

OIIO::ImageSpec specOf(const GlintPicture& picture, const std::string& ending) {
    OIIO::ImageSpec spec(picture.width, picture.height, picture.channels, typeOf(picture.sample));
    if (picture.channels == 4) spec["oiio:UnassociatedAlpha"] = 1;
    // In TIFF it would become Exif data, whose writing spoils the file's directory
    // (OpenImageIO 2.4.7 in memory).
    if (!ending.starts_with(".t"))
        spec["oiio:ColorSpace"] = picture.sample == GlintSample::Float ? "Linear" : "sRGB";
    if (ending.starts_with(".j")) {
        spec["CompressionQuality"] = kJpegQuality;
        spec["jpeg:subsampling"] = "4:4:4";
    }
    // Formats without free keys (JPEG, TIFF) keep the description, which holds all texts.
    std::string description;
    for (std::size_t i = 0; i < picture.textCount; ++i) {
        const GlintText& text = picture.texts[i];
        spec.attribute(text.key, text.value);
        description += (i > 0 ? " " : "") + std::string(text.key) + "=" + text.value;
    }
    if (!description.empty()) spec["ImageDescription"] = description;
    return spec;
}

void encodePicture(const char* ending, const GlintPicture& picture, const GlintByteSink& sink) {
    const std::string name = std::string("picture") + ending;
    const auto output = OIIO::ImageOutput::create(name);
    if (!output) fail(OIIO::geterror());
    MemoryFile memory;
    output->set_ioproxy(&memory);
    const OIIO::TypeDesc type = typeOf(picture.sample);
    const bool good = output->open(name, specOf(picture, ending)) &&
                      output->write_image(type, picture.pixels) && output->close();
    if (!good) fail(output->geterror());
    if (!sink.take(sink.context, memory.bytes().data(), memory.bytes().size()))
        throw std::runtime_error("not enough memory");
}

}  // namespace

int glintReadPicture(const char* path, const GlintPictureSink* sink, char* error,
                     std::size_t errorSize) {
    return guarded(error, errorSize, [&] { readPicture(path, *sink); });
}

int glintEncodePicture(const char* ending, const GlintPicture* picture, const GlintByteSink* sink,
                       char* error, std::size_t errorSize) {
    return guarded(error, errorSize, [&] { encodePicture(ending, *picture, *sink); });
}
