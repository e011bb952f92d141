// The scene document: a plain value. Copies are cheap and share what they do not change; undo is
// the old value. Everything is in doubles, metres and degrees as in the file; compile/ narrows and
// converts. Format: see resources/.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tracer/lights/all.h"
#include "tracer/materials/all.h"
#include "tracer/math/transform.h"
#include "tracer/scene/ids.h"
#include "tracer/scene/table.h"
#include "tracer/shapes/all.h"
#include "tracer/textures/texture.h"

namespace glint {

/// world = T * R * S with R = Rz * Ry * Rx; or a matrix that replaces all three.
struct Transform {
    DVec3 translate{0, 0, 0};
    DVec3 rotateDegrees{0, 0, 0};
    DVec3 scale{1, 1, 1};
    std::optional<std::array<double, 12>> matrix;  ///< row-major 3 x 4

    bool operator==(const Transform&) const = default;
    static constexpr auto fields() {
        return std::tuple{Field{"translate", &Transform::translate, {.unit = "m", .doc = "Place"}},
                          Field{"rotate_degrees",
                                &Transform::rotateDegrees,
                                {.unit = "deg", .doc = "Turn about x, then y, then z"}},
                          Field{"scale",
                                &Transform::scale,
                                {.doc = "Factor along each axis, before the turn; not 0"}},
                          Field{"matrix",
                                &Transform::matrix,
                                {.doc = "Row-major 3 x 4 matrix instead of the three above"}}};
    }
};

struct Object {
    std::string name;
    Shape shape;
    MaterialId material;  ///< none: black
    Color emission;       ///< radiance of the outward side
    bool twoSided = false;
    Transform transform;
    GroupId parent;
    bool visible = true;
    bool locked = false;
    std::string lightGroup;

    bool operator==(const Object&) const = default;
    static constexpr auto fields() {
        return std::tuple{
            Field{"name", &Object::name, {.required = true, .doc = "Unique name"}},
            Field{"shape", &Object::shape, {.required = true, .doc = "Form"}},
            Field{"material", &Object::material, {.doc = "What it is made of; black if none"}},
            Field{"emission",
                  &Object::emission,
                  {.min = 0, .unit = "W/(sr m2)", .doc = "Radiance of the outward side"}},
            Field{"two_sided", &Object::twoSided, {.doc = "Both sides emit"}},
            Field{
                "transform", &Object::transform, {.doc = "Place, turn and scale within the group"}},
            Field{"parent", &Object::parent, {.doc = "Group that holds it"}},
            Field{"visible", &Object::visible, {.doc = "Part of the picture"}},
            Field{"locked", &Object::locked, {.doc = "Cannot be picked in the viewport"}},
            Field{"light_group", &Object::lightGroup, {.doc = "Group of lights it belongs to"}}};
    }
};

struct Group {
    std::string name;
    GroupId parent;
    Transform transform;
    bool visible = true;
    bool locked = false;

    bool operator==(const Group&) const = default;
    static constexpr auto fields() {
        return std::tuple{
            Field{"name", &Group::name, {.required = true, .doc = "Unique name"}},
            Field{"parent", &Group::parent, {.doc = "Group that holds it"}},
            Field{"transform", &Group::transform, {.doc = "Place, turn and scale of all it holds"}},
            Field{"visible", &Group::visible, {.doc = "Part of the picture"}},
            Field{"locked", &Group::locked, {.doc = "Cannot be picked in the viewport"}}};
    }
};

struct Material {
    std::string name;
    AllMaterials::Variant value;
    bool operator==(const Material&) const = default;
};

struct Light {
    std::string name;
    AllLights::Variant value;
    bool visible = true;
    std::string lightGroup;
    bool operator==(const Light&) const = default;
};

enum class Projection { Perspective, Orthographic };
[[nodiscard]] constexpr auto enumNames(Projection) {
    return std::array<std::string_view, 2>{"perspective", "orthographic"};
}

struct Camera {
    std::string name;  ///< only within `cameras`
    DVec3 position{0, 1.5, 6};
    DVec3 target{0, 0.5, 0};
    DVec3 up{0, 1, 0};
    Projection projection = Projection::Perspective;
    double verticalFovDegrees = 40;
    double orthoHeight = 2;
    double apertureRadius = 0;
    std::optional<double> focusDistance;  ///< default: |target - position|

    bool operator==(const Camera&) const = default;
    static constexpr auto fields() {
        return std::tuple{
            Field{"name", &Camera::name, {.doc = "Unique name"}},
            Field{"position", &Camera::position, {.unit = "m", .doc = "Place of the eye"}},
            Field{"target",
                  &Camera::target,
                  {.unit = "m", .doc = "Point in the middle of the picture"}},
            Field{"up", &Camera::up, {.doc = "Direction that is up in the picture"}},
            Field{"projection", &Camera::projection, {.doc = "With or without perspective"}},
            Field{"vertical_fov_degrees",
                  &Camera::verticalFovDegrees,
                  {.min = 0,
                   .max = 180,
                   .exclusiveMin = true,
                   .unit = "deg",
                   .doc = "Angle of view over the full height; below 180"}},
            Field{"ortho_height",
                  &Camera::orthoHeight,
                  {.min = 0,
                   .exclusiveMin = true,
                   .unit = "m",
                   .doc = "Height of the picture without perspective"}},
            Field{"aperture_radius",
                  &Camera::apertureRadius,
                  {.min = 0, .unit = "m", .doc = "Radius of the lens; 0 is sharp everywhere"}},
            Field{"focus_distance",
                  &Camera::focusDistance,
                  {.min = 0,
                   .exclusiveMin = true,
                   .unit = "m",
                   .doc = "Along the view axis; the target if not given"}}};
    }
};

enum class Filter { Box, Tent, BlackmanHarris };
[[nodiscard]] constexpr auto enumNames(Filter) {
    return std::array<std::string_view, 3>{"box", "tent", "blackman_harris"};
}

struct FilmSettings {
    int width = 960, height = 540;
    Filter filter = Filter::Box;
    double filterRadius = 0.5;

    bool operator==(const FilmSettings&) const = default;
    static constexpr auto fields() {
        return std::tuple{
            Field{"width",
                  &FilmSettings::width,
                  {.min = 1, .max = 65536, .unit = "px", .doc = "Width of the picture"}},
            Field{"height",
                  &FilmSettings::height,
                  {.min = 1, .max = 65536, .unit = "px", .doc = "Height of the picture"}},
            Field{"filter", &FilmSettings::filter, {.doc = "Weight of samples within a pixel"}},
            Field{"filter_radius",
                  &FilmSettings::filterRadius,
                  {.min = 0,
                   .max = 16,
                   .exclusiveMin = true,
                   .unit = "px",
                   .doc = "Half width of the filter"}}};
    }
};

enum class View { Standard };
[[nodiscard]] constexpr auto enumNames(View) { return std::array<std::string_view, 1>{"standard"}; }

struct Display {
    double exposureEv = 0;
    View view = View::Standard;

    bool operator==(const Display&) const = default;
    static constexpr auto fields() {
        return std::tuple{
            Field{
                "exposure_ev",
                &Display::exposureEv,
                {.min = -100, .max = 100, .unit = "EV", .doc = "Each step doubles the brightness"}},
            Field{"view", &Display::view, {.doc = "From linear light to the screen"}}};
    }
};

enum class Integrator { Path, Classic };
[[nodiscard]] constexpr auto enumNames(Integrator) {
    return std::array<std::string_view, 2>{"path", "classic"};
}

struct RenderSettings {
    Integrator integrator = Integrator::Path;
    int maxDepth = 16;
    int spp = 256;
    int seed = 0;
    double timeSeconds = 0;
    double errorPercent = 0;
    double clamp = 0;
    bool transparentShadows = false;

    bool operator==(const RenderSettings&) const = default;
    static constexpr auto fields() {
        return std::tuple{
            Field{
                "integrator",
                &RenderSettings::integrator,
                {.doc = "path: physically right; classic: the recursive algorithm of the report"}},
            Field{"max_depth",
                  &RenderSettings::maxDepth,
                  {.min = 0,
                   .max = 100000,
                   .doc = "Most surface interactions on a path; light seen directly is 0"}},
            Field{"spp",
                  &RenderSettings::spp,
                  {.min = 1, .max = 16777216, .doc = "Samples a pixel to stop at"}},
            Field{"seed",
                  &RenderSettings::seed,
                  {.min = 0, .max = 2147483647, .doc = "Other seeds give other noise"}},
            Field{"time_seconds",
                  &RenderSettings::timeSeconds,
                  {.min = 0, .unit = "s", .doc = "Time to stop at; 0 is no limit"}},
            Field{"error_percent",
                  &RenderSettings::errorPercent,
                  {.min = 0,
                   .max = 100,
                   .unit = "%",
                   .doc = "Error of the picture to stop at, as a share of its mean brightness; 0 "
                          "is no limit"}},
            Field{"clamp",
                  &RenderSettings::clamp,
                  {.min = 0, .doc = "Largest sample value, biased; 0 is off"}},
            Field{"transparent_shadows",
                  &RenderSettings::transparentShadows,
                  {.doc = "classic: glass tints shadows instead of blocking light"}}};
    }
};

struct Sky {
    DVec3 sunDirection{0.3, 0.6, 0.5};
    double turbidity = 3;

    bool operator==(const Sky&) const = default;
    static constexpr auto fields() {
        return std::tuple{Field{"sun_direction", &Sky::sunDirection, {.doc = "Towards the sun"}},
                          Field{"turbidity",
                                &Sky::turbidity,
                                {.min = 1, .max = 10, .doc = "Haze: 2 clear, 10 hazy"}}};
    }
};

/// Light from infinitely far: a colour, an image times a colour, or a sky. Without any it is black.
struct Environment {
    std::optional<Color> color;  ///< default: black, or white where an image is set
    std::string image;           ///< path relative to the scene; empty: none
    std::optional<Sky> sky;
    double intensity = 1;
    double rotationDegrees = 0;
    bool visibleToCamera = true;
    std::string lightGroup;

    bool operator==(const Environment&) const = default;
    static constexpr auto fields() {
        return std::tuple{
            Field{"color",
                  &Environment::color,
                  {.min = 0,
                   .unit = "W/(sr m2)",
                   .doc = "Colour of the sky, or factor on the image"}},
            Field{"image",
                  &Environment::image,
                  {.doc = "Latitude-longitude picture, relative to the scene"}},
            Field{"sky", &Environment::sky, {.doc = "Computed sky"}},
            Field{"intensity",
                  &Environment::intensity,
                  {.min = 0, .doc = "Factor on the brightness"}},
            Field{"rotation_degrees",
                  &Environment::rotationDegrees,
                  {.unit = "deg", .doc = "Turn about the upward axis"}},
            Field{"visible_to_camera",
                  &Environment::visibleToCamera,
                  {.doc = "Seen behind the objects; light and reflections stay"}},
            Field{
                "light_group", &Environment::lightGroup, {.doc = "Group of lights it belongs to"}}};
    }
    [[nodiscard]] Color effectiveColor() const {
        return color.value_or(image.empty() ? Color{0, 0, 0} : Color{1, 1, 1});
    }
};

struct Scene {
    Table<Object, ObjectId> objects;
    Table<Group, GroupId> groups;
    Table<Material, MaterialId> materials;
    Table<Texture, TextureId> textures;
    Table<Light, LightId> lights;
    Table<Camera, CameraId> cameras;
    Camera camera;  ///< the active one, unless `activeCamera` names one of `cameras`
    CameraId activeCamera;
    std::vector<Camera> views;  ///< at most nine saved ones
    Environment environment;
    FilmSettings film;
    Display display;
    RenderSettings render;
    std::string editor;  ///< JSON text of the file's `editor` object, kept as it is; empty: none

    /// Deep, with a short cut where both sides share storage.
    bool operator==(const Scene&) const = default;

    [[nodiscard]] const Camera& viewCamera() const {
        return activeCamera ? cameras.at(activeCamera) : camera;
    }
};

/// What a light without a surface shines with: its intensity or irradiance.
[[nodiscard]] const Color& lightColor(const Light& light);
[[nodiscard]] Color& lightColor(Light& light);
/// The object's own or a group's transform as a matrix.
[[nodiscard]] Affine toAffine(const Transform& transform);
/// The matrix as a Transform: translate, rotate and scale where that is exact, else `matrix`.
[[nodiscard]] Transform toTransform(const Affine& affine);
/// Product of all groups' transforms from `group` upwards; identity for none.
[[nodiscard]] Affine worldFromGroup(const Scene& scene, GroupId group);
/// Full transform of an object.
[[nodiscard]] Affine worldFromObject(const Scene& scene, const Object& object);
/// The object and all groups above it are visible.
[[nodiscard]] bool isVisible(const Scene& scene, const Object& object);

}  // namespace glint
