// Session: the living render behind a viewport. Any thread publishes scenes and view settings; a
// coordinator thread compiles the newest, drops stale work, lets workers render passes and hands
// finished frames out. Nothing here makes the publishing thread wait. Start at publish(); the
// passes are in scheduler.h.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tracer/base/result.h"
#include "tracer/render/frame_painter.h"
#include "tracer/scene/scene.h"

namespace glint {

struct RenderScene;

/// How the picture is shown, and where it is worked on. Changing anything but the size never
/// restarts the render.
struct ViewSettings {
    int width = 0, height = 0;  ///< of the picture in pixels; 0: nothing is rendered
    PaintSettings paint;
    bool paused = false;
    /// Only these pixels get samples, and only they are lost to an edit: the others keep what they
    /// show. Cut to the picture.
    std::optional<PixelRect> region;
    int threads = 0;  ///< that work at most; 0: all
    bool operator==(const ViewSettings&) const = default;
};

/// How soon an edit showed, in seconds from publish(scene) on; below 0: not yet, or not at all
/// because the next one came.
struct EditLatency {
    double stopped = -1;         ///< the work on what was before had ended
    double firstPicture = -1;    ///< a picture of the edited scene could be taken
    double fullResolution = -1;  ///< one in which every pixel has a sample could be taken
};

enum class SessionState { Idle, Rendering, Paused, Converged };

/// A picture ready to be shown, with what is known about it.
struct SessionFrame : Painting {
    std::uint64_t revision = 0;  ///< number of the publish(scene) that it shows
    int width = 0, height = 0;
    std::optional<PixelRect> region;  ///< spp and error are those of its pixels
    SessionState state = SessionState::Idle;
    int spp = 0;  ///< samples that every pixel has; 0 while the first pass refines
    int sppTarget = 0;
    double seconds = 0;  ///< spent on this picture
    double remainingSeconds =
        0;  ///< until a stop rule ends it, at the present rate; 0 when done, infinite while unknown
    double samples =
        0;  ///< mean number a pixel; more than spp where tiles are sampled by their error
    double error = 0;  ///< of the picture, see pictureError(); infinite before the second sample
    std::uint64_t rays = 0;      ///< traced since the session began
    std::uint64_t restarts = 0;  ///< edits since the session began that threw all samples away
    double retracedShare = 0;    ///< share of the pixels that the last edit threw away: 1 after a
                                 ///< restart, 0 if all was kept
    EditLatency latency;         ///< of the edit with this revision
    double raysPerSecond = 0;
    std::uint64_t nonfiniteSamples = 0;
    std::string kernel;                 ///< name of the kernel in use
    std::vector<std::string> features;  ///< what the scene holds
    std::vector<std::string> skips;  ///< what is left out because the scene lacks it, see skips.h
    std::vector<Error> warnings;     ///< parts of the scene that are missing or not built yet
    std::shared_ptr<const RenderScene> scene;  ///< for picking: see pick.h
};

class Session {
  public:
    /// Starts `threads` workers (at least 1) and the coordinator. `onFrame` is called on the
    /// coordinator's thread whenever a new frame can be taken; it must not block.
    explicit Session(int threads, std::function<void()> onFrame = {});
    /// Stops at the next path vertex and joins all threads.
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Shows `scene` from now on; files it names are relative to `assetFolder`. Returns the
    /// revision its frames carry.
    std::uint64_t publish(Scene scene, std::filesystem::path assetFolder);
    void publish(const ViewSettings& view);
    /// Both at once: no frame shows one without the other.
    std::uint64_t publish(Scene scene, std::filesystem::path assetFolder, const ViewSettings& view);
    /// A file that the scene names has changed: no sample holds any more.
    void readFilesAgain();

    /// The newest frame if there is one that was not taken yet, else null. It belongs to the caller
    /// until the next take().
    [[nodiscard]] const SessionFrame* take();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace glint
