#include "tracer/compile/asset_cache.h"

#include "tracer/lights/sky.h"

namespace glint {

Result<std::shared_ptr<const Image>> AssetCache::image(const std::filesystem::path& path,
                                                       ColorSpace space, int& loads) {
    std::error_code error;
    const auto time = std::filesystem::last_write_time(path, error);
    const auto key = std::pair(path.string(), space);
    if (const auto found = images_.find(key);
        !error && found != images_.end() && found->second.time == time)
        return found->second.image;
    auto loaded = loadImage(path, space);
    ++loads;
    if (loaded.ok() && !error) images_[key] = {time, loaded.value()};
    return loaded;
}

std::shared_ptr<const Image> AssetCache::sky(const Sky& sky) {
    if (!skyImage_ || !(sky == sky_)) {
        sky_ = sky;
        skyImage_ = std::make_shared<const Image>(skyImage(sky));
    }
    return skyImage_;
}

std::shared_ptr<const Image> missingImage() {
    auto image = std::make_shared<Image>(Image{64, 32, {}});
    for (int y = 0; y < image->height; ++y)
        for (int x = 0; x < image->width; ++x) {
            const float on = (x / 4 + y / 4) % 2 ? 0.5f : 0.0f;
            image->rgb.insert(image->rgb.end(), {on, 0, on});
        }
    return image;
}

}  // namespace glint
