// FramePainter: a film as a picture for the screen: exposure, channels, false colours, the preview
// filter. Never changes the film, so nothing chosen here restarts a render. Start at paint().
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "tracer/color/display.h"
#include "tracer/render/backdrop.h"
#include "tracer/render/preview_filter.h"
#include "tracer/render/tile_error.h"

namespace glint {

/// What the viewport shows of the picture.
enum class Channel {
    Beauty,
    Albedo,
    Normal,
    Depth,
    Position,
    Object,
    Material,
    Samples,
    Error,
    Luminance
};
inline constexpr std::size_t kChannels = 10;

/// The values at both ends of the scale of a channel in false colours.
struct Legend {
    double low = 0, high = 1;
    bool logarithmic = false;
    bool operator==(const Legend&) const = default;
};

/// How it is to be shown.
struct PaintSettings {
    DisplaySettings display;
    Channel channel = Channel::Beauty;
    bool filtered = false;
    std::optional<std::array<int, 2>>
        probe;  ///< column and row of a pixel whose light is asked for
    bool operator==(const PaintSettings&) const = default;
};

/// What is painted.
struct Painting {
    std::vector<std::uint32_t> pixels;  ///< 0xffRRGGBB, height x width, row-major, top row first
    Channel channel = Channel::Beauty;
    bool filtered = false;  ///< the preview filter was at work
    bool isRough = false;  ///< guides have fewer samples than they are to have: the next call gives
                           ///< a better picture
    std::optional<Legend> legend;
    TileErrors errors;
    struct Probe {
        std::array<int, 2> pixel;
        Rgb light;  ///< linear, before the exposure, whatever the channel
    };
    std::optional<Probe> probe;  ///< what was asked for, if it lies in the picture

    /// What an earlier painting has to share with the next for untouched pixels to stay. The film's
    /// retrace() is 0: nothing stays.
    struct Base {
        std::uint64_t retrace = 0;
        LightMix mix;
        DisplaySettings display;
        bool operator==(const Base&) const = default;
    } base;
};

class FramePainter {
  public:
    explicit FramePainter(WorkerPool& pool) : pool_(pool) {}

    /// Paints `film`, which holds samples of `scene` at all pixels whose x and y are multiples of
    /// `stride` and maybe others; `backdrop`, which may be null, is shown where it has none. The
    /// channels of surfaces and the filter trace guides first. False when cancelled: `out` is then
    /// of no use. The filter waits until every pixel has a sample.
    bool paint(const std::shared_ptr<const RenderScene>& scene, const Film& film,
               const Backdrop* backdrop, int stride, const TileErrors& errors,
               const PaintSettings& settings, const CancelToken& cancel, Painting& out);

  private:
    bool paintBeauty(const Film& film, const Backdrop* backdrop, int mask, bool untouchedStay,
                     const DisplayTransform& transform, Painting& out);
    bool paintSurfaces(const Film& film, int mask, Painting& out);
    bool paintErrors(const Film& film, Painting& out);
    bool paintScale(const Film& film, const Backdrop* backdrop, int mask,
                    const PaintSettings& settings, Painting& out);
    /// Calls paintRow(y, its pixels) for every row of the picture, or the first of every `stride`,
    /// of which the others become copies. False when cancelled.
    template <class PaintRow>
    bool eachRow(const Film& film, int stride, PaintRow&& paintRow, Painting& out);
    /// Fills the picture with color(x, y).
    template <class Color>
    bool eachPixel(const Film& film, Color&& color, Painting& out);
    /// The same, asking one pixel of each block of stride x stride only.
    template <class Color>
    bool eachBlock(const Film& film, int stride, Color&& color, Painting& out);

    WorkerPool& pool_;
    CancelToken cancel_;  ///< of the call of paint()
    GuideFilm guides_;
    PreviewFilter filter_;
    std::vector<Rgb> filteredLight_;
};

}  // namespace glint
