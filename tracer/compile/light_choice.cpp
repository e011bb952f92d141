#include "tracer/compile/light_choice.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace glint {

namespace {

/// Up to this many lights are looked at one by one if some are aimed: a cluster hides which of its
/// lights shines here. Efficiency to that with clusters: 1.7 for the 15 lights of
/// tests/bench/scenes/path/spots.json, but 0.94 for the 14 ball lamps of depth_of_field.json.
constexpr std::size_t kEach = 16;

/// Sorts [begin, end) so that neighbours in space come together: halves along the widest axis.
void sortByPlace(const std::vector<LightBounds>& lights, std::span<std::uint32_t> part,
                 std::size_t size) {
    if (part.size() <= size) return;
    DVec3 lower(kInfinity), upper(-kInfinity);
    for (const std::uint32_t i : part) {
        lower = glm::min(lower, lights[i].center);
        upper = glm::max(upper, lights[i].center);
    }
    const DVec3 extent = upper - lower;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                     : extent.y >= extent.z                       ? 1
                                                                  : 2;
    const std::size_t half = (part.size() / 2 + size - 1) / size * size;
    std::nth_element(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(half), part.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                         const double x = lights[a].center[axis], y = lights[b].center[axis];
                         return x < y || (x == y && a < b);
                     });
    sortByPlace(lights, part.first(half), size);
    sortByPlace(lights, part.subspan(half), size);
}

/// Around the aims of all; everywhere, if that leaves out nothing.
LightAim aimOf(const std::vector<LightBounds>& lights, std::span<const std::uint32_t> part) {
    DVec3 sum(0.0);
    for (const std::uint32_t i : part) {
        if (lights[i].aim.everywhere()) return {};
        sum += lights[i].aim.axis;
    }
    const double length = glm::length(sum);
    if (!(length > 1e-6)) return {};
    const DVec3 axis = sum / length;
    double spread = 0, cosBeyond = 1;
    for (const std::uint32_t i : part) {
        const LightAim& aim = lights[i].aim;
        spread = std::max(spread,
                          std::acos(std::clamp(glm::dot(aim.axis, axis), -1.0, 1.0)) + aim.spread);
        cosBeyond = std::min(cosBeyond, aim.cosBeyond);
    }
    return spread + std::acos(cosBeyond) < kPi ? LightAim(axis, spread, cosBeyond) : LightAim();
}

LightBounds boundsOf(const std::vector<LightBounds>& lights, std::span<const std::uint32_t> part) {
    LightBounds out;
    out.aim = aimOf(lights, part);
    DVec3 lower(kInfinity), upper(-kInfinity);
    for (const std::uint32_t i : part) {
        out.power += lights[i].power;
        lower = glm::min(lower, lights[i].center);
        upper = glm::max(upper, lights[i].center);
    }
    out.center = 0.5 * (lower + upper);
    for (const std::uint32_t i : part)
        out.radius =
            std::max(out.radius, glm::length(lights[i].center - out.center) + lights[i].radius);
    return out;
}

}  // namespace

LightChoice::LightChoice(std::vector<LightBounds> lights) : lights_(std::move(lights)) {
    if (lights_.empty()) return;
    if (std::ranges::none_of(lights_, [](const LightBounds& l) { return l.power > 0; }))
        for (LightBounds& light : lights_) light.power = 1;
    order_.resize(lights_.size());
    std::iota(order_.begin(), order_.end(), 0u);
    // Lights from infinitely far first, each a cluster of its own.
    const auto near = std::stable_partition(order_.begin(), order_.end(), [&](std::uint32_t i) {
        return lights_[i].radius == kInfinity;
    });
    const auto far = static_cast<std::uint32_t>(near - order_.begin());
    const std::span<std::uint32_t> rest(order_.data() + far, order_.size() - far);
    const bool eachAlone = rest.size() <= kEach && std::ranges::any_of(rest, [&](std::uint32_t i) {
                               return !lights_[i].aim.everywhere();
                           });
    const std::size_t size =
        eachAlone
            ? 1
            : static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(rest.size()))));
    if (!rest.empty()) sortByPlace(lights_, rest, size);
    clusterOf_.resize(lights_.size());
    for (std::uint32_t begin = 0; begin < order_.size();) {
        const auto end = begin < far ? begin + 1
                                     : std::min(begin + static_cast<std::uint32_t>(size),
                                                static_cast<std::uint32_t>(order_.size()));
        const std::span<const std::uint32_t> part(order_.data() + begin, end - begin);
        clusters_.push_back(
            {end - begin == 1 ? lights_[part[0]] : boundsOf(lights_, part), begin, end});
        for (const std::uint32_t light : part)
            clusterOf_[light] = static_cast<std::uint32_t>(clusters_.size() - 1);
        begin = end;
    }
}

/// One of [begin, end) in proportion to its weight; `u` is left uniform for the next choice.
template <class Weight>
LightChoice::Chosen LightChoice::pick(std::uint32_t begin, std::uint32_t end, double& u,
                                      const Weight& weight) {
    constexpr std::uint32_t kKept = 64;
    double kept[kKept];
    const bool keeps = end - begin <= kKept;
    double sum = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
        const double w = weight(i);
        if (keeps) kept[i - begin] = w;
        sum += w;
    }
    if (!(sum > 0)) return {begin, 0};
    double left = u * sum;
    std::uint32_t last = begin;
    double lastWeight = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
        const double w = keeps ? kept[i - begin] : weight(i);
        if (!(w > 0)) continue;
        last = i, lastWeight = w;
        if (left < w) break;
        left -= w;
    }
    u = std::clamp(left / lastWeight, 0.0, 1 - 0x1p-53);
    return {last, lastWeight / sum};
}

LightChoice::Chosen LightChoice::choose(const DVec3& from, const DVec3& normal, double u) const {
    const Chosen cluster =
        pick(0, static_cast<std::uint32_t>(clusters_.size()), u,
             [&](std::uint32_t i) { return clusters_[i].bounds.importance(from, normal); });
    const Cluster& c = clusters_[cluster.light];
    if (c.end - c.begin == 1) return {order_[c.begin], cluster.probability};
    const Chosen light = pick(c.begin, c.end, u, [&](std::uint32_t i) {
        return lights_[order_[i]].importance(from, normal);
    });
    return {order_[light.light], cluster.probability * light.probability};
}

double LightChoice::probability(const DVec3& from, const DVec3& normal, std::uint32_t light) const {
    const Cluster& own = clusters_[clusterOf_[light]];
    double all = 0, within = 0;
    for (const Cluster& cluster : clusters_) all += cluster.bounds.importance(from, normal);
    if (!(all > 0)) return 0;
    const double share = own.bounds.importance(from, normal) / all;
    if (own.end - own.begin == 1) return share;
    for (std::uint32_t i = own.begin; i < own.end; ++i)
        within += lights_[order_[i]].importance(from, normal);
    return within > 0 ? share * lights_[light].importance(from, normal) / within : 0;
}

}  // namespace glint
