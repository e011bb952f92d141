// Films of living pictures and of renders from nothing, to be compared bit by bit.
#pragma once

#include <optional>

#include "tracer/render/living_picture.h"

namespace glint::test {

/// The film of `scene` with nothing kept from before.
[[nodiscard]] inline Film renderedFromNothing(const Scene& scene, WorkerPool& pool) {
    AssetCache assets;
    const auto compiled = compile(scene, {}, assets).value().scene;
    Film film(scene.film.width, scene.film.height, compiled->lightGroups);
    RenderCounts counts;
    const PixelRect all{0, 0, scene.film.width, scene.film.height};
    Scheduler(pool).renderPass(*compiled, film, nullptr, all, 1,
                               {.samples = static_cast<std::uint32_t>(scene.render.spp)}, {},
                               counts);
    return film;
}

/// The first pixel whose sums, in double and by half, are not the same bits.
[[nodiscard]] inline std::optional<std::pair<int, int>> firstDifference(const Film& a,
                                                                        const Film& b) {
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const FilmPixel p = a.at(x, y), q = b.at(x, y);
            if (p.sumA != q.sumA || p.sumB != q.sumB || p.samples != q.samples ||
                a.materials(x, y) != b.materials(x, y))
                return std::pair{x, y};
        }
    return std::nullopt;
}

[[nodiscard]] inline LivingPicture::Wish wishFor(const Scene& scene) {
    return {scene, {}, scene.film.width, scene.film.height, std::nullopt};
}

inline void finish(LivingPicture& picture) {
    while (!picture.isConverged()) picture.render({1e-3, 1e-2}, {});
}

}  // namespace glint::test
