#include "tracer/compile/mirror_points.h"

#include <algorithm>

#include "tracer/math/frame.h"

namespace glint {

namespace {

/// A face near one of its points, in render space.
struct SurfaceJet {
    DVec3 normal;  ///< unit, outward
    DMat3 slope;   ///< of the normal by the point, before it is made unit; over its length

    SurfaceJet(const ShapeInstance& shape, const DVec3& local, int face) {
        DMat3 canonical(0.0);
        std::visit(
            [&](const auto& s) {
                normal = s.normal(local, face) * shape.localFromWorld;  // (M^-1)^T n
                canonical = s.normalSlope(local, face);
            },
            shape.shape);
        const double length = glm::length(normal);
        normal /= length;
        slope = glm::transpose(shape.localFromWorld) * canonical * shape.localFromWorld / length;
    }
    /// How the unit normal turns with a step along the surface.
    [[nodiscard]] DVec3 turn(const DVec3& step) const {
        const DVec3 out = slope * step;
        return out - glm::dot(out, normal) * normal;
    }
};

/// How many faces a shape has; the curved ones come first.
struct FaceCounts {
    int count, curved;
};
struct Faces {
    FaceCounts operator()(const CanonicalSphere&) const { return {1, 1}; }
    FaceCounts operator()(const CanonicalTorus&) const { return {1, 1}; }
    FaceCounts operator()(const CanonicalCylinder&) const { return {3, 1}; }
    FaceCounts operator()(const CanonicalCone&) const { return {2, 1}; }
    FaceCounts operator()(const CanonicalBox&) const { return {6, 0}; }
    FaceCounts operator()(const auto&) const { return {1, 0}; }
};

DVec3 project(const ShapeInstance& shape, const DVec3& local, int face) {
    return std::visit([&](const auto& s) { return s.project(local, face); }, shape.shape);
}

/// Newton's method for a stationary length of the way over the face, from the local point `local`.
/// On convex shapes the face's curvature only ever adds to that of the length, so that all steps go
/// downhill. Nothing if it does not end.
bool solve(const ShapeInstance& shape, int face, const DVec3& eye, const MirrorTarget& target,
           DVec3 local, DVec3& out) {
    constexpr int kMaxSteps = 20;
    constexpr double kTolerance =
        3e-5;  // Convergence is quadratic: after such a step the error is 1e-9.
    constexpr double kLongestStep = 0.5;  // local units
    const bool convex = !std::holds_alternative<CanonicalTorus>(shape.shape);
    for (int step = 0; step < kMaxSteps; ++step) {
        const SurfaceJet jet(shape, local, face);
        const DVec3 p = shape.center + shape.worldFromLocal * local;
        const DVec3 fromEye = p - eye, fromTarget = target.far ? -target.place : p - target.place;
        const double a = glm::length(fromEye), b = target.far ? 1 : glm::length(fromTarget);
        if (!(a > 0 && b > 0)) return false;
        const DVec3 u = fromEye / a, v = fromTarget / b, pull = u + v;
        const double along = -glm::dot(pull, jet.normal),
                     press = convex ? std::max(0.0, along) : along;
        const Frame frame(jet.normal);
        const DVec3 basis[2] = {frame.s, frame.t};
        double g[2], h[2][2];
        for (int i = 0; i < 2; ++i) {
            g[i] = glm::dot(pull, basis[i]);
            const DVec3 turn = jet.turn(basis[i]);
            for (int j = 0; j < 2; ++j) {
                const double same = i == j;
                h[i][j] = (same - glm::dot(u, basis[i]) * glm::dot(u, basis[j])) / a +
                          press * glm::dot(turn, basis[j]);
                if (!target.far)
                    h[i][j] += (same - glm::dot(v, basis[i]) * glm::dot(v, basis[j])) / b;
            }
        }
        const double determinant = h[0][0] * h[1][1] - h[0][1] * h[1][0];
        if (determinant == 0) return false;
        const DVec3 move = (g[1] * h[0][1] - g[0] * h[1][1]) / determinant * basis[0] +
                           (g[0] * h[1][0] - g[1] * h[0][0]) / determinant * basis[1];
        DVec3 localMove = shape.localVector(move);
        const double length = glm::length(localMove);
        if (!(length < kInfinity)) return false;
        if (length > kLongestStep) localMove *= kLongestStep / length;
        const DVec3 next = project(shape, local + localMove, face);
        const double moved = glm::length(next - local);
        local = next;
        if (length <= kTolerance) {
            out = shape.center + shape.worldFromLocal * local;
            const DVec3 toEye = glm::normalize(eye - out),
                        toTarget = target.far ? target.place : glm::normalize(target.place - out);
            const double here = glm::dot(toEye, jet.normal), there = glm::dot(toTarget, jet.normal);
            constexpr double kGrazing =
                1e-6;  // Nearer to the horizon the equations lose their digits.
            return here > kGrazing && there > kGrazing;
        }
        if (moved == 0) return false;  // held at the face's edge
    }
    return false;
}

/// Directions from the shape's centre towards eye and target, in local space, halfway.
DVec3 between(const ShapeInstance& shape, const DVec3& from, const DVec3& eye,
              const MirrorTarget& target) {
    const DVec3 toEye = shape.localPoint(eye) - from,
                toTarget = target.far ? shape.localVector(target.place)
                                      : shape.localPoint(target.place) - from;
    return glm::normalize(toEye) + glm::normalize(toTarget);
}

}  // namespace

int faceCount(const ShapeInstance& shape) { return std::visit(Faces{}, shape.shape).count; }

bool isFlat(const ShapeInstance& shape, int face) {
    return face >= std::visit(Faces{}, shape.shape).curved;
}

int findMirrorPoints(const ShapeInstance& shape, int face, const DVec3& eye,
                     const MirrorTarget& target, std::array<DVec3, kMaxMirrorPoints>& out) {
    const auto* torus = std::get_if<CanonicalTorus>(&shape.shape);
    if (!torus) {
        // Off the ends of cylinders and the apex of cones.
        DVec3 ahead = between(shape, DVec3(0.0), eye, target);
        if (!std::holds_alternative<CanonicalSphere>(shape.shape))
            ahead.y = std::clamp(ahead.y, -0.5, 0.5);
        const DVec3 start = project(shape, ahead, face);
        return solve(shape, face, eye, target, start, out[0]) ? 1 : 0;
    }
    // From where the tube turns towards eye and target, on their side and on the other: seen from
    // afar these two are all.
    constexpr int kStarts = 2;
    constexpr double kSame = 1e-6;  // local
    const DVec3 ahead = between(shape, DVec3(0.0), eye, target);
    const double azimuth = std::atan2(ahead.x, ahead.z);
    int count = 0;
    for (int i = 0; i < kStarts; ++i) {
        const double phi = azimuth + i * (2 * kPi / kStarts);
        const DVec3 ring(std::sin(phi), 0, std::cos(phi));
        DVec3 found;
        if (!solve(shape, face, eye, target,
                   project(shape, ring + torus->ratio * between(shape, ring, eye, target), face),
                   found))
            continue;
        const auto known = std::any_of(out.begin(), out.begin() + count, [&](const DVec3& p) {
            return glm::length(shape.localVector(p - found)) < kSame;
        });
        if (!known) out[static_cast<std::size_t>(count++)] = found;
    }
    return count;
}

double Reflected::areaAt(double distance) const {
    return std::abs(
        glm::dot(glm::cross(footprint[0] + distance * turn[0], footprint[1] + distance * turn[1]),
                 direction));
}

Reflected reflectAt(const ShapeInstance& shape, int face, const DVec3& eye, const DVec3& point) {
    const SurfaceJet jet(shape, shape.localPoint(point), face);
    const DVec3 along = point - eye;
    const double distance = glm::length(along);
    const DVec3 in = along / distance;
    const double across = glm::dot(in, jet.normal);
    Reflected out;
    out.direction = glm::normalize(in - 2 * across * jet.normal);
    const Frame frame(in);
    const DVec3 basis[2] = {frame.s, frame.t};
    for (int i = 0; i < 2; ++i) {
        const DVec3& turned = basis[i];
        out.footprint[i] = distance * (turned - glm::dot(turned, jet.normal) / across * in);
        const DVec3 normalTurn = jet.turn(out.footprint[i]);
        out.turn[i] =
            turned - 2.0 * ((glm::dot(turned, jet.normal) + glm::dot(in, normalTurn)) * jet.normal +
                            across * normalTurn);
    }
    out.spread = std::abs(glm::dot(glm::cross(out.turn[0], out.turn[1]), out.direction));
    return out;
}

}  // namespace glint
