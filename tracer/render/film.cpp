#include "tracer/render/film.h"

#include <algorithm>

namespace glint {

Film::Film(int width, int height, std::size_t groups) : width_(width), height_(height), groups_(groups) {
    tiles_.resize(static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows()));
}

Film::Tile& Film::own(std::size_t index) {
    std::shared_ptr<Tile>& tile = tiles_[index];
    if (!tile) {
        tile = std::make_shared<Tile>();
        if (groups_ > 1) tile->light.resize(kPixels * 2 * groups_);
    } else if (tile.use_count() > 1) {
        tile = std::make_shared<Tile>(*tile);
    }
    return *tile;
}

void Film::add(int x, int y, const Rgb& value, const GroupLight& groups, std::uint64_t materials) {
    Tile& tile = own(tileOf(x, y));
    const std::size_t place = placeOf(x, y);
    FilmPixel& pixel = tile.pixels[place];
    Vec3* sums = tile.light.data() + place * 2 * groups_;
    if (pixel.generation != generation_) {
        pixel = {};
        pixel.generation = generation_;
        tile.squaresA[place] = 0;
        if (groups_ > 1) std::fill_n(sums, 2 * groups_, Vec3(0.0f));
    }
    if (groups_ > 1)
        for (std::size_t g = 0; g < groups_; ++g) sums[pixel.samples % 2 * groups_ + g] += groups[g];
    if (const float light = luminance(value); pixel.samples % 2 == 0) tile.squaresA[place] += light * light;
    pixel.materials |= materials;
    pixel.add(value);
}

HalfMoments Film::momentsA(int x, int y) const {
    const FilmPixel* pixel = find(x, y);
    if (!pixel) return {};
    const DVec3& sum = pixel->sumA;
    return {(pixel->samples + 1) / 2, luminance(Color{sum.x, sum.y, sum.z}), static_cast<double>(tiles_[tileOf(x, y)]->squaresA[placeOf(x, y)])};
}

FilmPixel Film::mixed(const FilmPixel& pixel, int x, int y) const {
    FilmPixel out = pixel;
    const Vec3* sums = tiles_[tileOf(x, y)]->light.data() + placeOf(x, y) * 2 * groups_;
    out.sumA = out.sumB = DVec3(0.0);
    for (std::size_t g = 0; g < groups_; ++g) {
        out.sumA += mix_.gain[g] * toDouble(sums[g]);
        out.sumB += mix_.gain[g] * toDouble(sums[groups_ + g]);
    }
    return out;
}

void Film::clear(const PixelRect& rect) {
    if (rect == PixelRect{0, 0, width_, height_}) {
        ++generation_;
        return;
    }
    for (int y = rect.y; y < rect.y + rect.height; ++y)
        for (int x = rect.x; x < rect.x + rect.width; ++x)
            if (find(x, y)) own(tileOf(x, y)).pixels[placeOf(x, y)].generation = 0;
}

std::size_t Film::forget(std::uint64_t materials, int tileRow) {
    std::size_t count = 0;
    for (int y = tileRow * kTile; y < std::min(height_, (tileRow + 1) * kTile); ++y)
        for (int x = 0; x < width_; ++x)
            if (this->materials(x, y) & materials) {
                own(tileOf(x, y)).pixels[placeOf(x, y)].generation = 0;
                ++count;
            }
    return count;
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
    out.rgb.reserve(3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            const Rgb mean = at(x, y).mean();
            out.rgb.insert(out.rgb.end(), {mean.x, mean.y, mean.z});
        }
    return out;
}

}  // namespace glint
