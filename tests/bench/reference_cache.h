// References are dear: they are kept in files, by what they show.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "tests/bench/scene_list.h"
#include "tracer/base/result.h"
#include "tracer/render/error_report.h"
#include "tracer/render/picture_error.h"

namespace glint::bench {

/// Where references are kept if no other folder is named: $XDG_CACHE_HOME/glint/bench, or the same
/// in ~/.cache.
[[nodiscard]] std::filesystem::path usualCacheFolder();

class ReferenceCache {
  public:
    explicit ReferenceCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// The reference stored under `key`, or else made by `make` and stored. The key must name all
    /// that decides its values.
    [[nodiscard]] Result<Reference> get(const std::string& key,
                                        const std::function<Result<Reference>()>& make) const;

  private:
    std::filesystem::path folder_;
};

/// The reference that an error report with these settings compares with, kept in `folder`.
[[nodiscard]] Result<Reference> reportReference(const std::filesystem::path& folder,
                                                const LoadedScene& scene,
                                                const ErrorReportSettings& settings);

}  // namespace glint::bench
