#include "tracer/render/film.h"

#include <algorithm>
#include <atomic>
#include <new>
#include <type_traits>
#include <utility>

#include "tracer/base/check.h"

namespace glint {

Film::Film(int width, int height, std::size_t groups)
    : width_(width), height_(height), groups_(groups) {
    tiles_.resize(static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows()));
    memory_ = std::make_shared<BlockPool>(tileBytes(), tiles_.size());
}

std::shared_ptr<Film::Tile> Film::newTile() const {
    static_assert(sizeof(Tile::generation) + sizeof(Tile::materials) + sizeof(Tile::sums) ==
                  kBytesAPixel * kPixels);
    static_assert(std::is_trivially_destructible_v<Tile>);
    auto* const tile = new (memory_->take()) Tile;
    tile->light = groups_ > 1 ? new (tile + 1) Vec3[lightCount()] : nullptr;
    return {tile, [memory = memory_](Tile* done) { memory->give(done); }};
}

Film::Tile& Film::own(std::size_t index) {
    std::shared_ptr<Tile>& tile = tiles_[index];
    if (!tile) {
        tile = newTile();
    } else if (tile.use_count() > 1) {
        const std::shared_ptr<Tile> shared = std::exchange(tile, newTile());
        tile->generation = shared->generation;
        tile->materials = shared->materials;
        tile->sums = shared->sums;
        std::copy_n(shared->light, lightCount(), tile->light);
    }
    return *tile;
}

Film::Sums& Film::begin(Tile& tile, std::size_t place) const {
    tile.sums[place] = {DVec3(0.0), DVec3(0.0), 0, 0};
    tile.materials[place] = 0;
    tile.generation[place] = generation_;
    if (groups_ > 1) std::fill_n(tile.light + place * 2 * groups_, 2 * groups_, Vec3(0.0f));
    return tile.sums[place];
}

void Film::add(int x, int y, const Rgb& value, const GroupLight& groups, std::uint64_t materials) {
    Tile& tile = own(tileOf(x, y));
    const std::size_t place = placeOf(x, y);
    Sums& sums = holds(tile.generation[place]) ? tile.sums[place] : begin(tile, place);
    Vec3* light = tile.light + place * 2 * groups_;
    const bool isA = sums.samples % 2 == 0;
    if (groups_ > 1)
        for (std::size_t g = 0; g < groups_; ++g) light[(isA ? 0 : groups_) + g] += groups[g];
    if (isA) {
        const float size = luminance(value);
        sums.squaresA += size * size;
    }
    (isA ? sums.a : sums.b) += toDouble(value);
    tile.materials[place] |= materials;
    ++sums.samples;
}

void Film::put(int x, int y, const Rgb& value, float error, std::uint32_t rays,
               std::uint64_t materials) {
    GLINT_CHECK(groups_ == 1);
    Tile& tile = own(tileOf(x, y));
    const std::size_t place = placeOf(x, y);
    Sums& sums = begin(tile, place);
    // Two samples at least, as many in each half. Which half is brighter must not be the same
    // everywhere.
    const std::uint32_t each = std::max(1u, (rays + 1) / 2);
    const double apart = (sobol::mix(static_cast<std::uint32_t>(y * width_ + x)) & 1)
                             ? static_cast<double>(error)
                             : -static_cast<double>(error);
    sums.a = static_cast<double>(each) * (toDouble(value) + apart);
    sums.b = static_cast<double>(each) * (toDouble(value) - apart);
    sums.samples = 2 * each;
    sums.squaresA = -1;
    tile.materials[place] = materials;
}

HalfMoments Film::momentsA(int x, int y) const {
    const Sums* sums = find(x, y);
    if (!sums) return {};
    return {(sums->samples + 1) / 2, luminance(Color{sums->a.x, sums->a.y, sums->a.z}),
            static_cast<double>(sums->squaresA)};
}

FilmPixel Film::mixed(const Sums& sums, int x, int y) const {
    if (groups_ == 1) return {mix_.gain[0] * sums.a, mix_.gain[0] * sums.b, sums.samples};
    FilmPixel out{DVec3(0.0), DVec3(0.0), sums.samples};
    const Vec3* light = tiles_[tileOf(x, y)]->light + placeOf(x, y) * 2 * groups_;
    for (std::size_t g = 0; g < groups_; ++g) {
        out.sumA += mix_.gain[g] * toDouble(light[g]);
        out.sumB += mix_.gain[g] * toDouble(light[groups_ + g]);
    }
    return out;
}

void Film::clear(const PixelRect& rect) {
    if (rect == PixelRect{0, 0, width_, height_}) {
        oldest_ = ++generation_;
        remembers_ = false;
        retrace_ = 0;
        // What copies hold is theirs now: it would be copied only to be overwritten.
        for (std::shared_ptr<Tile>& tile : tiles_)
            if (tile.use_count() > 1) tile.reset();
        return;
    }
    for (int y = rect.y; y < rect.y + rect.height; ++y)
        for (int x = rect.x; x < rect.x + rect.width; ++x)
            if (find(x, y)) own(tileOf(x, y)).generation[placeOf(x, y)] = 0;
}

std::size_t Film::forget(std::uint64_t materials, WorkerPool& pool) {
    static std::atomic<std::uint64_t> count{0};  // Only to be unique: relaxed.
    remembers_ = true;
    if (retrace_ == 0) {
        ++generation_;
        retrace_ = count.fetch_add(1, std::memory_order_relaxed) + 1;
    }
    std::atomic<std::size_t> forgotten{
        0};  // Only a sum, read when all workers have ended: relaxed.
    pool.run(rows(), [&](int, int row) {
        forgotten.fetch_add(forgetRow(materials, row), std::memory_order_relaxed);
    });
    return forgotten;
}

std::size_t Film::forgetRow(std::uint64_t materials, int tileRow) {
    std::size_t forgotten = 0;
    for (std::size_t index =
             static_cast<std::size_t>(tileRow) * static_cast<std::size_t>(columns());
         index < static_cast<std::size_t>(tileRow + 1) * static_cast<std::size_t>(columns());
         ++index) {
        const Tile* tile = tiles_[index].get();
        if (!tile) continue;
        const auto isAffected = [&](std::size_t i) {
            return holds(tile->generation[i]) && (tile->materials[i] & materials);
        };
        std::size_t i = 0;
        while (i < kPixels && !isAffected(i)) ++i;
        if (i == kPixels) continue;
        Tile& changed = own(index);
        tile = &changed;
        for (; i < kPixels; ++i) {
            if (!isAffected(i)) continue;
            changed.generation[i] |= kForgotten;
            ++forgotten;
        }
    }
    return forgotten;
}

std::optional<Rgb> Film::remembered(int x, int y) const {
    const Tile* tile = tiles_[tileOf(x, y)].get();
    const std::size_t place = placeOf(x, y);
    if (!remembers_ || !tile || !(tile->generation[place] & kForgotten) ||
        !holds(tile->generation[place] & ~kForgotten))
        return std::nullopt;
    return pixelOf(tile->sums[place], x, y).mean();
}

void Film::setMix(const LightMix& mix) {
    mix_ = mix;
    isMixed_ = !mix.isUnit();
}

std::size_t Film::bytes() const {
    const auto present = static_cast<std::size_t>(std::count_if(
        tiles_.begin(), tiles_.end(), [](const auto& tile) { return tile != nullptr; }));
    return present * tileBytes() + tiles_.size() * sizeof(tiles_[0]);
}

Image Film::image() const {
    Image out{width_, height_, {}};
    out.rgb.resize(3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    WorkerPool pool(1);
    paint({0, 0, width_, height_}, pool, out);
    return out;
}

void Film::means(int x, int y, std::span<Rgb> out) const {
    for (std::size_t i = 0; i < out.size();) {
        const int at = x + static_cast<int>(i);
        const std::size_t end = std::min(out.size(),
                                         i + static_cast<std::size_t>(kTile - at % kTile)),
                          place = placeOf(at, y) - i;
        const Tile* tile = tiles_[tileOf(at, y)].get();
        for (; i < end; ++i)
            out[i] = tile && holds(tile->generation[place + i])
                         ? pixelOf(tile->sums[place + i], x + static_cast<int>(i), y).mean()
                         : Rgb(0.0f);
    }
}

void Film::paint(const PixelRect& rect, WorkerPool& pool, Image& picture) const {
    const int pieces = (rect.height + kTile - 1) / kTile;
    pool.run(pieces, [&](int, int piece) {
        std::vector<Rgb> row(static_cast<std::size_t>(rect.width));
        const int end = std::min(rect.height, (piece + 1) * kTile);
        for (int y = rect.y + piece * kTile; y < rect.y + end; ++y) {
            means(rect.x, y, row);
            float* to =
                &picture.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                  static_cast<std::size_t>(rect.x))];
            for (const Rgb& mean : row)
                for (const float value : {mean.x, mean.y, mean.z}) *to++ = value;
        }
    });
}

}  // namespace glint
