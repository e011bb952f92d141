#include "tracer/scene/light_groups.h"

#include <string>

namespace glint {

namespace {

/// What a source gives, up to a factor that none of the edits in question changes; black where it
/// is not part of the picture.
DVec3 lightOf(const Scene& scene, const Object& object) {
    const bool emits = isVisible(scene, object) && !std::holds_alternative<Plane>(object.shape);
    return emits ? toVector(object.emission) : DVec3(0.0);
}
DVec3 lightOf(const Scene&, const Light& light) {
    return light.visible ? toVector(lightColor(light)) : DVec3(0.0);
}
DVec3 lightOf(const Environment& e) {
    const Color tint = e.sky && !e.color ? Color{1, 1, 1} : e.effectiveColor();
    return toVector(tint) * e.intensity;
}

/// Calls visit(source, its group's name, its light) for every source that is not black; the
/// environment is last.
template <class Visit>
void forEachSource(const Scene& scene, Visit&& visit) {
    const auto visitAll = [&](const auto& table) {
        table.forEach([&](auto id, const auto& source) {
            if (const DVec3 light = lightOf(scene, source); light != DVec3(0.0))
                visit(id, source.lightGroup, light);
        });
    };
    visitAll(scene.objects);
    visitAll(scene.lights);
    if (const DVec3 light = lightOf(scene.environment); light != DVec3(0.0))
        visit(nullptr, scene.environment.lightGroup, light);
}

/// The factors found so far for one group; none yet for channels that are black.
struct GroupGain {
    DVec3 gain{1.0};
    std::array<bool, 3> known{};

    /// False: no one factor turns all of the group's sources into what they are to be.
    bool agree(const DVec3& before, const DVec3& after) {
        for (int c = 0; c < 3; ++c) {
            if (before[c] == 0) {
                if (after[c] != 0) return false;
                continue;
            }
            const double ratio = after[c] / before[c];
            auto& isKnown = known[static_cast<std::size_t>(c)];
            if (isKnown && !(std::abs(ratio - gain[c]) <= 1e-12 * ratio))
                return false;  // A few roundings of one division.
            gain[c] = ratio;
            isKnown = true;
        }
        return true;
    }
};

}  // namespace

LightGroups::LightGroups(const Scene& scene) {
    std::map<std::string, std::uint8_t> named;
    std::size_t single = 0;
    forEachSource(scene, [&](auto, const std::string& name, const DVec3&) {
        if (name.empty())
            ++single;
        else
            named.emplace(name, 0);
    });
    if (named.size() > kMaxLightGroups || (named.size() == kMaxLightGroups && single > 0))
        return;  // All in group 0.
    std::uint8_t next = 0;
    for (auto& [name, group] : named) group = next++;
    const bool singlesFit = named.size() + single <= kMaxLightGroups;
    count_ = std::max<std::size_t>(1, named.size() + (singlesFit ? single : 1));
    forEachSource(scene, [&]<class IdType>(IdType id, const std::string& name, const DVec3&) {
        const std::uint8_t group = name.empty() ? next : named.at(name);
        if (name.empty() && singlesFit) ++next;
        if constexpr (std::is_same_v<IdType, ObjectId>)
            objects_[id] = group;
        else if constexpr (std::is_same_v<IdType, LightId>)
            lights_[id] = group;
        else
            environment_ = group;
    });
}

std::optional<LightMix> lightMixBetween(const Scene& before, const Scene& after,
                                        const LightGroups& groups) {
    std::array<GroupGain, kMaxLightGroups> gains;
    bool mixable = true;
    const auto compare = [&](std::uint8_t group, const DVec3& a, const DVec3& b) {
        mixable = mixable && gains[group].agree(a, b);
    };
    const auto compareAll = [&](const auto& table, const auto& tableAfter) {
        table.forEach([&](auto id, const auto& source) {
            const auto* next = tableAfter.find(id);
            compare(groups.of(id), lightOf(before, source),
                    next ? lightOf(after, *next) : DVec3(0.0));
        });
    };
    compareAll(before.objects, after.objects);
    compareAll(before.lights, after.lights);
    compare(groups.ofEnvironment(), lightOf(before.environment), lightOf(after.environment));
    if (!mixable) return std::nullopt;
    LightMix mix;
    for (std::size_t g = 0; g < gains.size(); ++g) mix.gain[g] = gains[g].gain;
    return mix;
}

}  // namespace glint
