// LightGroups: which sources of light share a sum, so that a live picture can be mixed anew from
// the sums when only colours and intensities change. At most kMaxLightGroups: those that the
// document names, and each other source on its own where that many fit, else all others together.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>

#include "tracer/scene/scene.h"

namespace glint {

inline constexpr std::size_t kMaxLightGroups = 4;

class LightGroups {
  public:
    explicit LightGroups(const Scene& scene);

    /// Number of groups, at least 1.
    [[nodiscard]] std::size_t count() const { return count_; }
    /// The group of a source; 0 for what gives no light.
    [[nodiscard]] std::uint8_t of(ObjectId id) const { return find(objects_, id); }
    [[nodiscard]] std::uint8_t of(LightId id) const { return find(lights_, id); }
    [[nodiscard]] std::uint8_t ofEnvironment() const { return environment_; }

  private:
    template <class IdType>
    static std::uint8_t find(const std::map<IdType, std::uint8_t>& groups, IdType id) {
        const auto found = groups.find(id);
        return found == groups.end() ? std::uint8_t{0} : found->second;
    }

    std::map<ObjectId, std::uint8_t> objects_;
    std::map<LightId, std::uint8_t> lights_;
    std::uint8_t environment_ = 0;
    std::size_t count_ = 1;
};

/// Factors on the light of each group, per channel.
struct LightMix {
    std::array<DVec3, kMaxLightGroups> gain{DVec3(1.0), DVec3(1.0), DVec3(1.0), DVec3(1.0)};
    [[nodiscard]] bool isUnit() const { return *this == LightMix{}; }
    bool operator==(const LightMix&) const = default;
};

/// What turns the light of `before` into that of `after`, two documents that differ at most in
/// colours, intensities and visibility of lights, in emissions, and in the environment's colour and
/// intensity: one factor a group of `groups`, which are those of `before`. Nothing where no such
/// factors exist: a channel that was black is not, or sources of one group change differently.
[[nodiscard]] std::optional<LightMix> lightMixBetween(const Scene& before, const Scene& after,
                                                      const LightGroups& groups);

}  // namespace glint
