// Every kind of leaf with the parameters and directions under which the numeric tests look at it,
// and integrals over its directions. Directions are laid out by the half vector of a lobe as wide
// as the leaf's, so that lobes of any width fill the same cells; Phong's by the angle from the
// mirrored direction.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tracer/materials/all.h"

namespace glint::test {

struct LeafCase {
    std::string name;
    BsdfLeaf leaf;
    float eta = 1;              ///< n(wo's side) / n(other side)
    double width = 1;           ///< alpha of its narrowest lobe
    bool crosses = false;       ///< has smooth transmission
    bool refracts = false;      ///< that follows Snell's law, with eta
    bool aroundMirror = false;  ///< its lobe is round about the mirrored direction, not about the
                                ///< normal in half vectors
};

/// The smooth leaves over alpha in {1e-4 .. 1}; with fullCounts() more of them, and glass of a
/// second refractive index.
[[nodiscard]] std::vector<LeafCase> smoothCases();

/// Viewing angles 0 .. 89.9 degrees, above and (all with fullCounts(), else two) below the surface.
[[nodiscard]] std::vector<Vec3> viewDirections();
[[nodiscard]] Vec3 viewDirection(double thetaDegrees, double phiDegrees);

[[nodiscard]] Rgb evalLeaf(const LeafCase& c, const Vec3& wo, const Vec3& wi);
[[nodiscard]] float pdfLeaf(const LeafCase& c, const Vec3& wo, const Vec3& wi);
/// Samples below the horizon of an opaque leaf carry no light: they come back with density 0, as
/// those that the leaf rejects.
[[nodiscard]] BsdfSample sampleLeaf(const LeafCase& c, const Vec3& wo, const Vec3& u);

/// Cells of directions: rows x columns on each of three sheets. 0: wo's side. 1: the other side,
/// reached by refraction at (or reflection from) some microfacet. 2: the rest of the other side,
/// which only multiple scattering reaches.
struct DirectionGrid {
    int rows = 0, columns = 0;
    [[nodiscard]] int sheet() const { return rows * columns; }
    [[nodiscard]] int cells() const { return 3 * sheet(); }
};

/// The cell that wi lies in. Rows of reflection end at the horizon.
[[nodiscard]] int cellOf(const LeafCase& c, const DirectionGrid& grid, const Vec3& wo,
                         const Vec3& wi);

/// The integral of density(wi) over the solid angle of each cell, by Gauss's rule of `rule`.rows x
/// `rule`.columns points a cell, on the sheets first .. last.
[[nodiscard]] std::vector<double> integrateCells(const LeafCase& c, const DirectionGrid& grid,
                                                 const Vec3& wo, const DirectionGrid& rule,
                                                 const std::function<double(const Vec3&)>& density,
                                                 int firstSheet = 0, int lastSheet = 2);
/// The integral over all directions, with cells as small as the density needs them.
[[nodiscard]] double integrateDirections(const LeafCase& c, const Vec3& wo,
                                         const std::function<double(const Vec3&)>& density);

}  // namespace glint::test
