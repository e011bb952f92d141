// Picture: a film with the scene that its samples are of and how far it is; and PictureCache, which
// keeps those of scenes that an undo may come back to.
#pragma once

#include <filesystem>
#include <list>
#include <memory>
#include <optional>

#include "tracer/base/result.h"
#include "tracer/compile/compiler.h"
#include "tracer/render/edit_plan.h"
#include "tracer/render/scheduler.h"
#include "tracer/render/stop_rule.h"
#include "tracer/render/tile_error.h"

namespace glint {

struct Picture {
    Scene traced;  ///< with the picture's size; the samples are of its lights, the film's mix makes
                   ///< other ones of them
    std::filesystem::path assetFolder;
    LightGroups groups{Scene{}};
    std::shared_ptr<const RenderScene> scene;     ///< `traced`, compiled; null: there is no picture
    std::vector<CompileWarning> compileWarnings;  ///< of `scene`
    std::vector<Error> warnings;  ///< the same for people, or why the last edit is not shown
    Film film;
    RenderCounts counts;
    double seconds = 0;
    int spp = 0;          ///< samples that every pixel has
    int stride = 1;       ///< grid of the pass to come; above 1 while the first sample refines
    int shownStride = 0;  ///< grid on which every pixel has a sample; 0: there is nothing to show
    FilmErrors errors;
    struct Judged {
        PixelRect rect;
        LightMix mix;
        int spp = 0;
        double seconds = 0;
    } judged;  ///< of what the film was when `errors` were found
    ErrorTrend trend;
    CellGoals goals;  ///< of the adaptive stage under way; empty: there is none
};

/// How `picture` becomes one of `next` in that folder.
[[nodiscard]] EditPlan planFor(const Picture& picture, const Scene& next,
                               const std::filesystem::path& assetFolder);

/// Pictures by scene, the last used first; films share what they have in common.
class PictureCache {
  public:
    /// Keeps films of at most so many bytes; what else pictures hold is small. First hits
    /// (first_hits.h) are not kept for undo.
    explicit PictureCache(std::size_t bytes) : limit_(bytes) {}

    /// Keeps a copy if it is worth it: full resolution and a good part of a second.
    void store(const Picture& picture);
    /// Takes out a picture whose samples hold for `next` (with its size), its mix set.
    std::optional<Picture> take(const Scene& next, const std::filesystem::path& assetFolder);
    [[nodiscard]] std::size_t bytes() const;

  private:
    static constexpr double kWorthSeconds = 0.2;
    std::size_t limit_;
    std::list<Picture> pictures_;
};

}  // namespace glint
