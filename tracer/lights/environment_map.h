// A latitude-longitude picture of the light from infinitely far, with a table that draws directions
// in proportion to it. Not in here: rotation, intensity and colour of the document's environment;
// see compile/light_table.h. Start reading at sample(): the density is the bilinear look-up itself,
// so it needs no table of its own.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "tracer/color/rgb.h"
#include "tracer/io/image_file.h"
#include "tracer/math/search_guide.h"
#include "tracer/math/warp.h"

namespace glint {

/// What is seen towards a direction, and the density with which EnvironmentMap::sample() draws it.
struct EnvironmentLookup {
    Rgb radiance{0.0f};
    double pdf = 0;
};

/// A drawn direction with what is seen there.
struct EnvironmentSample : DirectionSample {
    Rgb radiance{0.0f};
};

/// Directions are unit vectors in the picture's own space: y up, the middle of the picture is -z,
/// row 0 at the top (u = atan2(d.x, -d.z) / 2 pi + 1/2, v = atan2(hypot(d.x, d.z), d.y) / pi).
class EnvironmentMap {
  public:
    /// Plain: density in proportion to luminance. Compensated: in proportion to what each texel's
    /// luminance has above the mean, for use with BSDF sampling under the balance heuristic, which
    /// takes care of the rest (Karlik et al., "MIS Compensation", ACM TOG 38(6), 2019); the same as
    /// Plain where the picture is constant to one part in a million.
    enum class Density { Plain, Compensated };

    /// Builds the sampling table; takes width * height work. The picture must have at least one
    /// pixel. Texels that are not finite count as black in the mean, and are never above the
    /// largest float in the density.
    explicit EnvironmentMap(std::shared_ptr<const Image> image,
                            Density density = Density::Compensated);

    /// Bilinear between texel centres; u wraps, v clamps.
    [[nodiscard]] Rgb radiance(const DVec3& direction) const;

    /// A direction, its density per solid angle, and the radiance there. Density 0: no sample; so
    /// it is for every `u` where the picture is black, and else only where `u` falls on a zero of
    /// the density. Continuous and monotonic in both coordinates (u.y from the top to the bottom,
    /// u.x around), so that well-spread numbers give well-spread directions.
    [[nodiscard]] EnvironmentSample sample(const Vec2& u) const;
    /// The density of sample() towards a direction; agrees with it to 1e-9 of the largest density
    /// of the picture (tests/numeric/environment_map_test.cpp).
    [[nodiscard]] double pdf(const DVec3& direction) const { return evaluate(direction).pdf; }

    /// radiance() and pdf() for the price of one.
    [[nodiscard]] EnvironmentLookup evaluate(const DVec3& direction) const;

    /// The picture it was made from.
    [[nodiscard]] const std::shared_ptr<const Image>& image() const { return image_; }
    /// Mean radiance over the sphere of directions.
    [[nodiscard]] Rgb meanRadiance() const { return mean_; }
    /// The solid angle [sr] that most of the light comes from: (integral of L)^2 / integral of L^2,
    /// L the luminance; 4 pi where it is the same from everywhere, and where there is none.
    [[nodiscard]] double brightSolidAngle() const { return brightSolidAngle_; }
    /// Mean of the directions weighted by L^2: where the bright part lies, the shorter the more it
    /// is spread out.
    [[nodiscard]] const DVec3& brightDirection() const { return brightDirection_; }

  private:
    /// A place among four texels: columns x0, x1 and rows y0, y1, with the fractions of the way to
    /// x1 and y1.
    struct Place {
        int x0, x1, y0, y1;
        double fx, fy;
    };
    /// A place between columns x0 and x1, the fraction fx of the way to x1, and the weight there.
    struct Column {
        int x0, x1;
        double fx, weight;
    };

    [[nodiscard]] Place placeOf(const DVec3& direction) const;
    [[nodiscard]] Rgb texel(int x, int y) const;
    [[nodiscard]] Rgb radianceAt(const Place& place) const;
    /// What the density is in proportion to at a texel's centre.
    [[nodiscard]] double weight(int x, int y) const {
        return static_cast<double>(
            weights_[static_cast<std::size_t>(y) * static_cast<std::size_t>(image_->width) +
                     static_cast<std::size_t>(x)]);
    }
    [[nodiscard]] Column sampleColumn(double u, const PieceRange& blocks, int y0, int y1,
                                      double fy) const;
    /// The blocks of columns that `u` can lie in between two rows.
    [[nodiscard]] PieceRange blocksAt(double u, int y0, int y1) const;
    /// Asks for the memory that a look-up in a block reads, long before it does.
    void prefetch(int block, int y) const;

    [[nodiscard]] std::size_t rowStart(int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(blocksPerRow_ + 1);
    }
    [[nodiscard]] double rowIntegral(int y) const {
        return blocks_[rowStart(y) + static_cast<std::size_t>(blocksPerRow_)];
    }

    void computeMean();
    void computeWeights(double threshold);
    void buildBlocks(int y);
    void buildBands();

    std::shared_ptr<const Image> image_;
    Rgb mean_{0.0f};
    double brightSolidAngle_ = 4 * kPi;
    DVec3 brightDirection_{0.0};
    /// height x width: luminance above the density's threshold. A third of the picture's memory,
    /// and a walk along a row reads a twelfth of what the texels themselves would take.
    std::vector<float> weights_;
    /// height x (blocks_ + 1): integral of a texel row's weights, linear between centres, from
    /// column 0's centre to the start of each block of columns, in texels. In double: one texel of
    /// 1e9 must not swallow its neighbours.
    std::vector<double> blocks_;
    int blocksPerRow_ = 0;
    std::vector<std::uint32_t> blockGuides_;  ///< for each row of blocks_, in the same places
    /// Integral of the weights times sin(theta) d theta from the top to the start of each band; a
    /// band lies between the centres of two texel rows, or between a pole and the row beside it.
    std::vector<double> bands_;
    std::vector<std::uint32_t> bandGuide_;  ///< into bands_
    std::vector<DVec2>
        bandStarts_;  ///< sine and cosine of theta where each band starts, and at the end
    double pdfPerWeight_ = 0;
};

}  // namespace glint
