// FirstHits: what the camera rays of every pixel's first sample hit, kept for the passes after an
// edit that changes neither camera nor shapes.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "tracer/render/film.h"

namespace glint {

/// Takes 16 bytes a pixel, in tiles of the film, each made when the first of its hits is kept. As
/// in a film, only one worker at a time may use a tile.
class FirstHits {
  public:
    /// Hits of this scene's camera rays follow. Those of before hold if its shapes, camera, film
    /// and seed are the same: which media are around the camera and which surface comes first where
    /// several coincide follow from these. Nothing else of materials matters, because `lists` are
    /// of other shapes as soon as one becomes a dielectric or ceases to be one.
    void takeUp(const RenderScene& scene);

    /// Nothing where it is not known; otherwise maybe a hit of nothing.
    [[nodiscard]] std::optional<ShapeHit> find(int x, int y) const {
        const Tile* tile = tiles_[tileOf(x, y)].get();
        if (!tile) return std::nullopt;
        const Kept& kept = (*tile)[placeOf(x, y)];
        if (kept.generation != generation_) return std::nullopt;
        return ShapeHit{kept.t, kept.shape, kept.face};
    }
    void keep(int x, int y, const ShapeHit& hit) {
        std::unique_ptr<Tile>& tile = tiles_[tileOf(x, y)];
        if (!tile) tile = std::make_unique<Tile>();
        (*tile)[placeOf(x, y)] = {hit.t, hit.shape, static_cast<std::uint16_t>(hit.face),
                                  generation_};
    }

  private:
    struct Kept {
        double t;
        std::uint32_t shape;
        std::uint16_t face;
        std::uint16_t
            generation;  ///< of other than the present one nothing holds; 0: never written
    };
    static_assert(sizeof(Kept) == 16);
    static constexpr std::size_t kTile = Film::kTile;
    using Tile = std::array<Kept, kTile * kTile>;

    [[nodiscard]] std::size_t tileOf(int x, int y) const {
        return static_cast<std::size_t>(y) / kTile * columns_ + static_cast<std::size_t>(x) / kTile;
    }
    static std::size_t placeOf(int x, int y) {
        return static_cast<std::size_t>(y) % kTile * kTile + static_cast<std::size_t>(x) % kTile;
    }

    std::shared_ptr<const ShapeLists> lists_;
    CameraModel camera_;
    FilmSettings film_;
    int seed_ = 0;
    std::uint16_t generation_ = 0;
    std::size_t columns_ = 0;
    std::vector<std::unique_ptr<Tile>> tiles_;
};

}  // namespace glint
