#include "tracer/io/image_file.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tracer/color/display.h"
#include "tracer/io/atomic_file.h"
#include "tracer/io/film_exr.h"
#include "tracer/io/image_module.h"

namespace glint {

namespace fs = std::filesystem;

namespace {

/// The module's functions; null with a reason where it could not be opened.
struct Module {
    GlintReadPicture* read = nullptr;
    GlintEncodePicture* encode = nullptr;
    std::string problem;
};

Module openModule() {
    constexpr const char* kName = "glint_image.so";
    std::error_code ignored;
    const fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    // Beside the program, one folder up (tests in the build tree), installed, and wherever the
    // loader looks.
    const std::array<fs::path, 4> places{folder / kName, folder.parent_path() / kName,
                                         folder.parent_path() / "lib/glint" / kName, kName};
    Module out;
    for (const fs::path& place : places) {
        if (place.has_parent_path() && !fs::exists(place, ignored)) continue;
        void* library =
            dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);  // Stays open as long as the program.
        if (!library) {
            out.problem = dlerror();
            continue;
        }
        out.read = reinterpret_cast<GlintReadPicture*>(dlsym(library, "glintReadPicture"));
        out.encode = reinterpret_cast<GlintEncodePicture*>(dlsym(library, "glintEncodePicture"));
        return out;
    }
    return out;
}

const Module& imageModule() {
    static const Module module = openModule();
    return module;
}

Error imageError(const fs::path& path, std::string message, std::string remedy) {
    return {.message = std::move(message), .file = path.string(), .remedy = std::move(remedy)};
}

Error moduleError(const fs::path& path) {
    return imageError(
        path,
        "needs the module glint_image.so, which could not be opened: " + imageModule().problem,
        "put it beside the program, or use EXR pictures");
}

std::string endingOf(const fs::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

/// A picture while the module fills it.
struct Filling {
    Image image;
    std::size_t channels = 3;  ///< of image.rgb
    bool integers = false;
    std::size_t rows = 0;
    std::string description;

    int begin(int width, int height, int channelCount, bool whole) {
        if (std::int64_t{width} * height > kMostImagePixels) return 0;
        image.width = width;
        image.height = height;
        channels = static_cast<std::size_t>(channelCount);
        integers = whole;
        image.rgb.reserve(rowLength() * static_cast<std::size_t>(height));
        return 1;
    }
    float* next(int count) {
        const std::size_t at = rows * rowLength();
        rows += static_cast<std::size_t>(count);
        image.rgb.resize(rows * rowLength());
        return image.rgb.data() + at;
    }
    [[nodiscard]] std::size_t rowLength() const {
        return channels * static_cast<std::size_t>(image.width);
    }
};

/// Calls `work`; 0 or null if memory ran out, for no exception may cross into the module.
template <class Work>
auto orNothing(Work&& work) noexcept -> decltype(work()) {
    try {
        return work();
    } catch (const std::exception&) {
        return {};
    }
}

enum class Alpha { Drop, Keep };

Result<Filling> readByModule(const fs::path& path, Alpha alpha) {
    if (!imageModule().read) return moduleError(path);
    Filling filling;
    const GlintPictureSink sink{
        &filling, alpha == Alpha::Keep ? 1 : 0,
        [](void* context, int width, int height, int channels, int integers) {
            return orNothing([&] {
                return static_cast<Filling*>(context)->begin(width, height, channels,
                                                             integers != 0);
            });
        },
        [](void* context, int count) {
            return orNothing([&] { return static_cast<Filling*>(context)->next(count); });
        },
        [](void* context, const char* text) {
            return orNothing([&] { return static_cast<Filling*>(context)->description = text, 1; });
        }};
    std::array<char, 400> error{};
    if (imageModule().read(path.c_str(), &sink, error.data(), error.size())) return filling;
    return imageError(path, std::string("is not a readable picture: ") + error.data(),
                      "export it again, as PNG, JPEG, HDR or EXR");
}

const std::vector<float>* findChannel(const ExrFile& file, const std::string& name) {
    const auto found = std::find_if(file.channels.begin(), file.channels.end(),
                                    [&](const ExrChannel& c) { return c.name == name; });
    return found == file.channels.end() ? nullptr : &found->values;
}

/// R, G, B of the file, of its first layer that has them, or Y for all three.
std::array<const std::vector<float>*, 3> colourChannels(const ExrFile& file) {
    std::vector<std::string> layers{""};
    for (const ExrChannel& channel : file.channels)
        if (channel.name.ends_with(".R"))
            layers.push_back(channel.name.substr(0, channel.name.size() - 1));
    for (const std::string& layer : layers) {
        const std::array channels{findChannel(file, layer + "R"), findChannel(file, layer + "G"),
                                  findChannel(file, layer + "B")};
        if (channels[0] && channels[1] && channels[2]) return channels;
    }
    const auto* grey = findChannel(file, "Y");
    return {grey, grey, grey};
}

Result<Filling> readExr(const fs::path& path) {
    const auto file = loadExr(path);
    if (!file) return file.error();
    const auto channels = colourChannels(file.value());
    if (!channels[0])
        return imageError(path, "has no channels R, G and B, nor Y", "export it with one of these");
    Filling out;
    out.image.width = file.value().width;
    out.image.height = file.value().height;
    out.image.rgb.resize(3 * channels[0]->size());
    for (std::size_t i = 0; i < channels[0]->size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) out.image.rgb[3 * i + c] = (*channels[c])[i];
    return out;
}

/// Whole-number pictures have at most 16 bits a channel worth keeping, so a table decodes them.
void decodeSrgb(Filling& picture) {
    if (!picture.integers) {
        for (float& value : picture.image.rgb) value = linearFromSrgb(value);
        return;
    }
    constexpr float kLast = 65535;
    std::vector<float> table(65536);
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = linearFromSrgb(static_cast<float>(i) / kLast);
    for (float& value : picture.image.rgb)
        value = table[static_cast<std::size_t>(std::clamp(value, 0.0F, 1.0F) * kLast + 0.5F)];
}

Status encodeByModule(const fs::path& path, const GlintPicture& picture) {
    if (!imageModule().encode) return moduleError(path);
    std::string bytes;
    const GlintByteSink sink{&bytes,
                             [](void* context, const unsigned char* data, std::size_t count) {
                                 return orNothing([&] {
                                     static_cast<std::string*>(context)->assign(
                                         reinterpret_cast<const char*>(data), count);
                                     return 1;
                                 });
                             }};
    std::array<char, 400> error{};
    if (!imageModule().encode(endingOf(path).c_str(), &picture, &sink, error.data(), error.size()))
        return imageError(path, std::string("could not be encoded: ") + error.data(),
                          "choose another format");
    return writeWhole(path, bytes);
}

std::vector<GlintText> textsOf(const ImageMetadata& metadata) {
    std::vector<GlintText> out;
    for (const auto& [key, value] : metadata) out.push_back({key.c_str(), value.c_str()});
    return out;
}

/// The texts in a description that the module wrote: "key=value key=value", all keys in one name
/// space.
ImageMetadata metadataIn(const std::string& description) {
    constexpr std::string_view kSpace = "glint:";
    ImageMetadata out;
    std::size_t at = description.starts_with(kSpace) ? 0 : std::string::npos;
    while (at != std::string::npos) {
        const std::size_t next = description.find(" " + std::string(kSpace), at);
        const std::string text = description.substr(at, next - at);
        if (const std::size_t equals = text.find('='); equals != std::string::npos)
            out[text.substr(0, equals)] = text.substr(equals + 1);
        at = next == std::string::npos ? next : next + 1;
    }
    return out;
}

Status saveLinearExr(const fs::path& path, const Image& image, const ImageMetadata& metadata) {
    ExrFile file{image.width, image.height, {{"R", {}}, {"G", {}}, {"B", {}}}, metadata};
    for (std::size_t c = 0; c < 3; ++c) {
        file.channels[c].values.resize(image.rgb.size() / 3);
        for (std::size_t i = 0; i < image.rgb.size() / 3; ++i)
            file.channels[c].values[i] = image.rgb[3 * i + c];
    }
    return saveExr(path, file);
}

}  // namespace

Result<std::shared_ptr<const Image>> loadImage(const fs::path& path, ColorSpace space) {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored))
        return imageError(path,
                          fs::exists(path, ignored) ? "is not a file" : "there is no such file",
                          "check the path");
    try {
        auto read = endingOf(path) == ".exr" ? readExr(path) : readByModule(path, Alpha::Drop);
        if (!read) return read.error();
        Filling picture = std::move(read).value();
        const bool encoded =
            space == ColorSpace::Srgb || (space == ColorSpace::Auto && picture.integers);
        if (encoded) decodeSrgb(picture);
        const auto& rgb = picture.image.rgb;
        const auto bad =
            std::find_if(rgb.begin(), rgb.end(), [](float v) { return !std::isfinite(v); });
        if (bad == rgb.end()) return std::make_shared<const Image>(std::move(picture.image));
        const std::size_t pixel = static_cast<std::size_t>(bad - rgb.begin()) / 3,
                          width = static_cast<std::size_t>(picture.image.width);
        return imageError(path,
                          "has a value that is not finite, at pixel " +
                              std::to_string(pixel % width) + ", " + std::to_string(pixel / width),
                          "repair that pixel");
    } catch (const std::exception& problem) {
        return imageError(path, std::string("could not be read: ") + problem.what(),
                          "use a smaller picture");
    }
}

Status saveLinear(const fs::path& path, const Image& image, const ImageMetadata& metadata) {
    GLINT_CHECK(isLinearFormat(path));
    if (endingOf(path) == ".exr") return saveLinearExr(path, image, metadata);
    const std::vector<GlintText> texts = textsOf(metadata);
    return encodeByModule(path, {image.width, image.height, 3, image.rgb.data(), GlintSample::Float,
                                 texts.data(), texts.size()});
}

Status saveDisplay(const fs::path& path, const DisplayImage& display,
                   const ImageMetadata& metadata) {
    GLINT_CHECK(!isLinearFormat(path));
    GLINT_CHECK(display.codes.size() == static_cast<std::size_t>(display.channels) *
                                            static_cast<std::size_t>(display.width) *
                                            static_cast<std::size_t>(display.height));
    const std::vector<GlintText> texts = textsOf(metadata);
    GlintPicture picture{display.width,     display.height, display.channels, display.codes.data(),
                         GlintSample::Word, texts.data(),   texts.size()};
    if (display.bits == 16) return encodeByModule(path, picture);
    const std::vector<unsigned char> bytes(display.codes.begin(), display.codes.end());
    picture.pixels = bytes.data();
    picture.sample = GlintSample::Byte;
    return encodeByModule(path, picture);
}

Result<RawImage> loadRaw(const fs::path& path) {
    RawImage out;
    if (endingOf(path) == ".exr") {
        auto file = loadExr(path);
        if (!file) return file.error();
        out.width = file.value().width;
        out.height = file.value().height;
        out.metadata = file.value().metadata;
        ExrFile content = std::move(file).value();
        for (ExrChannel& channel : content.channels)
            out.channels[channel.name] = std::move(channel.values);
        return out;
    }
    const auto read = readByModule(path, Alpha::Keep);
    if (!read) return read.error();
    const Filling& filling = read.value();
    out.width = filling.image.width;
    out.height = filling.image.height;
    out.metadata = metadataIn(filling.description);
    for (std::size_t c = 0; c < filling.channels; ++c) {
        std::vector<float>& values = out.channels[std::string(1, "RGBA"[c])];
        values.reserve(filling.image.rgb.size() / filling.channels);
        for (std::size_t i = c; i < filling.image.rgb.size(); i += filling.channels)
            values.push_back(filling.image.rgb[i]);
    }
    return out;
}

std::vector<int> bitDepths(const fs::path& path) {
    const std::string ending = endingOf(path);
    if (ending == ".exr") return {32, 16};
    if (ending == ".hdr") return {32};
    if (ending.starts_with(".j")) return {8};
    return isWritableFormat(path) ? std::vector<int>{8, 16} : std::vector<int>{};
}

bool holdsAlpha(const fs::path& path) {
    const std::string ending = endingOf(path);
    return isWritableFormat(path) && ending != ".hdr" && !ending.starts_with(".j");
}

bool isLinearFormat(const fs::path& path) {
    return endingOf(path) == ".exr" || endingOf(path) == ".hdr";
}

bool isWritableFormat(const fs::path& path) {
    const auto& endings = writableEndings();
    return std::find(endings.begin(), endings.end(), endingOf(path)) != endings.end();
}

const std::vector<std::string>& writableEndings() {
    static const std::vector<std::string> endings{".exr",  ".png", ".hdr", ".jpg",
                                                  ".jpeg", ".tif", ".tiff"};
    return endings;
}

}  // namespace glint
