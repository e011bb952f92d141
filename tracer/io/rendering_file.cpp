#include "tracer/io/rendering_file.h"

#include "tracer/color/display.h"
#include "tracer/io/image_file.h"
#include "tracer/io/scene_json.h"

namespace glint {

namespace {

/// 8-bit sRGB of a linear picture.
std::vector<unsigned char> displayed(const Image& image, const Display& display) {
    const DisplayTransform transform({display.exposureEv, display.view});
    std::vector<unsigned char> out(image.rgb.size());
    for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3) {
        const std::uint32_t argb = transform.apply({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]});
        out[i] = static_cast<unsigned char>(argb >> 16U);
        out[i + 1] = static_cast<unsigned char>(argb >> 8U);
        out[i + 2] = static_cast<unsigned char>(argb);
    }
    return out;
}

}  // namespace

Status saveRendering(const std::filesystem::path& path, const Scene& scene, const Rendering& rendering) {
    ImageMetadata metadata = {{"glint:sceneHash", sceneHash(scene)},
                                    {"glint:seed", std::to_string(scene.render.seed)},
                                    {"glint:spp", std::to_string(rendering.spp)},
                                    {"glint:version", GLINT_VERSION}};
    if (scene.render.clamp > 0) metadata["glint:biased"] = "clamp " + std::to_string(scene.render.clamp);
    const Image& image = rendering.beauty;
    if (!rendering.layers.empty()) return saveExr(path, {image.width, image.height, rendering.layers, metadata});
    if (isLinearFormat(path)) return saveLinear(path, image, metadata);
    return saveDisplay(path, image.width, image.height, displayed(image, scene.display), metadata);
}

}  // namespace glint
