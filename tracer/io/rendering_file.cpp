#include "tracer/io/rendering_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "tracer/color/display.h"
#include "tracer/io/image_file.h"
#include "tracer/io/scene_json.h"

namespace glint {

namespace {

std::string textOf(const PixelRect& r) {
    return std::to_string(r.x) + "," + std::to_string(r.y) + "," + std::to_string(r.width) + "," +
           std::to_string(r.height);
}

std::optional<PixelRect> rectOf(const std::string& text) {
    std::array<int, 4> out{};
    const char *at = text.data(), *end = at + text.size();
    for (int& value : out) {
        const auto parsed = std::from_chars(at, end, value);
        if (parsed.ec != std::errc{}) return std::nullopt;
        at = parsed.ptr + (parsed.ptr != end ? 1 : 0);
    }
    return PixelRect{out[0], out[1], out[2], out[3]};
}

/// A picture for the screen, in 8 or 16 bits a channel; colours are divided by alpha if there is
/// any.
DisplayImage displayed(const Rendering& rendering, const Display& display, int bits) {
    const DisplayTransform transform({display.exposureEv, display.view});
    const bool withAlpha = !rendering.alpha.empty();
    DisplayImage out{rendering.beauty.width, rendering.beauty.height, withAlpha ? 4 : 3, bits, {}};
    const std::vector<float>& rgb =
        rendering.filtered.rgb.empty() ? rendering.beauty.rgb : rendering.filtered.rgb;
    out.codes.reserve(rgb.size() / 3 * static_cast<std::size_t>(out.channels));
    const float most = bits == 16 ? 65535 : 255;
    for (std::size_t i = 0; 3 * i + 2 < rgb.size(); ++i) {
        const float alpha = withAlpha ? rendering.alpha[i] : 1;
        const Rgb color = Rgb(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]) / (alpha > 0 ? alpha : 1);
        if (bits == 16) {
            for (const std::uint16_t code : transform.apply16(color)) out.codes.push_back(code);
        } else {
            const std::uint32_t argb = transform.apply(color);
            for (const unsigned shift : {16U, 8U, 0U})
                out.codes.push_back(static_cast<std::uint16_t>(argb >> shift & 0xffU));
        }
        if (withAlpha) out.codes.push_back(static_cast<std::uint16_t>(std::lround(alpha * most)));
    }
    return out;
}

void appendRgb(const Image& image, const std::string& prefix, std::vector<ExrChannel>& out) {
    for (std::size_t c = 0; c < 3; ++c) {
        ExrChannel channel{prefix + "RGB" [c], {}};
        for (std::size_t i = c; i < image.rgb.size(); i += 3)
            channel.values.push_back(image.rgb[i]);
        out.push_back(std::move(channel));
    }
}

ExrFile linear(const Rendering& rendering, bool half) {
    const Image& image = rendering.beauty;
    ExrFile out{image.width, image.height, rendering.layers, {}, half};
    if (out.channels.empty()) appendRgb(image, "", out.channels);
    if (!rendering.filtered.rgb.empty()) appendRgb(rendering.filtered, "filtered.", out.channels);
    if (!rendering.alpha.empty()) out.channels.push_back({"A", rendering.alpha});
    return out;
}

ImageMetadata metadataFor(const Scene& scene, const Rendering& rendering,
                          const PictureOptions& options, const std::string& features) {
    ImageMetadata out = {{"glint:sceneHash", sceneHash(worldOf(scene))},
                         {"glint:settings", pictureSettings(scene)},
                         {"glint:seed", std::to_string(scene.render.seed)},
                         {"glint:spp", std::to_string(rendering.spp)},
                         {"glint:version", GLINT_VERSION},
                         {"glint:features", features}};
    if (options.bits != 0) out["glint:bits"] = std::to_string(options.bits);
    if (options.crop) out["glint:crop"] = textOf(*options.crop);
    if (options.layers) out["glint:layers"] = "yes";
    if (options.transparent) out["glint:transparent"] = "yes";
    if (options.filter) out["glint:filtered"] = "a-trous preview";
    if (!rendering.even) out["glint:uneven"] = "yes";
    if (scene.render.clamp > 0) out["glint:biased"] = "clamp " + std::to_string(scene.render.clamp);
    return out;
}

std::string endingOf(const std::filesystem::path& path) { return path.extension().string(); }

}  // namespace

Status checkPicture(const std::filesystem::path& path, const PictureOptions& options) {
    const auto fail = [&](std::string message, std::string remedy) {
        return Error{
            .message = std::move(message), .file = path.string(), .remedy = std::move(remedy)};
    };
    if (!isWritableFormat(path)) {
        std::string endings;
        for (const std::string& ending : writableEndings()) endings += " " + ending;
        return fail("has an ending that cannot be written", "use one of" + endings);
    }
    if (options.layers && (!isLinearFormat(path) || !holdsAlpha(path)))
        return fail("cannot hold layers", "write a .exr");
    if (options.transparent && !holdsAlpha(path))
        return fail("cannot be transparent", "write a .png, .tif or .exr");
    if (options.filter && isLinearFormat(path) && !holdsAlpha(path))
        return fail("cannot say that it is filtered", "write a .exr or .png");
    const std::vector<int> depths = bitDepths(path);
    if (options.bits == 0 || std::find(depths.begin(), depths.end(), options.bits) != depths.end())
        return Done{};
    std::string possible;
    for (const int bits : depths)
        possible += (possible.empty() ? "" : " or ") + std::to_string(bits);
    return fail(endingOf(path) + " has no " + std::to_string(options.bits) + " bits a channel",
                "use " + possible);
}

Scene sceneFor(Scene scene, const PictureOptions& options) {
    if (options.transparent) scene.environment.visibleToCamera = false;
    return scene;
}

RenderRequest requestFor(const PictureOptions& options) {
    RenderRequest out;
    out.crop = options.crop;
    out.layers = options.layers;
    out.alpha = options.transparent;
    out.filter = options.filter;
    return out;
}

Status saveRendering(const std::filesystem::path& path, const Scene& scene,
                     const Rendering& rendering, const PictureOptions& options,
                     const std::string& features) {
    if (Status good = checkPicture(path, options); !good) return good;
    const ImageMetadata metadata = metadataFor(scene, rendering, options, features);
    const int bits = options.bits ? options.bits : bitDepths(path).front();
    if (!isLinearFormat(path))
        return saveDisplay(path, displayed(rendering, scene.display, bits), metadata);
    if (!holdsAlpha(path)) return saveLinear(path, rendering.beauty, metadata);
    ExrFile file = linear(rendering, bits == 16);
    file.metadata = metadata;
    return saveExr(path, file);
}

Result<PictureRecipe> recipeOf(const ImageMetadata& metadata,
                               const std::filesystem::path& picture) {
    const auto text = [&](const char* key) {
        const auto found = metadata.find(std::string("glint:") + key);
        return found == metadata.end() ? std::string() : found->second;
    };
    const auto number = [&](const char* key) {
        const std::string digits = text(key);
        int out = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), out);
        return out;
    };
    PictureRecipe out{text("sceneHash"),     text("settings"), text("version"),
                      text("features"),      number("spp"),    {},
                      text("uneven").empty()};
    if (out.sceneHash.empty() || out.settings.empty() || out.spp < 1)
        return Error{.message = "does not say how it was made",
                     .file = picture.string(),
                     .remedy = "it must be a .exr, .png, .tif or .jpg that Glint wrote"};
    out.options.bits = number("bits");
    out.options.transparent = !text("transparent").empty();
    out.options.layers = !text("layers").empty();
    out.options.filter = !text("filtered").empty();
    if (const std::string crop = text("crop"); !crop.empty()) out.options.crop = rectOf(crop);
    return out;
}

Scene worldOf(Scene scene) {
    scene.camera = {};
    scene.activeCamera = {};
    for (const CameraId id : scene.cameras.ids()) scene.cameras.erase(id);
    scene.views.clear();
    scene.film = {};
    scene.display = {};
    scene.render = {};
    scene.editor.clear();
    return scene;
}

}  // namespace glint
