#include "tests/bench/reference_cache.h"

#include <cstdlib>
#include <map>

#include "tests/bench/output.h"
#include "tracer/io/film_exr.h"
#include "tracer/io/scene_json.h"

namespace glint::bench {

namespace {

/// Means in R, G, B, variances in layers of their own.
constexpr std::array<const char*, 6> kChannels = {"R",          "G",          "B",
                                                  "variance.R", "variance.G", "variance.B"};

Status save(const std::filesystem::path& file, const Reference& reference) {
    ExrFile exr{reference.mean.width, reference.mean.height, {}, {}};
    for (std::size_t c = 0; c < kChannels.size(); ++c) {
        const std::vector<float>& from = c < 3 ? reference.mean.rgb : reference.variance;
        ExrChannel channel{kChannels[c], {}};
        for (std::size_t i = c % 3; i < from.size(); i += 3) channel.values.push_back(from[i]);
        exr.channels.push_back(std::move(channel));
    }
    return saveExr(file, exr);
}

Result<Reference> load(const std::filesystem::path& file) {
    Result<ExrFile> exr = loadExr(file);
    if (!exr) return exr.error();
    std::map<std::string, const std::vector<float>*> byName;
    for (const ExrChannel& channel : exr.value().channels) byName[channel.name] = &channel.values;
    const std::size_t size = static_cast<std::size_t>(exr.value().width) *
                             static_cast<std::size_t>(exr.value().height) * 3;
    Reference out{{exr.value().width, exr.value().height, std::vector<float>(size)},
                  std::vector<float>(size)};
    for (std::size_t c = 0; c < kChannels.size(); ++c) {
        const auto found = byName.find(kChannels[c]);
        if (found == byName.end())
            return Error{"no reference of glint-bench", file.string(), 0, 0, {}, "delete it"};
        std::vector<float>& to = c < 3 ? out.mean.rgb : out.variance;
        for (std::size_t i = c % 3, k = 0; i < size; i += 3, ++k) to[i] = (*found->second)[k];
    }
    return out;
}

}  // namespace

std::filesystem::path usualCacheFolder() {
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache)
        return std::filesystem::path(cache) / "glint/bench";
    if (const char* home = std::getenv("HOME"); home && *home)
        return std::filesystem::path(home) / ".cache/glint/bench";
    return std::filesystem::temp_directory_path() / "glint-bench";
}

Result<Reference> ReferenceCache::get(const std::string& key,
                                      const std::function<Result<Reference>()>& make) const {
    std::error_code failed;
    std::filesystem::create_directories(folder_, failed);
    if (failed)
        return Error{"cannot make the folder for references: " + failed.message(),
                     folder_.string(),
                     0,
                     0,
                     {},
                     "name another with --cache"};
    const std::filesystem::path file = folder_ / (key + ".exr");
    if (std::filesystem::exists(file)) return load(file);
    Result<Reference> made = make();
    if (!made) return made;
    const Status saved = save(file, made.value());
    if (!saved) return saved.error();
    return made;
}

Result<Reference> reportReference(const std::filesystem::path& folder, const LoadedScene& scene,
                                  const ErrorReportSettings& settings) {
    const std::string key =
        format("%s-%s-error-%dspp", scene.name.c_str(), sceneHash(scene.scene).c_str(),
               settings.referenceFactor << settings.lastPower);
    return ReferenceCache(folder).get(key, [&]() -> Result<Reference> {
        return makeReference(scene.compiled, settings).value();
    });
}

}  // namespace glint::bench
