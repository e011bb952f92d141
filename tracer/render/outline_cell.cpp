#include "tracer/render/outline_cell.h"

#include <algorithm>
#include <cmath>

namespace glint {

namespace {

double distanceOf(const Rgb& a, const Rgb& b) { return static_cast<double>(lightOf(a - b)); }

double cross2(const DVec2& a, const DVec2& b) { return a.x * b.y - a.y * b.x; }

/// A polygon's area and its integral of the function that is linear on the triangles around its
/// first corner.
struct Polygon {
    std::array<DVec2, 5> at;
    std::array<Rgb, 5> values;
    std::size_t count = 0;

    void add(const DVec2& place, const Rgb& value) {
        at[count] = place;
        values[count++] = value;
    }
    DVec3 integral() const {
        DVec3 sum(0.0);
        for (std::size_t i = 2; i < count; ++i)
            sum += 0.5 * std::abs(cross2(at[i - 1] - at[0], at[i] - at[0])) *
                   toDouble((values[0] + values[i - 1] + values[i]) / 3.0f);
        return sum;
    }
    /// Largest distance of a value from the first.
    double spread() const {
        double out = 0;
        for (std::size_t i = 1; i < count; ++i)
            out = std::max(out, distanceOf(values[0], values[i]));
        return out;
    }
};

// How errors are told of what was found. Each is the root mean square over outlines that lie
// anywhere:
constexpr double kPlaceError =
    0.2;  ///< of Simpson's rule over three places within a width of 1, per length of the outline
constexpr double kBulgeError =
    0.4;  ///< of the area of a parabola, over height / length: an arc's differs by 0.8 of the
          ///< square of that, one that bends unevenly by more
constexpr double kShadingError = 1.0 / 32;  ///< of linear shading, per largest difference
constexpr double kMiddleError =
    1.0 / 8;  ///< of Simpson's rule, per difference between middle and corners
constexpr double kRoughError = 0.25;  ///< of the mean of five values, per largest distance from it

constexpr double kBetween =
    0.1;  ///< of the largest step to a pixel's neighbours: what may lie between two trails
constexpr double kUnseen = 1.5;  ///< of all that, for what lies between the probes: as pictures of
                                 ///< many samples say (tests/bench)
constexpr double kRoughShare = 0.5;  ///< of the tolerance and the side: less is not worth to be
                                     ///< found better; parts along an outline may err alike

constexpr auto kByUrgency = [](const auto& a, const auto& b) { return a.urgency < b.urgency; };

}  // namespace

DVec2 OutlineCell::Part::corner(int i) const {
    const int c = i & 3;
    return at + side * DVec2(c == 1 || c == 2 ? 1.0 : 0.0, c >= 2 ? 1.0 : 0.0);
}

bool OutlineCell::integrate(const Probe& centre, double tolerance, int leastDepth, int mostProbes,
                            double step, OutlineMean& out) {
    tolerance_ = tolerance / kUnseen;
    leastDepth_ = leastDepth;
    step_ = kBetween * step;
    probes_ = 1;
    useless_ = false;
    doubts_ = static_cast<double>(centre.doubt) * static_cast<double>(centre.doubt);
    squares_ = 0;
    parts_.clear();
    crossed_ = {};
    Part whole{DVec2(0.0), 1, 0, {}, centre};
    for (int i = 0; i < 4; ++i) whole.corners[static_cast<std::size_t>(i)] = probe(whole.corner(i));
    add(whole);
    const auto goesOn = [&] {
        const Part& worst = parts_.front();
        return worst.urgency == kInfinity ||
               (probes_ < mostProbes && squares_ > tolerance_ * tolerance_ &&
                worst.depth < kDeepest);
    };
    while (!useless_ && goesOn()) splitWorst();
    if (useless_) return false;
    out = {};
    for (const Part& part : parts_) out.value += part.light;
    out.error = std::sqrt(kUnseen * kUnseen * squares_ +
                          doubts_ / (probes_ * static_cast<double>(probes_)));
    out.crossed = crossed_;
    return true;
}

Probe OutlineCell::probe(const DVec2& at) {
    ++probes_;
    const Probe out = probe_(at);
    useless_ = useless_ || out.doubt < 0;
    doubts_ += static_cast<double>(out.doubt) * static_cast<double>(out.doubt);
    return out;
}

void OutlineCell::markSide(const Part& part, int side) {
    const std::array<bool, 4> outer{part.at.y == 0, part.at.x + part.side == 1,
                                    part.at.y + part.side == 1, part.at.x == 0};
    const auto i = static_cast<std::size_t>(side);
    OutlineMean::Crossed& crossed = crossed_[i];
    if (!outer[i] || part.depth < crossed.depth) return;
    const double step = distanceOf(part.corners[i].value, part.corners[(i + 1) & 3].value);
    crossed = {part.depth, part.depth == crossed.depth ? std::max(step, crossed.step) : step};
}

/// Finds the light of a part that has its probes.
void OutlineCell::add(Part part) {
    int crossings = 0, first = 0, second = 0;
    for (int i = 0; i < 4; ++i)
        if (part.corners[static_cast<std::size_t>(i)].trail !=
            part.corners[static_cast<std::size_t>((i + 1) & 3)].trail) {
            (crossings++ == 0 ? first : second) = i;
            markSide(part, i);
        }
    findRough(part);
    const std::uint32_t middle = part.centre.trail;
    if (crossings == 0 && middle == part.corners[0].trail)
        findSmooth(part);
    else if (crossings == 2 && part.error > kRoughShare * tolerance_ * part.side &&
             (middle == part.corners[static_cast<std::size_t>(first)].trail ||
              middle == part.corners[static_cast<std::size_t>(first + 1)].trail))
        findParted(part, first, second);
    squares_ += part.error * part.error;
    part.urgency = part.depth < leastDepth_ ? kInfinity : part.error;
    parts_.push_back(part);
    std::push_heap(parts_.begin(), parts_.end(), kByUrgency);
}

void OutlineCell::splitWorst() {
    std::pop_heap(parts_.begin(), parts_.end(), kByUrgency);
    const Part worst = parts_.back();
    parts_.pop_back();
    squares_ = std::max(0.0, squares_ - worst.error * worst.error);
    const double half = 0.5 * worst.side;
    std::array<Probe, 4> sides;
    for (int i = 0; i < 4; ++i)
        sides[static_cast<std::size_t>(i)] = probe(0.5 * (worst.corner(i) + worst.corner(i + 1)));
    for (int i = 0; i < 4; ++i) {
        const auto at = [](int k) { return static_cast<std::size_t>(k & 3); };
        Part quarter{worst.at + 0.5 * (worst.corner(i) - worst.at), half, worst.depth + 1, {}, {}};
        quarter.corners[at(i)] = worst.corners[at(i)];
        quarter.corners[at(i + 1)] = sides[at(i)];
        quarter.corners[at(i + 2)] = worst.centre;
        quarter.corners[at(i + 3)] = sides[at(i + 3)];
        quarter.centre = probe(quarter.at + 0.5 * half);
        add(quarter);
    }
}

/// The mean of its five values.
void OutlineCell::findRough(Part& part) const {
    Rgb sum = part.centre.value;
    for (const Probe& p : part.corners) sum += p.value;
    const Rgb mean = sum / 5.0f;
    double spread = distanceOf(part.centre.value, mean);
    for (const Probe& p : part.corners) spread = std::max(spread, distanceOf(p.value, mean));
    for (const Probe& p : part.corners)
        if (p.trail != part.centre.trail) spread = std::max(spread, step_);
    part.light = part.area() * toDouble(mean);
    part.error = part.area() * spread * kRoughError;
}

/// Simpson's rule.
void OutlineCell::findSmooth(Part& part) const {
    Rgb corners(0.0f);
    for (const Probe& p : part.corners) corners += 0.25f * p.value;
    part.light = part.area() * toDouble((2.0f * part.centre.value + corners) / 3.0f);
    part.error = part.area() * distanceOf(part.centre.value, corners) * kMiddleError;
}

/// One outline, which crosses the sides `first` < `second`: corners first + 1 to second lie on its
/// one side, the others on the other.
bool OutlineCell::findParted(Part& part, int first, int second) {
    const auto corner = [&](int i) -> const Probe& {
        return part.corners[static_cast<std::size_t>(i & 3)];
    };
    const Probe& one = corner(first + 1);
    const Probe& other = corner(second + 1);
    const double contrast = std::max({distanceOf(one.value, other.value), step_, 1e-30});
    const double width =
        std::clamp(0.65 * tolerance_ / (kPlaceError * std::sqrt(part.side) * contrast),
                   part.side * 0x1p-20, part.side * 0.5);
    Crossing a, b;
    if (!cross(part.corner(first + 1), one, part.corner(first), corner(first), width, a))
        return false;
    if (!cross(part.corner(second), corner(second), part.corner(second + 1), other, width, b))
        return false;

    Polygon inside, outside;
    inside.add(a.at, a.first);
    for (int i = first + 1; i <= second; ++i) inside.add(part.corner(i), corner(i).value);
    inside.add(b.at, b.first);
    outside.add(b.at, b.second);
    for (int i = second + 1; i <= first + 4; ++i) outside.add(part.corner(i), corner(i).value);
    outside.add(a.at, a.second);

    const DVec2 chord = b.at - a.at;
    const double length = glm::length(chord);
    double height = 0;
    if (length > 2 * width) {
        DVec2 towards = DVec2(-chord.y, chord.x) / length;  // To the other side.
        if (glm::dot(towards, part.corner(first + 1) - a.at) > 0) towards = -towards;
        if (!bulge(part, a.at, b.at, towards, one.trail, other.trail, width, height)) return false;
        // It must not leave the part: then it would cross a side more often than its corners say.
        for (const double t : {0.1, 0.25, 0.75, 0.9}) {
            const DVec2 local =
                (a.at + t * chord + 4 * height * t * (1 - t) * towards - part.at) / part.side;
            if (local.x < 0 || local.x > 1 || local.y < 0 || local.y > 1) return false;
        }
        // The middle of the square must lie where the outline says.
        const DVec2 middle = part.at + 0.5 * part.side - a.at;
        const double along = glm::dot(middle, chord) / (length * length);
        const double beyond = glm::dot(middle, towards) - 4 * height * along * (1 - along);
        if (along > 0 && along < 1 && std::abs(beyond) > 2 * width &&
            (beyond > 0) != (part.centre.trail == other.trail))
            return false;
    }
    const double bulged = 2.0 / 3 * height * length;
    const double shading =
        part.area() * kShadingError * std::max(inside.spread(), outside.spread());
    const double error =
        std::hypot(kPlaceError * length * width * contrast,
                   kBulgeError * bulged * contrast * height / std::max(length, width), shading);
    const Rgb step = 0.5f * (a.first + b.first) - 0.5f * (a.second + b.second);
    part.light = inside.integral() + outside.integral() + bulged * toDouble(step);
    part.error = error;
    return true;
}

bool OutlineCell::cross(DVec2 from, Probe first, DVec2 to, Probe second, double width,
                        Crossing& out) {
    double left = glm::length(to - from);
    for (; left > width; left *= 0.5) {
        const DVec2 middle = 0.5 * (from + to);
        const Probe p = probe(middle);
        if (useless_) return false;
        if (p.trail == first.trail)
            from = middle, first = p;
        else if (p.trail == second.trail)
            to = middle, second = p;
        else
            return false;
    }
    out = {0.5 * (from + to), first.value, second.value};
    return true;
}

bool OutlineCell::bulge(const Part& part, const DVec2& a, const DVec2& b,
                        const DVec2& towardsSecond, std::uint32_t firstTrail,
                        std::uint32_t secondTrail, double width, double& out) {
    const DVec2 middle = 0.5 * (a + b);
    const Probe start = probe(middle);
    if (start.trail != firstTrail && start.trail != secondTrail) return false;
    // From a point of the first side towards the second, or the other way round.
    const double sign = start.trail == firstTrail ? 1 : -1;
    const double most = 0.5 * glm::length(b - a);
    double near = 0, far = width;
    for (;; near = far, far *= 2) {
        const DVec2 at = middle + sign * far * towardsSecond;
        const DVec2 local = (at - part.at) / part.side;
        if (far > most || local.x < 0 || local.x > 1 || local.y < 0 || local.y > 1) return false;
        const Probe p = probe(at);
        if (useless_ || (p.trail != firstTrail && p.trail != secondTrail)) return false;
        if (p.trail != start.trail) break;
    }
    // The ends are known to half a width: of a straight outline, the mean place at that side is a
    // sixth.
    if (near == 0) {
        out = sign * width / 6;
        return true;
    }
    while (far - near > width) {
        const double at = 0.5 * (near + far);
        const Probe p = probe(middle + sign * at * towardsSecond);
        if (p.trail != firstTrail && p.trail != secondTrail) return false;
        (p.trail == start.trail ? near : far) = at;
    }
    out = sign * 0.5 * (near + far);
    return true;
}

}  // namespace glint
