#include "tracer/render/first_hits.h"

namespace glint {

void FirstHits::takeUp(const RenderScene& scene) {
    if (scene.lists == lists_ && scene.camera == camera_ && scene.film == film_ &&
        scene.settings.seed == seed_)
        return;
    lists_ = scene.lists;
    camera_ = scene.camera;
    film_ = scene.film;
    seed_ = scene.settings.seed;
    const auto tiles = [](int pixels) {
        return (static_cast<std::size_t>(pixels) + kTile - 1) / kTile;
    };
    columns_ = tiles(film_.width);
    // Tiles serve other pixels as well: all that they hold is of another generation.
    tiles_.resize(columns_ * tiles(film_.height));
    if (++generation_ != 0) return;
    for (std::unique_ptr<Tile>& tile : tiles_) tile.reset();
    generation_ = 1;
}

}  // namespace glint
