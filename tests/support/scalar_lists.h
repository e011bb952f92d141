// The model that ShapeLists is held to, in tests and measurements: every shape decided in double,
// one after the other.
#pragma once

#include <tuple>
#include <type_traits>
#include <vector>

#include "tracer/compile/shape_lists.h"

namespace glint::test {

class ScalarLists {
  public:
    explicit ScalarLists(const std::vector<ShapeInstance>& instances) {
        for (std::size_t i = 0; i < instances.size(); ++i) {
            const ShapeInstance& instance = instances[i];
            std::visit(
                [&]<class Canonical>(const Canonical& shape) {
                    const auto index = static_cast<std::uint32_t>(i);
                    if constexpr (std::is_same_v<Canonical, CanonicalSphere>) {
                        if (const double scale = similarityScale(instance.localFromWorld);
                            scale > 0) {
                            balls_.push_back({instance.center, DMat3(scale), shape, scale, index,
                                              instance.dielectric});
                            return;
                        }
                    }
                    std::get<std::vector<Entry<Canonical>>>(entries_).push_back(
                        {instance.center, instance.localFromWorld, shape, index,
                         instance.dielectric});
                },
                instance.shape);
        }
    }

    [[nodiscard]] ShapeHit closest(const Ray& ray, const MediaStack& media,
                                   double tMax = kInfinity) const {
        ShapeHit best{tMax, kNoShape, 0};
        double bestOrder = tMax;
        bool bestIsDielectric = false;
        const double place = coordinateSum(ray.origin);
        forEach([&](const auto& entry) {
            const Start start = startOf(ray, media, entry.index, entry.dielectric);
            const Crossing c = firstHit(entry, ray, start);
            double order = hitOrder(c.t, ray, start, entry.dielectric), other = bestOrder;
            if (!(order < tMax)) return false;
            const bool mayTie =
                best.found() && std::abs(order - other) < kTieRange * (other + place);
            if (mayTie) {
                if (!entry.dielectric) order = tieOrder(placed(entry), ray, c);
                if (!bestIsDielectric) other = tieOrderOf(best, ray);
            }
            if (order < other || (order == other && best.found() && entry.index < best.shape)) {
                best = {c.t, entry.index, c.face};
                bestOrder = hitOrder(c.t, ray, start, entry.dielectric);
                bestIsDielectric = entry.dielectric;
            }
            return false;
        });
        return best;
    }
    [[nodiscard]] bool occluded(const Ray& ray, const MediaStack& media, double tMax,
                                std::uint32_t ignored) const {
        return forEach([&](const auto& entry) {
            return entry.index != ignored &&
                   firstHit(entry, ray, startOf(ray, media, entry.index, entry.dielectric)).t <
                       tMax;
        });
    }

  private:
    template <class Canonical>
    struct Entry {
        DVec3 center;
        DMat3 localFromWorld;
        Canonical shape;
        std::uint32_t index;
        bool dielectric;
    };
    struct Ball {
        DVec3 center;
        DMat3 localFromWorld;
        CanonicalSphere shape;
        double inverseRadius;
        std::uint32_t index;
        bool dielectric;
    };

    static double similarityScale(const DMat3& m) {
        const double s = glm::dot(m[0], m[0]);
        const auto near = [s](double x, double y) { return std::abs(x - y) <= 4e-16 * s; };
        return near(glm::dot(m[1], m[1]), s) && near(glm::dot(m[2], m[2]), s) &&
                       near(glm::dot(m[0], m[1]), 0) && near(glm::dot(m[0], m[2]), 0) &&
                       near(glm::dot(m[1], m[2]), 0)
                   ? std::sqrt(s)
                   : 0;
    }
    template <class Entry>
    static auto placed(const Entry& e) {
        return Placed<decltype(e.shape)>{e.shape, e.localFromWorld, e.center, e.index};
    }
    static Crossing firstHit(const Ball& ball, const Ray& ray, Start start) {
        return firstHitOf(placed(ball), ray, (ray.origin - ball.center) * ball.inverseRadius,
                          ray.direction * ball.inverseRadius, start);
    }
    template <class Canonical>
    static Crossing firstHit(const Entry<Canonical>& entry, const Ray& ray, Start start) {
        return firstHitOf(placed(entry), ray, entry.localFromWorld * (ray.origin - entry.center),
                          entry.localFromWorld * ray.direction, start);
    }
    [[nodiscard]] double tieOrderOf(const ShapeHit& hit, const Ray& ray) const {
        double order = 0;
        forEach([&](const auto& entry) {
            if (entry.index != hit.shape) return false;
            order = tieOrder(placed(entry), ray, Crossing{hit.t, hit.face});
            return true;
        });
        return order;
    }
    /// Until visit(entry) is true.
    template <class Visit>
    bool forEach(Visit&& visit) const {
        const auto any = [&](const auto& list) {
            for (const auto& entry : list)
                if (visit(entry)) return true;
            return false;
        };
        return any(balls_) ||
               std::apply([&](const auto&... list) { return (any(list) || ...); }, entries_);
    }

    std::vector<Ball> balls_;
    std::tuple<std::vector<Entry<CanonicalSphere>>, std::vector<Entry<CanonicalBox>>,
               std::vector<Entry<CanonicalPlane>>, std::vector<Entry<CanonicalQuad>>,
               std::vector<Entry<CanonicalDisk>>, std::vector<Entry<CanonicalCylinder>>,
               std::vector<Entry<CanonicalCone>>, std::vector<Entry<CanonicalTorus>>>
        entries_;
};

}  // namespace glint::test
