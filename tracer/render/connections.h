// Next-event estimation by way of perfect balls and faces: caustics that a mirror, a glass ball or
// a pool of water throws on smooth surfaces, which paths that follow the surfaces' own directions
// find by luck only. Each connection is one path from the surface over the caster to a drawn place
// on a light; both ways of finding it share it by multiple importance sampling. Roulette keeps
// small and dim casters from costing more than they bring.
//
// Sources: Hanika, Droske, Fascione, "Manifold Next Event Estimation", CGF 34(4), 2015, sec. 3, for
// the estimator and its weight. Here all chains between two places are enumerated, so there is no
// walk that could fail: over balls by the roots of one convex equation (math/ball_chain.h), by
// reflection in faces with the mirrored eye, through faces for light from infinitely far. Only
// where all of this holds is a connection made, and only then does the other way share: the path is
// outside all media, or inside one box of glass alone; it goes nowhere straight through a surface;
// the caster is one of compile/casters.h.
#pragma once

#include "tracer/render/chain_progress.h"
#include "tracer/render/shadow.h"

namespace glint {

/// What a connection brings.
struct Connection {
    Rgb value{0.0f};  ///< contribution to the sample
    Vec3 wi{0.0f};    ///< at the surface, local
    std::uint32_t light = 0;
};

/// The smooth surface that connections start at.
struct ConnectionVertex {
    const SurfacePoint& point;
    const CompiledMaterial& material;
    const MediaStack& media;
    Rgb throughput;
    float smoothChance;
    float number;  ///< for roulette, in [0, 1)
    int depth;
    std::uint32_t branch;
    int splits;  ///< at so many dielectrics from here on a path follows both ways
};

/// Weight(pdf of the connection, pdf of the other way) shares a path; Add(Connection) takes what is
/// found.
template <Features F, class Weight, class Add>
class Connections {
  public:
    Connections(KernelState& state, const Sampler& sampler, const ConnectionVertex& vertex,
                const Weight& weight, const Add& add)
        : state_(state),
          scene_(state.scene),
          sampler_(sampler),
          vertex_(vertex),
          weight_(weight),
          add_(add),
          drive_(connectionDrive(vertex.throughput, vertex.material)) {}

    /// Tries every caster.
    void run() {
        for (std::uint32_t i = 0; i < scene_.casters.casters.size(); ++i) {
            const Caster& caster = scene_.casters.casters[i];
            if (vertex_.point.shape == caster.shape) continue;
            constexpr double kGolden = 0.6180339887498949;
            const double place = static_cast<double>(vertex_.number) + kGolden * i;
            roulette_ = place - std::floor(place);
            if (roulette_ <
                connectionChance(caster, vertex_.point.position,
                                 caster.refracts ? Passage::kThrough : Passage::kReflection, drive_,
                                 0))
                tryCaster(caster, i);
        }
    }

  private:
    /// One path over a caster, as far as geometry goes.
    struct Way {
        std::array<DVec3, ChainProgress::kMostChords + 1> points,
            normals;  ///< where the surface is met, from x on; outward
        int passage = 0;
        DVec3 onward{0.0};  ///< unit, from the last point
        double toLight = kInfinity;
        double pdf = 0;  ///< of the connection, per solid angle at x
        std::uint32_t light = 0;
        Rgb radiance{0.0f};

        [[nodiscard]] int meetings() const { return passage > 0 ? passage + 1 : 1; }
        [[nodiscard]] bool reflectsAt(int i) const {
            return passage == Passage::kReflection || (i > 0 && i < passage);
        }
    };

    void tryCaster(const Caster& caster, std::uint32_t index) {
        const SampleBlock u =
            sampler_.block(sampleBlock(SampleUse::Caustic, vertex_.depth, vertex_.branch, index));
        Way way;
        way.light = scene_.casters.pick(static_cast<double>(u.z));
        const double solidAngle = targetSolidAngle(caster, scene_.lights.lights[way.light],
                                                   scene_.casters, scene_.shapes);
        const auto chosen = [&](int passage) {
            const double q =
                connectionChance(caster, vertex_.point.position, passage, drive_, solidAngle);
            return roulette_ < q ? q * scene_.casters.pickProbability(way.light) : 0.0;
        };
        if (caster.kind == Caster::Kind::Ball)
            overBall(caster, way, chosen, {u.x, u.y});
        else
            overFaces(caster, way, chosen, {u.x, u.y});
    }

    [[nodiscard]] bool isDeepEnough(int meetings) const {
        return vertex_.depth + meetings < scene_.settings.maxDepth;
    }

    template <class Chosen>
    void overBall(const Caster& caster, Way& way, const Chosen& chosen, const DVec2& u) {
        const CompiledLight& emitter = scene_.lights.lights[way.light];
        const bool far = isFar(emitter);
        const CasterTarget target = sampleTarget(caster, emitter, scene_.lights, scene_.shapes, u);
        if (!(target.pdf > 0) || isBlack(target.radiance)) return;
        way.radiance = target.radiance;
        const BallFrame frame(caster, vertex_.point.position, target.position, far);
        if (!frame.valid) return;
        const int most = caster.refracts ? ChainProgress::kMostChords : 0;
        for (way.passage = 0; way.passage <= most && isDeepEnough(way.passage + 1); ++way.passage) {
            const double chance = chosen(way.passage);
            if (!(chance > 0)) continue;
            ++state_.work[Work::Connections];
            std::array<BallChain, kMaxBallChains> chains;
            const int count = findBallChains(frame.ends, caster.ior, way.passage, chains);
            for (int i = 0; i < count; ++i) {
                const BallChain& chain = chains[static_cast<std::size_t>(i)];
                const double onward =
                    way.passage > 0 ? kPi - 2 * std::asin(chain.sine / caster.ior) : 0;
                for (int k = 0; k <= way.passage; ++k) {
                    way.normals[static_cast<std::size_t>(k)] =
                        frame.around(chain.side * (chain.first + k * onward));
                    way.points[static_cast<std::size_t>(k)] =
                        caster.center + caster.radius * way.normals[static_cast<std::size_t>(k)];
                }
                const DVec3& last = way.points[static_cast<std::size_t>(way.passage)];
                way.toLight = far ? kInfinity : glm::length(target.position - last);
                way.onward = far ? target.position : (target.position - last) / way.toLight;
                double perPlace =
                    ballChainSpread(frame.ends, caster.ior, way.passage, chain.sine, chain.cosine);
                if (!far) {
                    const double facing = -glm::dot(way.onward, target.normal);
                    if (!(facing > 0) && !emitter.twoSided) continue;
                    perPlace *= std::abs(facing) / (caster.radius * caster.radius);
                }
                way.pdf = chance * target.pdf / perPlace;
                connect(caster, way);
            }
        }
    }

    template <class Chosen>
    void overFaces(const Caster& caster, Way& way, const Chosen& chosen, const DVec2& u) {
        const ShapeInstance& shape = scene_.shapes[caster.shape];
        if (const double chance = chosen(Passage::kReflection); chance > 0 && isDeepEnough(1)) {
            ++state_.work[Work::Connections];
            way.passage = Passage::kReflection;
            for (int face = 0; face < faceCount(shape); ++face)
                reflectIn(caster, faceOf(shape, face), way, chance, u);
        }
        const CompiledLight& emitter = scene_.lights.lights[way.light];
        if (!caster.refracts || !isFar(emitter)) return;
        const CasterTarget target = sampleTarget(caster, emitter, scene_.lights, scene_.shapes, u);
        if (!(target.pdf > 0) || isBlack(target.radiance)) return;
        way.radiance = target.radiance;
        way.onward = target.position;
        way.toLight = kInfinity;
        if (const double chance = chosen(Passage::kLeave); chance > 0 && isDeepEnough(1))
            leaveBox(caster, shape, way, chance * target.pdf);
        if (const double chance = chosen(Passage::kThrough); chance > 0 && isDeepEnough(2))
            passBox(caster, shape, way, chance * target.pdf);
    }

    /// Light sampling from the eye mirrored in the face.
    void reflectIn(const Caster& caster, const CasterFace& face, Way& way, double chance,
                   const DVec2& u) {
        const DVec3& x = vertex_.point.position;
        const double height = glm::dot(x - face.position, face.normal);
        const ShapeInstance& shape = scene_.shapes[caster.shape];
        if (isOn(height, x, shape.center) || (height < 0 && CasterTable::isClosed(shape))) return;
        const LightSample s =
            sampleLight(scene_.lights, scene_.shapes, way.light,
                        {x - 2 * height * face.normal, face.normal, kNoShape, false}, {}, u);
        const double across = glm::dot(s.wi, face.normal);
        if (!(s.pdf > 0) || isBlack(s.radiance) || !(across * height > 0)) return;
        const double toFace = height / across;  // From the mirrored eye, and as far from the eye.
        if (!(toFace < s.distance)) return;
        way.points[0] = x - 2 * height * face.normal + toFace * s.wi;
        way.normals[0] = face.normal;
        const DVec3 outgoing = s.wi - 2 * across * face.normal;
        if (!meetsAt(caster, {x, outgoing, kNoShape, false}, toFace)) return;
        way.onward = s.wi;
        way.toLight = s.distance - toFace;
        way.radiance = s.radiance;
        way.pdf = chance * s.pdf;
        connect(caster, way);
    }
    /// Whether the shape is met where the face's plane is.
    [[nodiscard]] bool meetsAt(const Caster& caster, const Ray& ray, double distance) const {
        const Crossing hit = hitShape(scene_.shapes[caster.shape], caster.shape, ray, {});
        constexpr double kSame = 1e-9;
        return std::abs(hit.t - distance) <= kSame * distance;
    }

    /// From inside a box of glass out through each face that the light comes in by.
    void leaveBox(const Caster& caster, const ShapeInstance& shape, Way& way, double density) {
        if (!vertex_.media.contains(caster.shape)) return;
        ++state_.work[Work::Connections];
        way.passage = Passage::kLeave;
        for (int i = 0; i < 6; ++i) {
            const CasterFace face = faceOf(shape, i);
            DVec3 outgoing(0.0);
            const double spread = bend(way.onward, face.normal, 1 / caster.ior, outgoing);
            const double height = glm::dot(face.position - vertex_.point.position, face.normal);
            if (!(spread > 0 && height > 0)) continue;
            way.normals[0] = face.normal;
            way.points[0] =
                vertex_.point.position + height / glm::dot(outgoing, face.normal) * outgoing;
            if (!holds(shape, way.points[0], i)) continue;
            way.pdf = density / spread;
            connect(caster, way);
        }
    }
    /// In by one face and out by another.
    void passBox(const Caster& caster, const ShapeInstance& shape, Way& way, double density) {
        if (vertex_.media.contains(caster.shape)) return;
        ++state_.work[Work::Connections];
        way.passage = Passage::kThrough;
        for (int last = 0; last < 6; ++last) {
            const CasterFace lastFace = faceOf(shape, last);
            DVec3 inside(0.0), outgoing(0.0);
            const double spreadIn = bend(way.onward, lastFace.normal, 1 / caster.ior, inside);
            if (!(spreadIn > 0)) continue;
            for (int first = 0; first < 6; ++first) {
                const CasterFace firstFace = faceOf(shape, first);
                const double spread =
                    spreadIn * bend(inside, -firstFace.normal, caster.ior, outgoing);
                const double height =
                    glm::dot(vertex_.point.position - firstFace.position, firstFace.normal);
                if (!(spread > 0 && height > 0)) continue;
                way.points[0] = vertex_.point.position -
                                height / glm::dot(outgoing, firstFace.normal) * outgoing;
                if (!holds(shape, way.points[0], first)) continue;
                way.points[1] =
                    way.points[0] + glm::dot(lastFace.position - way.points[0], lastFace.normal) /
                                        glm::dot(inside, lastFace.normal) * inside;
                if (!holds(shape, way.points[1], last)) continue;
                way.normals[0] = firstFace.normal;
                way.normals[1] = lastFace.normal;
                way.pdf = density / spread;
                connect(caster, way);
            }
        }
    }
    /// The direction before a boundary with the normal `n`, on the side of `after`, of a ray that
    /// goes on as `after`; `eta`: index behind over index before. Answers with the solid angle
    /// before per solid angle after, 0 if there is none.
    static double bend(const DVec3& after, const DVec3& n, double eta, DVec3& before) {
        const double cosAfter = glm::dot(after, n);
        const double cos2 = 1 - eta * eta * (1 - cosAfter * cosAfter);
        if (!(cosAfter > 0 && cos2 > 0)) return 0;
        const double cosine = std::sqrt(cos2);
        before = glm::normalize(eta * (after - cosAfter * n) + cosine * n);
        return eta * eta * cosAfter / cosine;
    }
    /// The point of a face's plane lies on the face.
    static bool holds(const ShapeInstance& box, const DVec3& p, int face) {
        const DVec3 local = absolute(box.localPoint(p));
        const int axis = face / 2;
        return local[(axis + 1) % 3] < 1 && local[(axis + 2) % 3] < 1;
    }

    /// What is in between, and the factors along one way with the two ways' densities.
    void connect(const Caster& caster, const Way& way) {
        if (!(way.pdf > 0 && way.pdf < kInfinity)) return;
        const DVec3& x = vertex_.point.position;
        const DVec3 toFirst = way.points[0] - x;
        const double distance = glm::length(toFirst);
        const DVec3 outgoing = toFirst / distance;
        const Vec3 wi = toFloat(vertex_.point.frame.toLocal(outgoing));
        const MediaStack media = mediaBeyond<F>(state_, vertex_.point, vertex_.media, wi);
        const bool inside = way.passage == Passage::kLeave;
        if (inside ? !(media.size() == 1 && media[0] == caster.shape) : !media.empty()) return;
        const BsdfSample f =
            evalSmooth<F>(vertex_.material, vertex_.point.wo, wi, vertex_.point.eta, state_.work);
        if (isBlack(f.f)) return;
        const int last = way.meetings() - 1;
        const std::uint32_t emitter = scene_.lights.lights[way.light].shape;
        if (!isClear(vertex_.point.ray(outgoing, wi.z < 0), media, distance, caster.shape) ||
            !isClearInside(caster, way) ||
            !isClear({way.points[static_cast<std::size_t>(last)], way.onward, caster.shape, false,
                      way.reflectsAt(last)},
                     {}, way.toLight, emitter))
            return;
        // So far all went by what Caster holds, and an edit that changes that starts the picture
        // anew: see sameStructure().
        state_.materials |= scene_.materials[scene_.shapes[caster.shape].material].bit;
        double chance = 1;
        const Rgb passed = alongCaster(caster, way, chance);
        if (isBlack(passed)) return;
        const double other =
            static_cast<double>(f.pdf) * static_cast<double>(vertex_.smoothChance) * chance;
        const auto factor = static_cast<float>(weight_(way.pdf, other) *
                                               static_cast<double>(std::abs(wi.z)) / way.pdf);
        add_(Connection{vertex_.throughput * f.f * passed * way.radiance * factor, wi, way.light});
    }

    /// The factors of the caster's surface and inside; `chance`: of a path that meets it to go this
    /// way.
    [[nodiscard]] Rgb alongCaster(const Caster& caster, const Way& way, double& chance) {
        const CompiledMaterial& material = scene_.materials[scene_.shapes[caster.shape].material];
        Rgb out(1.0f);
        int splits = vertex_.splits;
        DVec3 from = vertex_.point.position;
        for (int i = 0; i < way.meetings(); ++i) {
            const DVec3& point = way.points[static_cast<std::size_t>(i)];
            const double length = glm::length(point - from),
                         z = glm::dot(from - point, way.normals[static_cast<std::size_t>(i)]) /
                             length;
            const bool outside = i == 0 && way.passage != Passage::kLeave;
            if constexpr (has(F, Feature::Media))
                if (!outside) out *= transmittance<F>(material.medium, length, state_.work);
            const Vec3 wo(static_cast<float>(std::sqrt(std::max(0.0, 1 - z * z))), 0,
                          static_cast<float>(z));
            const Branches branches = deltaBranches(
                material, wo, outside ? 1 / material.medium.ior : material.medium.ior, state_.work);
            if (splits > 0 && branches.areTwo(material))
                --splits;
            else
                chance *= branches.chanceOf(material, wo, way.reflectsAt(i));
            out *= branches.weightOf(wo, way.reflectsAt(i));
            from = point;
        }
        return out;
    }

    [[nodiscard]] bool isClear(const Ray& ray, const MediaStack& media, double distance,
                               std::uint32_t ignored) {
        ++state_.rays.shadow;
        return !scene_.lists->occluded(ray, media, distance, ignored, state_.work);
    }
    [[nodiscard]] bool isClearInside(const Caster& caster, const Way& way) {
        for (int i = 0; i + 1 < way.meetings(); ++i) {
            const DVec3 along = way.points[static_cast<std::size_t>(i + 1)] -
                                way.points[static_cast<std::size_t>(i)];
            const double length = glm::length(along);
            if (!(length > 0)) continue;
            MediaStack media;
            media.cross(caster.shape);
            if (!isClear({way.points[static_cast<std::size_t>(i)], along / length, caster.shape,
                          true, way.reflectsAt(i)},
                         media, length, caster.shape))
                return false;
        }
        return true;
    }

    KernelState& state_;
    const RenderScene& scene_;
    const Sampler& sampler_;
    const ConnectionVertex& vertex_;
    const Weight& weight_;
    const Add& add_;
    float drive_;
    double roulette_ = 0;
};

}  // namespace glint
