#include "tracer/compile/compiler.h"

#include <algorithm>
#include <map>
#include <optional>

#include "tracer/compile/lengths.h"
#include "tracer/compile/media_contacts.h"
#include "tracer/compile/render_scene.h"
#include "tracer/compile/view.h"
#include "tracer/lights/sky.h"
#include "tracer/math/bounds.h"
#include "tracer/scene/light_groups.h"

namespace glint {

namespace {

/// One run of compile(): fills `out_` part by part.
class Compiler {
  public:
    Compiler(const Scene& scene, const std::filesystem::path& folder, AssetCache& assets,
             const RenderScene* previous)
        : scene_(scene), folder_(folder), assets_(assets), previous_(previous) {}

    Result<Compiled> run() {
        if (auto problem = cameraProblem(scene_.viewCamera())) return std::move(*problem);
        addMaterials();
        addShapes();
        addLights();
        addEnvironment();
        out_->lights.finish(out_->shapes);
        out_->settings = scene_.render;
        if (scene_.render.integrator == Integrator::Path) {
            out_->casters = makeCasters(out_->shapes, out_->materials, out_->lights);
            out_->highlights = makeHighlights(out_->shapes, out_->materials, out_->lights);
        }
        ++compiled_.stats.lightTablesBuilt;
        out_->lightGroups = groups_.count();
        addLists();
        addLightBuffers();
        findPassableGlass();
        findFeatures();
        findClearShadows();
        setView(*out_, scene_);
        warnOfSettings();
        compiled_.scene = std::move(out_);
        return std::move(compiled_);
    }

  private:
    void warn(CompileWarning::Kind kind, std::string pointer, std::string message,
              std::string remedy = {}) {
        compiled_.warnings.push_back({kind, Error{.message = std::move(message),
                                                  .pointer = std::move(pointer),
                                                  .remedy = std::move(remedy)}});
    }

    void addMaterials() {
        BsdfBuilder builder(scene_);
        scene_.materials.forEach([&](MaterialId id, const Material& material) {
            MaterialLeaves leaves = builder.build(id);
            for (const std::string& what : leaves.notBuilt)
                warn(CompileWarning::Kind::NotBuiltYet, "/materials/" + material.name,
                     "material \"" + material.name + "\": " + what);
            materialIndex_[id] = static_cast<std::uint32_t>(out_->materials.size());
            out_->materials.push_back(finish(std::move(leaves)));
            out_->materials.back().bit = materialBit(id);
        });
        black_ = static_cast<std::uint32_t>(out_->materials.size());
        out_->materials.emplace_back().bit = materialBit({});
    }

    /// All of its smooth part is one narrow lobe.
    static bool isNarrow(const BsdfLeaf& leaf) {
        const auto narrow = [](const auto* lobe) {
            return lobe && lobe->gloss().alpha <= Gloss::kWidest;
        };
        return narrow(std::get_if<MetalBsdf>(&leaf)) || narrow(std::get_if<PhongBsdf>(&leaf));
    }

    static CompiledMaterial finish(MaterialLeaves leaves) {
        CompiledMaterial out;
        out.dielectric = leaves.dielectric;
        out.medium = leaves.medium;
        out.leaves = std::move(leaves.leaves);
        for (const WeightedLeaf& weighted : out.leaves) {
            float chance = 0;
            std::visit(
                [&]<class Leaf>(const Leaf& leaf) {
                    if constexpr (Leaf::kSmooth)
                        chance = maxComponent(weighted.weight * leaf.albedo());
                    if constexpr (Leaf::kDelta) out.hasDelta = true;
                    if constexpr (kIsRough<Leaf>) out.isRough = true;
                    if constexpr (std::is_same_v<Leaf, ClearBsdf> ||
                                  std::is_same_v<Leaf, ThinGlassBsdf>)
                        out.straight += weighted.weight;
                },
                weighted.leaf);
            out.pick.push_back(chance);
            if (!isNarrow(weighted.leaf)) out.broadAlbedo += chance;
            out.smoothAlbedo += chance;
        }
        for (float& chance : out.pick)
            if (out.smoothAlbedo > 0) chance /= out.smoothAlbedo;
        return out;
    }

    void addShapes() {
        std::vector<std::pair<ObjectId, Affine>> placed;
        Bounds bounds;
        scene_.objects.forEach([&](ObjectId id, const Object& object) {
            if (!isVisible(scene_, object)) return;
            if (std::holds_alternative<Mesh>(object.shape)) {
                warn(CompileWarning::Kind::NotBuiltYet, "/objects/" + object.name,
                     "object \"" + object.name + "\": meshes are not drawn yet");
                return;
            }
            const Affine world = worldFromObject(scene_, object);
            const DVec3 half = halfSize(object.shape, world.linear);
            if (!isFinite(world.translation - half) || !isFinite(world.translation + half)) {
                warn(CompileWarning::Kind::Ignored, "/objects/" + object.name,
                     "object \"" + object.name + "\" is left out: its place or size is not finite",
                     "correct its transform and its shape");
                return;
            }
            if (std::max(largest(world.translation), largest(half)) > kMostLength)
                return warnOfLength(object);
            placed.emplace_back(id, world);
            if (!std::holds_alternative<Plane>(object.shape))
                bounds.add(Bounds::around(world.translation, half));
        });
        if (!bounds.isEmpty()) out_->origin = bounds.center();
        std::vector<ShapeInstance> shapes;
        shapes.reserve(placed.size());
        for (const auto& [id, world] : placed) addShape(id, scene_.objects.at(id), world, shapes);
        out_->shapes = std::move(shapes);
    }

    /// Half the size of the world box around a shape's local box.
    static DVec3 halfSize(const Shape& shape, const DMat3& linear) {
        const DVec3 half = std::visit(
            []<class S>(const S& s) -> DVec3 {
                if constexpr (std::is_same_v<S, Mesh>)
                    return DVec3(0.0);
                else if constexpr (std::is_same_v<S, Torus>)
                    return {s.majorRadius + s.minorRadius, s.minorRadius,
                            s.majorRadius + s.minorRadius};
                else if constexpr (std::is_same_v<S, Quad> || std::is_same_v<S, Disk>)
                    return DVec3(1, 0, 1) * s.halfExtents();
                else
                    return s.halfExtents();
            },
            shape);
        return absolute(linear[0]) * half.x + absolute(linear[1]) * half.y +
               absolute(linear[2]) * half.z;
    }

    void addShape(ObjectId id, const Object& object, const Affine& world,
                  std::vector<ShapeInstance>& to) {
        ShapeInstance instance;
        instance.object = id;
        DVec3 half(1.0);
        bool closed = false;
        std::visit(
            [&]<class S>(const S& shape) {
                if constexpr (!std::is_same_v<S, Mesh>) {
                    instance.shape = shape.canonical();
                    half = shape.halfExtents();
                    closed = decltype(shape.canonical())::closed;
                }
            },
            object.shape);
        DMat3 linear = world.linear;
        for (int axis = 0; axis < 3; ++axis) linear[axis] *= half[axis];
        for (int axis = 0; axis < 3; ++axis)
            if (const double length = largest(linear[axis]); length > 0 && length < kLeastLength)
                return warnOfLength(object);
        const auto localFromWorld = inverse(Affine{linear, DVec3(0.0)});
        if (!localFromWorld) {
            warn(CompileWarning::Kind::Ignored, "/objects/" + object.name,
                 "object \"" + object.name + "\" is left out: its transform cannot be inverted",
                 "give it a scale that is not 0");
            return;
        }
        instance.worldFromLocal = linear;
        instance.localFromWorld = localFromWorld->linear;
        instance.normalScale = 1 / glm::length(localFromWorld->linear[0]);
        instance.center = world.translation - out_->origin;
        const auto material = materialIndex_.find(object.material);
        instance.material = material == materialIndex_.end() ? black_ : material->second;
        instance.dielectric = closed && out_->materials[instance.material].dielectric;
        const auto index = static_cast<std::uint32_t>(to.size());
        if (const Rgb emission = toRgb(object.emission);
            !isBlack(emission) && !std::holds_alternative<Plane>(object.shape)) {
            instance.light = static_cast<std::uint32_t>(out_->lights.lights.size());
            const double area = std::pow(std::cbrt(glm::determinant(linear)), 2);
            out_->lights.lights.push_back(
                {.kind = LightKind::Area,
                 .emission = emission,
                 .shape = index,
                 .twoSided = object.twoSided,
                 .power = static_cast<double>(luminance(emission)) * 4 * kPi * area,
                 .group = groups_.of(id)});
        }
        to.push_back(instance);
    }

    /// The previous scene's lists where its shapes are the same, else its hierarchy where they have
    /// moved.
    void addLists() {
        const auto coincide = [](const ShapeInstance& a, const ShapeInstance& b) {
            return a.coincides(b);
        };
        if (previous_ && std::ranges::equal(out_->shapes, previous_->shapes, coincide)) {
            out_->lists = previous_->lists;
            return;
        }
        std::optional<ShapeLists> moved;
        if (previous_) moved = previous_->lists->moved(previous_->shapes, out_->shapes);
        ++(moved ? compiled_.stats.shapeListsRefitted : compiled_.stats.shapeListsBuilt);
        out_->lists = std::make_shared<const ShapeLists>(moved ? std::move(*moved)
                                                               : ShapeLists(out_->shapes));
    }

    /// The previous ones where neither shapes nor lights have moved.
    void addLightBuffers() {
        const auto inPlace = [](const CompiledLight& a, const CompiledLight& b) {
            return a.kind == b.kind && a.position == b.position && a.direction == b.direction &&
                   a.sin2Angle == b.sin2Angle && a.shape == b.shape;
        };
        const bool same =
            previous_ && previous_->lists == out_->lists &&
            std::ranges::equal(out_->lights.lights, previous_->lights.lights, inPlace);
        out_->lightBuffers =
            same ? previous_->lightBuffers : LightBuffers(out_->lights, out_->shapes, *out_->lists);
    }

    void warnOfLength(const Object& object) {
        warn(CompileWarning::Kind::Ignored, "/objects/" + object.name,
             "object \"" + object.name +
                 "\" is left out: it is too small, too large or too far away",
             kLengthRemedy);
    }

    void addLights() {
        scene_.lights.forEach([&](LightId id, const Light& light) {
            const std::size_t first = out_->lights.lights.size();
            if (light.visible)
                std::visit([&](const auto& value) { addLight(value, groups_.of(id)); },
                           light.value);
            for (std::size_t i = first; i < out_->lights.lights.size(); ++i)
                out_->lights.lights[i].id = id;
        });
    }
    void addLight(const PointLight& light, std::uint8_t group) {
        if (isBlack(light.intensity)) return;
        out_->lights.lights.push_back({.kind = LightKind::Point,
                                       .position = light.position - out_->origin,
                                       .intensity = toVector(light.intensity),
                                       .power = 4 * kPi * luminance(light.intensity),
                                       .group = group});
    }
    void addLight(const SpotLight& light, std::uint8_t group) {
        const DVec3 axis = light.target - light.position;
        if (isBlack(light.intensity) || !(glm::length(axis) > 0)) return;
        const double outer = degreesToRadians(light.coneDegrees / 2),
                     inner = outer * (1 - light.blend);
        out_->lights.lights.push_back(
            {.kind = LightKind::Spot,
             .position = light.position - out_->origin,
             .direction = glm::normalize(axis),
             .intensity = toVector(light.intensity),
             .cosInner = static_cast<float>(std::cos(inner)),
             .cosOuter = static_cast<float>(std::cos(outer)),
             .power = 2 * kPi * (1 - std::cos(outer)) * luminance(light.intensity),
             .group = group});
    }
    void addLight(const SunLight& light, std::uint8_t group) {
        addSun(light.direction, toRgb(light.irradiance), light.angleDegrees, group);
    }

    /// `direction`: of travel.
    void addSun(const DVec3& direction, const Rgb& irradiance, double angleDegrees,
                std::uint8_t group) {
        if (isBlack(irradiance) || !(glm::length(direction) > 0)) return;
        const double sine = std::sin(degreesToRadians(angleDegrees / 2)), sin2 = sine * sine;
        if (sin2 > 0)
            out_->lights.sunDiscs.push_back(static_cast<std::uint32_t>(out_->lights.lights.size()));
        out_->lights.lights.push_back(
            {.kind = LightKind::Sun,
             .direction = -glm::normalize(direction),
             .emission = sin2 > 0 ? irradiance * static_cast<float>(1 / (kPi * sin2)) : irradiance,
             .sin2Angle = sin2,
             .power = static_cast<double>(luminance(irradiance)) * skyArea(),
             .group = group});
    }

    void addEnvironment() {
        const Environment& e = scene_.environment;
        CompiledEnvironment& out = out_->lights.environment;
        const double turn = degreesToRadians(std::remainder(e.rotationDegrees, 360.0));
        out.sinRotation = std::sin(turn);
        out.cosRotation = std::cos(turn);
        out.visibleToCamera = e.visibleToCamera;
        out.group = groups_.ofEnvironment();
        std::shared_ptr<const Image> image;
        if (!e.image.empty()) {
            auto loaded =
                assets_.image(folder_ / e.image, ColorSpace::Auto, compiled_.stats.imagesLoaded);
            if (!loaded.ok()) {
                Error error = loaded.error();
                error.pointer = "/environment/image";
                if (error.remedy.empty())
                    error.remedy = "correct the path; it is relative to the scene file";
                compiled_.warnings.push_back(
                    {CompileWarning::Kind::MissingAsset, std::move(error)});
            }
            image = loaded.ok() ? loaded.value() : missingImage();
        } else if (e.sky) {
            image = assets_.sky(*e.sky);
        }
        const Rgb tint = e.sky && !e.color ? Rgb(1.0f) : toRgb(e.effectiveColor());
        out.scale = tint * static_cast<float>(e.intensity);
        if (e.sky && e.image.empty()) {
            const SkySun sun = skySun(*e.sky);
            addSun(-out.worldFromMap(sun.direction), sun.irradiance * out.scale, sun.angleDegrees,
                   out.group);
        }
        if (!image || out.isBlack()) return;
        out.map = reusedMap(image);
        out_->lights.environmentLight = static_cast<std::uint32_t>(out_->lights.lights.size());
        out_->lights.lights.push_back(
            {.kind = LightKind::Environment,
             .power = kPi * static_cast<double>(luminance(out.scale * out.map->meanRadiance())) *
                      skyArea(),
             .group = out.group});
    }

    /// The previous scene's map where it was made from the same picture.
    std::shared_ptr<const EnvironmentMap> reusedMap(const std::shared_ptr<const Image>& image) {
        const auto& old = previous_ ? previous_->lights.environment.map : nullptr;
        if (old && old->image() == image) return old;
        ++compiled_.stats.environmentTablesBuilt;
        return std::make_shared<const EnvironmentMap>(image);
    }

    /// Area of a disc around the finite scene: what light from infinitely far falls on.
    [[nodiscard]] double skyArea() const {
        double radius2 = 0;
        for (const ShapeInstance& shape : out_->shapes) {
            if (std::holds_alternative<CanonicalPlane>(shape.shape)) continue;
            const DVec3 reach = absolute(shape.center) + absolute(shape.worldFromLocal[0]) +
                                absolute(shape.worldFromLocal[1]) +
                                absolute(shape.worldFromLocal[2]);
            radius2 = std::max(radius2, glm::dot(reach, reach));
        }
        return kPi * (radius2 > 0 ? radius2 : 1.0);
    }

    /// Glass lets shadow rays pass unbent where the media on its sides have one index, or are one.
    void findPassableGlass() {
        if (!mediaMayMatch(*out_)) return;
        if (mostMediaAtOnePlace(*out_, MediaStack::kCapacity) > MediaStack::kCapacity)
            warn(CompileWarning::Kind::Ignored, "/objects",
                 "more than " + std::to_string(MediaStack::kCapacity) +
                     " dielectrics may overlap at one place; rays follow the last " +
                     std::to_string(MediaStack::kCapacity) + " that they enter",
                 "nest fewer of them");
        for (CompiledMaterial& material : out_->materials)
            if (material.dielectric) material.straight = Rgb(1.0f);
    }

    void findFeatures() {
        Features& f = out_->features;
        const auto add = [&](Feature feature, bool present) {
            f |= present ? static_cast<Features>(feature) : 0u;
        };
        for (const ShapeInstance& shape : out_->shapes) {
            const CompiledMaterial& material = out_->materials[shape.material];
            add(Feature::Smooth, material.hasSmooth());
            add(Feature::Delta, material.hasDelta);
            add(Feature::Rough, material.isRough);
            add(Feature::Media, shape.dielectric);
            add(Feature::Straight, !isBlack(material.straight));
        }
        for (const CompiledLight& light : out_->lights.lights) {
            add(Feature::DeltaLights, light.isDelta());
            add(Feature::AreaLights, light.kind == LightKind::Area);
            add(Feature::Sky, light.kind == LightKind::Sun && !light.isDelta());
            add(Feature::SampledSky, light.kind == LightKind::Environment ||
                                         (light.kind == LightKind::Sun && !light.isDelta()));
        }
        add(Feature::Sky, !out_->lights.environment.isBlack());
        add(Feature::Casters, !out_->casters.empty());
        add(Feature::Highlights, !out_->highlights.empty());
    }

    /// Lamps that are dielectrics themselves are met by the media's rules.
    void findClearShadows() {
        out_->clearShadows =
            scene_.render.transparentShadows &&
            std::ranges::all_of(out_->shapes, [&](const ShapeInstance& shape) {
                const CompiledMaterial& material = out_->materials[shape.material];
                return shape.dielectric ? isBlack(material.medium.absorption) && shape.light == ~0u
                                        : isBlack(material.straight);
            });
    }

    void warnOfSettings() {
        if (scene_.render.clamp > 0)
            warn(CompileWarning::Kind::Ignored, "/render/clamp",
                 "the picture is biased: samples are clamped",
                 "set clamp to 0 for an unbiased one");
    }

    const Scene& scene_;
    const std::filesystem::path& folder_;
    AssetCache& assets_;
    const RenderScene* previous_;
    std::shared_ptr<RenderScene> out_ = std::make_shared<RenderScene>();
    Compiled compiled_;
    LightGroups groups_{scene_};
    std::map<MaterialId, std::uint32_t> materialIndex_;
    std::uint32_t black_ = 0;
};

}  // namespace

Result<Compiled> compile(const Scene& scene, const std::filesystem::path& assetFolder,
                         AssetCache& assets, const std::shared_ptr<const RenderScene>& previous) {
    return Compiler(scene, assetFolder, assets, previous.get()).run();
}

std::vector<std::string> featureNames(const RenderScene& scene) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < kFeatureNames.size(); ++i)
        if (scene.features >> i & 1) names.emplace_back(kFeatureNames[i]);
    return names;
}

}  // namespace glint
