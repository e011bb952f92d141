#include "tracer/render/film.h"

#include <algorithm>
#include <utility>

namespace glint {

Film::Film(int width, int height, std::size_t groups) : width_(width), height_(height), groups_(groups) {
    tiles_.resize(static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows()));
}

std::shared_ptr<Film::Tile> Film::newTile() const {
    static_assert(sizeof(Tile::generation) + sizeof(Tile::sums) == kBytesAPixel * kPixels);
    auto tile = std::make_shared_for_overwrite<Tile>();
    if (groups_ > 1) tile->light = std::make_unique_for_overwrite<Vec3[]>(kPixels * 2 * groups_);
    return tile;
}

Film::Tile& Film::own(std::size_t index) {
    std::shared_ptr<Tile>& tile = tiles_[index];
    if (!tile) {
        tile = newTile();
    } else if (tile.use_count() > 1) {
        const std::shared_ptr<Tile> shared = std::exchange(tile, newTile());
        tile->generation = shared->generation;
        tile->sums = shared->sums;
        if (groups_ > 1) std::copy_n(shared->light.get(), kPixels * 2 * groups_, tile->light.get());
    }
    return *tile;
}

void Film::add(int x, int y, const Rgb& value, const GroupLight& groups, std::uint64_t materials) {
    Tile& tile = own(tileOf(x, y));
    const std::size_t place = placeOf(x, y);
    Sums& sums = tile.sums[place];
    Vec3* light = tile.light.get() + place * 2 * groups_;
    if (tile.generation[place] != generation_) {
        sums = {DVec3(0.0), DVec3(0.0), 0, 0, 0};
        tile.generation[place] = generation_;
        if (groups_ > 1) std::fill_n(light, 2 * groups_, Vec3(0.0f));
    }
    const bool isA = sums.samples % 2 == 0;
    if (groups_ > 1)
        for (std::size_t g = 0; g < groups_; ++g) light[(isA ? 0 : groups_) + g] += groups[g];
    if (isA) {
        const float size = luminance(value);
        sums.squaresA += size * size;
    }
    (isA ? sums.a : sums.b) += toDouble(value);
    sums.materials |= materials;
    ++sums.samples;
}

HalfMoments Film::momentsA(int x, int y) const {
    const Sums* sums = find(x, y);
    if (!sums) return {};
    return {(sums->samples + 1) / 2, luminance(Color{sums->a.x, sums->a.y, sums->a.z}), static_cast<double>(sums->squaresA)};
}

FilmPixel Film::mixed(const Sums& sums, int x, int y) const {
    if (groups_ == 1) return {mix_.gain[0] * sums.a, mix_.gain[0] * sums.b, sums.materials, sums.samples};
    FilmPixel out{DVec3(0.0), DVec3(0.0), sums.materials, sums.samples};
    const Vec3* light = tiles_[tileOf(x, y)]->light.get() + placeOf(x, y) * 2 * groups_;
    for (std::size_t g = 0; g < groups_; ++g) {
        out.sumA += mix_.gain[g] * toDouble(light[g]);
        out.sumB += mix_.gain[g] * toDouble(light[groups_ + g]);
    }
    return out;
}

void Film::clear(const PixelRect& rect) {
    if (rect == PixelRect{0, 0, width_, height_}) {
        ++generation_;
        // What copies hold is theirs now: it would be copied only to be overwritten.
        for (std::shared_ptr<Tile>& tile : tiles_)
            if (tile.use_count() > 1) tile.reset();
        return;
    }
    for (int y = rect.y; y < rect.y + rect.height; ++y)
        for (int x = rect.x; x < rect.x + rect.width; ++x)
            if (find(x, y)) own(tileOf(x, y)).generation[placeOf(x, y)] = 0;
}

std::size_t Film::forget(std::uint64_t materials, int tileRow) {
    std::size_t forgotten = 0;
    for (std::size_t index = static_cast<std::size_t>(tileRow) * static_cast<std::size_t>(columns()); index < static_cast<std::size_t>(tileRow + 1) * static_cast<std::size_t>(columns()); ++index) {
        if (!tiles_[index]) continue;
        std::array<bool, kPixels> rests{};
        std::size_t count = 0, present = 0;
        for (std::size_t i = 0; i < kPixels; ++i) {
            if (tiles_[index]->generation[i] != generation_) continue;
            ++present;
            rests[i] = tiles_[index]->sums[i].materials & materials;
            count += rests[i];
        }
        forgotten += count;
        if (count == 0) continue;
        if (count == present) {
            tiles_[index].reset();
            continue;
        }
        Tile& tile = own(index);
        for (std::size_t i = 0; i < kPixels; ++i)
            if (rests[i]) tile.generation[i] = 0;
    }
    return forgotten;
}

void Film::setMix(const LightMix& mix) {
    mix_ = mix;
    isMixed_ = !mix.isUnit();
}

std::size_t Film::bytes() const {
    const auto present = static_cast<std::size_t>(std::count_if(tiles_.begin(), tiles_.end(), [](const auto& tile) { return tile != nullptr; }));
    return present * (sizeof(Tile) + (groups_ > 1 ? kPixels * 2 * groups_ * sizeof(Vec3) : 0)) + tiles_.size() * sizeof(tiles_[0]);
}

Image Film::image() const {
    Image out{width_, height_, {}};
    out.rgb.resize(3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    paint({0, 0, width_, height_}, out);
    return out;
}

void Film::paint(const PixelRect& rect, Image& picture) const {
    for (int y = rect.y; y < rect.y + rect.height; ++y) {
        float* to = &picture.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(rect.x))];
        for (int x = rect.x; x < rect.x + rect.width; ++x) {
            const Rgb mean = at(x, y).mean();
            for (const float value : {mean.x, mean.y, mean.z}) *to++ = value;
        }
    }
}

}  // namespace glint
