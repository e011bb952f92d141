#include "tracer/io/scene_check.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "tracer/io/field_reader.h"
#include "tracer/io/material_graph.h"

namespace glint {

namespace {

constexpr std::size_t kMostViews = 9;
constexpr const char* kNonzeroRemedy = "give it a length above 0";

bool isZero(const Color& c) { return c.r == 0 && c.g == 0 && c.b == 0; }
bool isZero(const DVec3& v) { return v == DVec3(0.0); }

/// Unit vector, also for lengths whose square overflows; zero for zero.
DVec3 unit(const DVec3& v) {
    const double largest = maxComponent(absolute(v));
    return largest > 0 ? glm::normalize(v / largest) : DVec3(0.0);
}

class Checker {
  public:
    explicit Checker(const Scene& scene) : scene_(scene), materials_(materialGraph(scene)) {}

    std::vector<Error> run() {
        checkCameras();
        checkEnvironment();
        checkMaterials();
        checkGroups();
        checkObjects();
        checkLights();
        return std::move(problems_);
    }

  private:
    /// worldFromGroup, and whether it can be inverted.
    struct Place {
        Affine world;
        bool sound = true;
    };

    void add(std::string pointer, std::string message, std::string remedy) {
        problems_.push_back({.message = std::move(message),
                             .pointer = std::move(pointer),
                             .remedy = std::move(remedy)});
    }

    /// Calls `check(value, "/section/index", id)` for each entry of a table.
    template <class Table, class Check>
    void forEach(const Table& table, const std::string& section, Check&& check) {
        std::size_t index = 0;
        table.forEach([&](auto id, const auto& value) {
            check(value, "/" + section + "/" + std::to_string(index++), id);
        });
    }

    void checkCameras() {
        if (!scene_.activeCamera) checkCamera(scene_.camera, "/camera");
        forEach(scene_.cameras, "cameras",
                [&](const Camera& camera, const std::string& at, CameraId) {
                    checkCamera(camera, at);
                });
        for (std::size_t i = 0; i < scene_.views.size(); ++i) {
            const std::string at = "/views/" + std::to_string(i);
            checkCamera(scene_.views[i], at);
            if (i >= kMostViews) add(at, "there are more than nine views", "remove the rest");
        }
    }

    void checkCamera(const Camera& camera, const std::string& at) {
        const DVec3 view = unit(camera.target / 2.0 - camera.position / 2.0);
        // Below this sine of the angle between view and up, rounding decides what is right and
        // left.
        constexpr double kSmallestSine = 1e-9;
        if (isZero(view))
            add(at + "/target", "the camera's target is its position", "move one of them");
        else if (isZero(camera.up))
            add(at + "/up", "up has no direction", kNonzeroRemedy);
        else if (glm::length(glm::cross(view, unit(camera.up))) < kSmallestSine)
            add(at + "/up", "up lies along the view",
                "turn it, as [0, 0, -1] for a view straight down");
        if (camera.verticalFovDegrees >= 180)
            add(at + "/vertical_fov_degrees", "the angle of view is not below 180",
                "use a smaller one");
    }

    void checkEnvironment() {
        const Environment& environment = scene_.environment;
        const Color color = environment.effectiveColor();
        if (!environment.image.empty() && environment.sky)
            add("/environment/sky", "the environment has both an image and a sky",
                "remove one of them");
        if (environment.sky && isZero(environment.sky->sunDirection))
            add("/environment/sky/sun_direction", "the sun has no direction", kNonzeroRemedy);
        if (!(environment.intensity * std::max({color.r, color.g, color.b, 1.0}) <= kLargestColor))
            add("/environment/intensity", "colour times intensity is beyond 1e30",
                "use a smaller one");
    }

    void checkMaterials() {
        for (const MaterialId id : materials_.closingCycle) inCycle_.insert(id.value);
        forEach(
            scene_.materials, "materials",
            [&](const Material& material, const std::string& at, MaterialId id) {
                if (material.name == "clear")
                    add(at + "/name", "\"clear\" is the name of nothing at all in a mix",
                        "choose another name");
                if (inCycle_.contains(id.value))
                    add(at, "the mix " + inQuotes(material.name) + " contains itself",
                        "mix other materials");
                if (const auto found = materials_.content.find(id.value);
                    found != materials_.content.end() && found->second.leaves > kMaxMixLeaves)
                    add(at,
                        "the mix blends more than " + std::to_string(kMaxMixLeaves) + " materials",
                        "nest fewer mixes");
                if (const auto* translucent = std::get_if<Translucent>(&material.value))
                    checkTranslucent(*translucent, at);
            });
    }

    void checkTranslucent(const Translucent& material, const std::string& at) {
        if (material.reflectance.texture || material.transmittance.texture) return;
        const Color &r = material.reflectance.value, &t = material.transmittance.value;
        // Decimal fractions such as 0.7 + 0.3 may round to just above 1.
        constexpr double kMost = 1 + 1e-12;
        if (r.r + t.r > kMost || r.g + t.g > kMost || r.b + t.b > kMost)
            add(at, "reflectance and transmittance sum to more than 1", "lower one of them");
    }

    void checkTransform(const Transform& transform, const std::string& at) {
        const bool flat = !transform.matrix && (transform.scale.x == 0 || transform.scale.y == 0 ||
                                                transform.scale.z == 0);
        if (flat)
            add(at + "/transform/scale", "a scale is 0", "use another factor");
        else if (!inverse(toAffine(transform)))
            add(at + (transform.matrix ? "/transform/matrix" : "/transform"),
                "the transform cannot be inverted",
                "use one that keeps three dimensions and finite sizes");
    }

    /// The transform by itself, and together with those of the groups above. Whatever is wrong
    /// above is not held against it.
    void checkPlace(const Transform& transform, GroupId parent, const std::string& at) {
        const std::size_t before = problems_.size();
        checkTransform(transform, at);
        const Place& above = place(parent);
        if (problems_.size() == before && above.sound &&
            !inverse(above.world * toAffine(transform)))
            add(at + "/transform", "the transform cannot be inverted together with its groups'",
                "use less extreme scales");
    }

    /// The groups, each after the one that holds it; one that closes a cycle is a problem and
    /// counts as the top.
    void checkGroups() {
        std::unordered_map<std::uint32_t, std::string> pointers;
        forEach(scene_.groups, "groups",
                [&](const Group&, const std::string& at, GroupId id) { pointers[id.value] = at; });
        for (const GroupId start : scene_.groups.ids()) {
            std::vector<GroupId> chain;
            for (GroupId at = start; isNew(at); at = scene_.groups.at(at).parent) {
                opened_.insert(at.value);
                chain.push_back(at);
            }
            if (chain.empty()) continue;
            const Group& top = scene_.groups.at(chain.back());
            if (opened_.contains(top.parent.value) && !places_.contains(top.parent.value))
                add(pointers[chain.back().value] + "/parent",
                    "the group " + inQuotes(top.name) + " contains itself",
                    "put it into another group");
            for (auto id = chain.rbegin(); id != chain.rend(); ++id) {
                const Group& group = scene_.groups.at(*id);
                checkPlace(group.transform, group.parent, pointers[id->value]);
                const Affine world = place(group.parent).world * toAffine(group.transform);
                places_[id->value] = {world, inverse(world).has_value()};
            }
        }
    }

    [[nodiscard]] bool isNew(GroupId group) const {
        return scene_.groups.find(group) && !opened_.contains(group.value);
    }

    /// Where a group is in the world; for none, the world itself.
    [[nodiscard]] const Place& place(GroupId group) const {
        static const Place top;
        const auto found = places_.find(group.value);
        return found == places_.end() ? top : found->second;
    }

    void checkObjects() {
        forEach(
            scene_.objects, "objects", [&](const Object& object, const std::string& at, ObjectId) {
                checkPlace(object.transform, object.parent, at);
                if (std::holds_alternative<Plane>(object.shape) && !isZero(object.emission))
                    add(at + "/emission", "an infinite plane cannot emit light",
                        "use a quad, or a light");
                const bool sheet = std::holds_alternative<Quad>(object.shape) ||
                                   std::holds_alternative<Disk>(object.shape);
                if (sheet && hasSolidGlass(object.material))
                    add(at + "/material",
                        "glass on a " + std::string(kindOf(object.shape)) + ", which has no inside",
                        "set \"thin\" in the glass");
            });
    }

    [[nodiscard]] bool hasSolidGlass(MaterialId material) const {
        const auto found = materials_.content.find(material.value);
        return found != materials_.content.end() && found->second.solidGlass;
    }

    void checkLights() {
        forEach(scene_.lights, "lights", [&](const Light& light, const std::string& at, LightId) {
            const auto* spot = std::get_if<SpotLight>(&light.value);
            if (spot && spot->position == spot->target)
                add(at + "/target", "the light's target is its position", "move one of them");
            const auto* sun = std::get_if<SunLight>(&light.value);
            if (sun && isZero(sun->direction))
                add(at + "/direction", "the sun has no direction", kNonzeroRemedy);
        });
    }

    const Scene& scene_;
    MaterialGraph materials_;
    std::unordered_set<std::uint32_t> inCycle_;
    std::unordered_set<std::uint32_t> opened_;         ///< groups already walked over
    std::unordered_map<std::uint32_t, Place> places_;  ///< of groups, by id
    std::vector<Error> problems_;
};

}  // namespace

std::vector<Error> sceneProblems(const Scene& scene) { return Checker(scene).run(); }

}  // namespace glint
