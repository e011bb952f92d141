// The other side of connections.h: what a path that has followed a surface's own directions over a
// caster remembers of its way, and the density with which a connection would have found it.
#pragma once

#include "tracer/math/ball_chain.h"
#include "tracer/render/scattering.h"

namespace glint {

/// How a path goes over a caster: the number of pieces inside, or out of a box from within.
struct Passage {
    static constexpr int kLeave = -1, kReflection = 0, kThrough = 1;
};

/// What roulette on connections goes by: the throughput at a surface times what it sends on.
[[nodiscard]] inline float connectionDrive(const Rgb& throughput,
                                           const CompiledMaterial& material) {
    return 2 * maxComponent(throughput) * material.smoothAlbedo;
}

/// Probability of trying a passage over `caster` from `from` to a light of this solid angle.
/// Measured on rooms and floors
/// (`glint-bench choices`); dimmer, wider and farther ones bring less than their rays cost.
[[nodiscard]] inline double connectionChance(const Caster& caster, const DVec3& from, int passage,
                                             float drive, double solidAngle) {
    constexpr double kSharp =
        0.1;  // sr: wider lights are found well enough by the surface's own directions.
    constexpr double kLeast = 1e-3;
    double strength = passage == Passage::kReflection ? static_cast<double>(caster.reflects) : 0.0;
    if (caster.refracts && passage != Passage::kReflection)
        strength = passage > Passage::kThrough ? static_cast<double>(caster.reflects) : 1.0;
    const DVec3 apart = caster.center - from;
    const double near = caster.radius < kInfinity
                            ? std::min(1.0, caster.radius * caster.radius / glm::dot(apart, apart))
                            : 1.0;
    const double q =
        static_cast<double>(drive) * strength * near * std::min(1.0, kSharp / solidAngle);
    return q < kLeast ? 0 : std::min(1.0, q);
}

/// The geometry between a surface and a place on a light, in radii of a ball.
struct BallFrame {
    ChainEnds ends;
    DVec3 toX{0.0},
        across{0.0};  ///< unit vectors from the centre: to x, and perpendicular to it on y's side
    bool valid = false;  ///< both lie outside the ball

    BallFrame(const Caster& ball, const DVec3& x, const DVec3& y, bool far) {
        constexpr double kClear =
            1e-9;  // Nearer than this to the ball the equations lose their digits.
        const DVec3 fromCenter = x - ball.center, target = far ? y : y - ball.center;
        const double dx = glm::length(fromCenter), dy = far ? 1 : glm::length(target);
        valid = dx > ball.radius * (1 + kClear) && (far || dy > ball.radius * (1 + kClear));
        if (!valid) return;
        toX = fromCenter / dx;
        const DVec3 toY = target / dy, normal = glm::cross(toX, toY);
        ends = {ball.radius / dx, far ? 0 : ball.radius / dy, glm::length(normal),
                glm::dot(toX, toY)};
        across = ends.sine > 1e-14 ? glm::cross(normal, toX) / ends.sine : Frame(toX).s;
    }
    /// On the surface at an angle from x about the centre.
    [[nodiscard]] DVec3 around(double angle) const {
        return std::cos(angle) * toX + std::sin(angle) * across;
    }
};

/// How far a path that left a smooth surface has come on its way over a caster.
struct ChainProgress {
    enum class State : std::uint8_t { None, Started, Inside, Complete };
    static constexpr int kMostChords = 2;

    State state = State::None;
    int passage = 0;
    const Caster* caster = nullptr;
    double sine = 0, cosine = 1;  ///< balls: of incidence
    double spread = 1;    ///< faces: solid angle at the surface per solid angle behind the caster
    DVec3 mirrored{0.0};  ///< faces, reflection: the surface's place seen in the mirror
    double pdf = 0;   ///< of the direction at the surface, times the chances of the branches taken
    float drive = 0;  ///< see connectionDrive()

    /// Right behind a smooth surface of the shape `from` that sends its path into a direction of
    /// this density and into these media.
    static ChainProgress start(const RenderScene& scene, std::uint32_t from,
                               const MediaStack& media, double pdf, float drive) {
        ChainProgress out;
        if (scene.casters.empty() || media.size() > 1) return out;
        if (!media.empty()) {
            if (media[0] == from) return out;
            out.caster = scene.casters.find(media[0]);
            if (!out.caster || out.caster->kind == Caster::Kind::Ball || !out.caster->refracts)
                return out;
            out.passage = Passage::kLeave;
        }
        out.state = State::Started;
        out.pdf = pdf;
        out.drive = drive;
        return out;
    }

    /// The path takes a delta branch at `point`; `from`: the smooth surface, `direction`: in which
    /// the point was reached.
    void advance(const RenderScene& scene, const SurfacePoint& point, const DeltaBranch& branch,
                 double chance, const DVec3& from, const DVec3& direction) {
        if (state == State::None) return;
        const bool reflected = sameSide(point.wo, branch.wi), complete = state == State::Complete;
        const Caster* met = branch.straight || complete ? nullptr : scene.casters.find(point.shape);
        const State before = state;
        state = State::None;
        if (!met) return;
        pdf *= chance;
        if (!reflected)
            spread *= static_cast<double>(std::abs(branch.wi.z)) /
                      (static_cast<double>(point.eta) * static_cast<double>(point.eta) *
                       static_cast<double>(std::abs(point.wo.z)));
        if (before == State::Inside || passage == Passage::kLeave) {
            if (met == caster && !point.outside) goOnInside(reflected);
            return;
        }
        const bool closed = CasterTable::isClosed(scene.shapes[point.shape]);
        if ((closed && !point.outside) || (!reflected && !met->refracts)) return;
        caster = met;
        if (met->kind == Caster::Kind::Ball) {
            sine =
                std::min(1.0, glm::length(glm::cross(direction, met->center - from)) / met->radius);
            cosine = std::sqrt(1 - sine * sine);
        } else {
            mirrored = from - 2 * glm::dot(from - point.position, point.frame.n) * point.frame.n;
        }
        state = reflected ? State::Complete : State::Inside;
    }

  private:
    void goOnInside(bool reflected) {
        if (passage == Passage::kLeave) {
            if (!reflected) state = State::Complete;
            return;
        }
        if (++passage > (caster->kind == Caster::Kind::Ball ? kMostChords : 1)) return;
        state = reflected ? State::Inside : State::Complete;
    }
};

/// Density per solid angle at x with which a connection finds the complete chain that ends at `y`
/// (far lights: goes in the direction `y`), where it came by `incoming`. `normal`: the light's
/// there; not for far ones.
[[nodiscard]] inline double connectionPdf(const RenderScene& scene, const ChainProgress& chain,
                                          std::uint32_t light, const DVec3& x, const DVec3& y,
                                          const DVec3& incoming, const DVec3& normal) {
    const Caster& caster = *chain.caster;
    const CompiledLight& emitter = scene.lights.lights[light];
    const bool far = isFar(emitter);
    const double picked = scene.casters.pickProbability(light);
    if (!(picked > 0)) return 0;
    const double chosen =
        picked * connectionChance(caster, x, chain.passage, chain.drive,
                                  targetSolidAngle(caster, emitter, scene.casters, scene.shapes));
    if (!(chosen > 0)) return 0;
    if (caster.kind == Caster::Kind::Faces) {
        if (chain.passage == Passage::kReflection)
            return chosen * lightPdf(scene.lights, scene.shapes, light, chain.mirrored, incoming);
        return far ? chosen * targetPdf(caster, emitter, scene.lights, scene.shapes, incoming) /
                         chain.spread
                   : 0;
    }
    const BallFrame frame(caster, x, y, far);
    if (!frame.valid) return 0;
    const double spread =
        ballChainSpread(frame.ends, caster.ior, chain.passage, chain.sine, chain.cosine);
    const double perPlace =
        far ? spread
            : spread / (caster.radius * caster.radius) * std::abs(glm::dot(incoming, normal));
    return chosen * targetPdf(caster, emitter, scene.lights, scene.shapes, incoming) / perPlace;
}

}  // namespace glint
