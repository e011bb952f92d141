// The mean over a square of a function that is smooth but for outlines, across which it jumps: a
// picture of `classic`. Corners tell which outlines cross the square; these are found on its sides
// by halving, and the area on each side of them is that of a polygon with one side a parabola. A
// square that holds more than one outline is split (Guo, "Progressive radiance evaluation using
// directional coherence maps", 1998, finds edges of blocks so; marching squares are Lorensen and
// Cline's, 1987, in the plane).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "tracer/color/rgb.h"

namespace glint {

/// Luminance of a difference, each channel by its size.
[[nodiscard]] inline float lightOf(const Rgb& difference) {
    return luminance(absolute(difference));
}

/// What one ray through a point found.
struct Probe {
    Rgb value{0.0f};
    std::uint32_t trail = 0;  ///< the same between two points: the function is smooth between them
    float doubt = 0;  ///< standard error of the luminance that the value has by itself; below 0:
                      ///< not known, the value is of no use
};

/// A mean over the unit square and what is known of its error.
struct OutlineMean {
    DVec3 value{0.0};
    double error = 0;  ///< standard error of the luminance, as estimated
    /// An outline across a side of the square, as seen at its smallest parts.
    struct Crossed {
        int depth = -1;   ///< how often the square was split for it; -1: there is none
        double step = 0;  ///< of the light [luminance]
    };
    std::array<Crossed, 4> crossed;  ///< the sides y = 0, x = 1, y = 1, x = 0
};

class OutlineCell {
  public:
    /// `probe` is asked at points of the closed unit square.
    explicit OutlineCell(const std::function<Probe(const DVec2&)>& probe) : probe_(probe) {}

    /// The mean with an error of about `tolerance` [luminance], or what some `mostProbes` give; the
    /// square is split `leastDepth` times at least. `step` [luminance] is what may lie between two
    /// trails, though light be alike on both: as between a pixel and its neighbours. False: a probe
    /// was of no use. Half planes and, to third order of their curvature, discs are found exactly
    /// but for the tolerance; what lies between the probes is not.
    bool integrate(const Probe& centre, double tolerance, int leastDepth, int mostProbes,
                   double step, OutlineMean& out);

  private:
    static constexpr int kDeepest = 10;
    /// A part of the square; corners and sides run (0,0) (1,0) (1,1) (0,1).
    struct Part {
        DVec2 at;
        double side;
        int depth;
        std::array<Probe, 4> corners;
        Probe centre;
        DVec3 light{0.0};    ///< its share of the integral
        double error = 0;    ///< of that
        double urgency = 0;  ///< of splitting it: its error, or infinite

        [[nodiscard]] DVec2 corner(int i) const;
        [[nodiscard]] double area() const { return side * side; }
    };
    struct Crossing {
        DVec2 at;
        Rgb first, second;  ///< values on its two sides
    };

    Probe probe(const DVec2& at);
    void add(Part part);
    void splitWorst();
    void findRough(Part& part) const;
    void findSmooth(Part& part) const;
    bool findParted(Part& part, int first, int second);
    void markSide(const Part& part, int side);
    /// Between `from` and `to`, whose trails differ, to a distance of `width`; false if a third
    /// trail lies between.
    bool cross(DVec2 from, Probe first, DVec2 to, Probe second, double width, Crossing& out);
    /// How far the outline between `a` and `b` bulges towards the second side in the middle; false
    /// if it cannot be told.
    bool bulge(const Part& part, const DVec2& a, const DVec2& b, const DVec2& towardsSecond,
               std::uint32_t firstTrail, std::uint32_t secondTrail, double width, double& out);

    const std::function<Probe(const DVec2&)>& probe_;
    double tolerance_ = 0, step_ = 0;
    int leastDepth_ = 0, probes_ = 0;
    bool useless_ = false;     ///< some probe was
    double doubts_ = 0;        ///< sum of their squares
    double squares_ = 0;       ///< of the errors of all parts
    std::vector<Part> parts_;  ///< a heap with the most urgent in front
    std::array<OutlineMean::Crossed, 4> crossed_;
};

}  // namespace glint
