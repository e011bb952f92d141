// Film: the sums of samples of every pixel. Each pixel is written by one worker at a time and its
// samples are added in the order of their numbers, so the sums do not depend on threads, tiles or
// interruptions. Copies share their tiles until one of them is written to. A pixel takes 68 bytes:
// 28 for one sum and a count, 28 more for the second half and the spread of the first, 12 for what
// edits keep of it. The errors of a film are in tile_error.h.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "tracer/base/block_pool.h"
#include "tracer/color/rgb.h"
#include "tracer/io/image_file.h"
#include "tracer/render/kernel.h"
#include "tracer/render/render.h"
#include "tracer/render/worker_pool.h"

namespace glint {

/// Sums in double of one pixel: half A holds the even samples, half B the odd ones. They are
/// scrambled independently.
struct FilmPixel {
    DVec3 sumA{0.0}, sumB{0.0};
    std::uint32_t samples = 0;

    /// Mean of all samples; black without any.
    [[nodiscard]] Rgb mean() const {
        return samples ? toFloat((sumA + sumB) / static_cast<double>(samples)) : Rgb(0.0f);
    }
};

/// Of half A of one pixel alone: number, sum and sum of squares of its samples' luminance. Choices
/// that rest on nothing else leave half B free of bias.
struct HalfMoments {
    std::uint32_t samples = 0;
    double sum = 0, squares = 0;
};

class Film {
  public:
    static constexpr int kTile =
        16;  ///< pixels a side of what copies share; only one worker at a time may write to a tile
    static constexpr std::size_t kBytesAPixel =
        68;  ///< with one light group; each of more groups takes 24

    Film() = default;
    /// With `groups` above 1 the light of each group is also kept, so that it can be mixed; 1 to
    /// kMaxLightGroups.
    Film(int width, int height, std::size_t groups = 1);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] std::size_t groups() const { return groups_; }
    /// The pixel, its sums mixed: a value, because a mix is made when it is asked for.
    [[nodiscard]] FilmPixel at(int x, int y) const {
        const Sums* sums = find(x, y);
        return sums ? pixelOf(*sums, x, y) : FilmPixel{};
    }
    /// Without the work of mixing.
    [[nodiscard]] std::uint32_t samples(int x, int y) const {
        const Sums* sums = find(x, y);
        return sums ? sums->samples : 0;
    }
    /// The set of the materials that the pixel's samples rest on, see materialBit().
    [[nodiscard]] std::uint64_t materials(int x, int y) const {
        return find(x, y) ? tiles_[tileOf(x, y)]->materials[placeOf(x, y)] : 0;
    }
    /// Unmixed.
    [[nodiscard]] HalfMoments momentsA(int x, int y) const;

    /// Adds the next sample of the pixel; `light` by group is used if groups() is above 1.
    void add(int x, int y, const Rgb& value, const GroupLight& light, std::uint64_t materials);
    /// In the place of all samples of the pixel: its light as found by so many rays together, and
    /// its standard error in luminance, by which the halves are set apart.
    void put(int x, int y, const Rgb& value, float error, std::uint32_t rays,
             std::uint64_t materials);
    /// The pixel's light was put and no sample was added since.
    [[nodiscard]] bool isPut(int x, int y) const {
        const Sums* sums = find(x, y);
        return sums && sums->squaresA < 0;
    }
    /// Takes the samples of a rectangle away.
    void clear(const PixelRect& rect);
    /// Takes away the samples of the pixels that rest on any of `materials`; answers how many
    /// pixels. remembered() still has their light, until settle() or clear(): nothing is copied for
    /// it.
    std::size_t forget(std::uint64_t materials, WorkerPool& pool);
    /// Samples go to any pixel again. With `everywhere` no light is remembered any more: every
    /// pixel that was forgotten has a sample.
    void settle(bool everywhere) {
        retrace_ = 0;
        remembers_ = remembers_ && !everywhere;
    }
    /// Some pixels may have been forgotten and have no sample yet.
    [[nodiscard]] bool remembers() const { return remembers_; }
    /// Between the first forget() and settle(), while samples go only to pixels that were
    /// forgotten: a number that no other such time of any film has; otherwise 0.
    [[nodiscard]] std::uint64_t retrace() const { return retrace_; }
    /// The mean that a pixel had when it was forgotten and has had no sample since.
    [[nodiscard]] std::optional<Rgb> remembered(int x, int y) const;
    /// The pixel's samples were made after it had been forgotten.
    [[nodiscard]] bool isAnew(int x, int y) const {
        const Tile* tile = tiles_[tileOf(x, y)].get();
        return remembers_ && tile && tile->generation[placeOf(x, y)] == generation_;
    }
    /// The pixel has not been forgotten since retrace() began.
    [[nodiscard]] bool isUntouched(int x, int y) const { return find(x, y) && !isAnew(x, y); }

    /// Shows the light of the groups with these factors; needs groups() to be their number. Sums of
    /// groups are in float: a mix is right to some 1e-5, and the unit mix is exact.
    void setMix(const LightMix& mix);
    [[nodiscard]] const LightMix& mix() const { return mix_; }

    [[nodiscard]] int columns() const { return (width_ + kTile - 1) / kTile; }
    [[nodiscard]] int rows() const { return (height_ + kTile - 1) / kTile; }
    /// Takes some memory from the system, so that in a while the film can be cleared and filled
    /// without, though a copy has its tiles.
    void reserve() { memory_->reserve(tiles_.size()); }
    /// Storage, tiles shared with copies included.
    [[nodiscard]] std::size_t bytes() const;
    /// Means of all pixels.
    [[nodiscard]] Image image() const;
    /// Means of the pixels of row y from x on.
    void means(int x, int y, std::span<Rgb> out) const;
    /// Puts the means of a rectangle into a picture of the film's size.
    void paint(const PixelRect& rect, WorkerPool& pool, Image& picture) const;

  private:
    static constexpr std::size_t kPixels = static_cast<std::size_t>(kTile) * kTile;
    /// As FilmPixel, and what is asked of half A alone. Not initialised: Tile::generation says
    /// whether there is anything.
    struct Sums {
        DVec3 a, b;
        std::uint32_t samples;
        float squaresA;  ///< sum of squares of luminance; below 0: the pixel's light was put
    };
    /// Materials lie apart: forget() reads those of every pixel and no sums.
    struct Tile {
        std::array<std::uint32_t, kPixels>
            generation{};  ///< when the sums were begun; those before the film's oldest are void
        std::array<std::uint64_t, kPixels> materials;
        std::array<Sums, kPixels> sums;
        Vec3* light;  ///< sums by group: pixel x half x group, right behind the tile; null with one
                      ///< group
    };

    [[nodiscard]] std::size_t tileOf(int x, int y) const {
        return static_cast<std::size_t>(y / kTile) * static_cast<std::size_t>(columns()) +
               static_cast<std::size_t>(x / kTile);
    }
    static std::size_t placeOf(int x, int y) {
        return static_cast<std::size_t>(y % kTile) * kTile + static_cast<std::size_t>(x % kTile);
    }
    [[nodiscard]] const Sums* find(int x, int y) const {
        const Tile* tile = tiles_[tileOf(x, y)].get();
        const std::size_t place = placeOf(x, y);
        return tile && holds(tile->generation[place]) ? &tile->sums[place] : nullptr;
    }
    static constexpr std::uint32_t kForgotten = 1u << 31;  ///< added to a pixel's generation
    [[nodiscard]] bool holds(std::uint32_t generation) const {
        return generation >= oldest_ && generation <= generation_;
    }
    std::size_t forgetRow(std::uint64_t materials, int tileRow);
    /// Empties a pixel.
    Sums& begin(Tile& tile, std::size_t place) const;
    /// The tile for writing: not shared with any copy.
    Tile& own(std::size_t tile);
    [[nodiscard]] std::shared_ptr<Tile> newTile() const;
    [[nodiscard]] std::size_t tileBytes() const {
        return sizeof(Tile) + lightCount() * sizeof(Vec3);
    }
    [[nodiscard]] std::size_t lightCount() const { return groups_ > 1 ? kPixels * 2 * groups_ : 0; }
    [[nodiscard]] FilmPixel pixelOf(const Sums& sums, int x, int y) const {
        return isMixed_ ? mixed(sums, x, y) : FilmPixel{sums.a, sums.b, sums.samples};
    }
    [[nodiscard]] FilmPixel mixed(const Sums& sums, int x, int y) const;

    int width_ = 0, height_ = 0;
    std::size_t groups_ = 1;
    std::uint32_t generation_ =
        1;                      ///< of the samples to come; a step makes those before other ones
    std::uint32_t oldest_ = 1;  ///< clearing the whole film is a step of both
    bool remembers_ = false;
    std::uint64_t retrace_ = 0;
    bool isMixed_ = false;
    LightMix mix_;
    std::shared_ptr<BlockPool> memory_;  ///< of the tiles, those of copies included
    std::vector<std::shared_ptr<Tile>> tiles_;
};

}  // namespace glint
