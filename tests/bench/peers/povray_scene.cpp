#include "tests/bench/peers/povray_scene.h"

#include <cmath>
#include <set>

#include "tests/bench/output.h"
#include "tracer/math/transform.h"

namespace glint::bench {

namespace {

/// POV-Ray fades a lamp by 2 / (1 + (d / this)^2): with so small a distance, by 1 / d^2 [m].
constexpr double kFadeDistance = 1e-3;

std::string text(double x) { return format("%.17g", x); }
std::string text(const DVec3& v) {
    return '<' + text(v.x) + ',' + text(v.y) + ',' + text(v.z) + '>';
}
std::string text(const Color& c) {
    return "rgb<" + text(c.r) + ',' + text(c.g) + ',' + text(c.b) + '>';
}
Color scaled(const Color& c, double factor) { return {c.r * factor, c.g * factor, c.b * factor}; }

struct ShapeText {
    std::string operator()(const Sphere& s) const { return "sphere{0," + text(s.radius); }
    std::string operator()(const Box& s) const {
        return "box{" + text(s.size * -0.5) + ',' + text(s.size * 0.5);
    }
    std::string operator()(const Plane&) const { return "plane{y,0"; }
    std::string operator()(const Quad& s) const {
        const double x = s.size.x / 2, z = s.size.y / 2;
        std::string out = "polygon{5";
        for (const auto& [i, j] : {std::pair{-1, -1}, {-1, 1}, {1, 1}, {1, -1}, {-1, -1}})
            out += ',' + text(DVec3(i * x, 0, j * z));
        return out;
    }
    std::string operator()(const Disk& s) const { return "disc{0,y," + text(s.radius); }
    std::string operator()(const Cylinder& s) const {
        return "cylinder{" + text(DVec3(0, -s.height / 2, 0)) + ',' +
               text(DVec3(0, s.height / 2, 0)) + ',' + text(s.radius);
    }
    std::string operator()(const Cone& s) const {
        return "cone{" + text(DVec3(0, -s.height / 2, 0)) + ',' + text(s.radius) + ',' +
               text(DVec3(0, s.height / 2, 0)) + ",0";
    }
    std::string operator()(const Torus& s) const {
        return "torus{" + text(s.majorRadius) + ',' + text(s.minorRadius);
    }
    std::string operator()(const Mesh&) const { return {}; }
};

class Writer {
  public:
    explicit Writer(const Scene& scene) : scene_(scene) {}

    PovrayScene run() {
        out_ =
            "#version 3.7;\nglobal_settings{assumed_gamma 1 ambient_light 0 adc_bailout Bailout "
            "max_trace_level " +
            std::to_string(std::max(1, scene_.render.maxDepth)) +
            "}\n#default{finish{ambient 0 emission 0 diffuse 1 specular 0}}\n";
        camera();
        environment();
        scene_.objects.forEach([&](ObjectId, const Object& object) { add(object); });
        scene_.lights.forEach([&](LightId, const Light& light) {
            std::visit([&](const auto& l) { add(l); }, light.value);
        });
        return {out_, {notes_.begin(), notes_.end()}};
    }

  private:
    /// By its vectors, so that POV-Ray's left hand does not matter: a ray is direction + x right +
    /// y up, x and y from -1/2 to 1/2.
    void camera() {
        const Camera& camera = scene_.viewCamera();
        const DVec3 forward = glm::normalize(camera.target - camera.position);
        const DVec3 right = glm::normalize(glm::cross(forward, camera.up)),
                    up = glm::cross(right, forward);
        const bool parallel = camera.projection == Projection::Orthographic;
        const double height = parallel
                                  ? camera.orthoHeight
                                  : 2 * std::tan(degreesToRadians(camera.verticalFovDegrees) / 2);
        const double width = height * scene_.film.width / scene_.film.height;
        if (camera.apertureRadius > 0) notes_.insert("the lens is left out");
        out_ += std::string("camera{") + (parallel ? "orthographic " : "perspective ") +
                "location " + text(camera.position) + " direction " + text(forward) + " right " +
                text(right * width) + " up " + text(up * height) + "}\n";
    }

    void environment() {
        const Environment& environment = scene_.environment;
        if (!environment.image.empty()) notes_.insert("the environment's picture is left out");
        out_ += "background{" +
                text(scaled(environment.effectiveColor(),
                            environment.image.empty() ? environment.intensity : 0)) +
                "}\n";
    }

    void add(const Object& object) {
        const std::string shape = std::visit(ShapeText{}, object.shape);
        if (shape.empty()) return void(notes_.insert("meshes are left out"));
        out_ += shape + ' ' + material(object) + " matrix<";
        const std::array<double, 12>& rows = *object.transform.matrix;
        for (std::size_t column = 0; column < 4; ++column)
            for (std::size_t row = 0; row < 3; ++row)
                out_ += (row + column ? "," : "") + text(rows[4 * row + column]);
        out_ += ">}\n";
    }

    std::string material(const Object& object) {
        const auto glow = [&] {
            return "finish{diffuse 0 emission 1} pigment{" + text(object.emission) + '}';
        };
        if (object.emission != Color{}) {
            notes_.insert("what emits lights nothing");
            return glow();
        }
        if (!object.material) return "pigment{rgb 0}";
        return std::visit([&](const auto& m) { return appearance(m); },
                          scene_.materials.at(object.material).value);
    }

    std::string appearance(const Diffuse& m) { return "pigment{" + text(m.color.value) + '}'; }
    std::string appearance(const Mirror& m) {
        return "pigment{rgb 0} finish{diffuse 0 reflection{" + text(m.color.value) + "}}";
    }
    std::string appearance(const Glass& m) {
        if (m.roughness.value > 0 || m.thin || m.priority != 0)
            notes_.insert("glass: rough, thin and prior ones become plain");
        return "pigment{rgbt<1,1,1,1>} finish{diffuse 0 reflection{0,1 fresnel on} "
               "conserve_energy} " +
               interior(m.ior.value, m.absorption.value);
    }
    std::string appearance(const Phong& m) {
        const double sum = std::max(
            1.0, m.diffuse.value + m.specular.value + m.reflection.value + m.refraction.value);
        const double clear = m.refraction.value / sum;
        if (m.specular.value > 0)
            notes_.insert("phong: its highlight is brighter at slanting light");
        // Glint's highlight is specular (n + 2) / (2 pi) cos^n of the light, POV-Ray's phong cos^n
        // of light over pi.
        return "pigment{" + text(m.color.value) + "transmit " + text(clear) + "} finish{diffuse " +
               text(m.diffuse.value / sum / std::max(1e-9, 1 - clear)) + " phong " +
               text(m.specular.value / sum * (m.exponent.value + 2) / 2) + " phong_size " +
               text(m.exponent.value) + " reflection{" +
               text(scaled(m.color.value, m.reflection.value / sum)) + "}} " +
               (clear > 0 ? interior(m.ior.value, m.absorption.value) : "");
    }
    template <class Other>
    std::string appearance(const Other&) {
        notes_.insert(std::string(Other::kind) + " becomes grey");
        return "pigment{rgb 0.5}";
    }

    /// Light fades by exp(-(1 - fade_color) distance / fade_distance).
    static std::string interior(double ior, const Color& absorption) {
        const double strongest = std::max({absorption.r, absorption.g, absorption.b});
        if (strongest == 0) return "interior{ior " + text(ior) + '}';
        const Color left{1 - absorption.r / strongest, 1 - absorption.g / strongest,
                         1 - absorption.b / strongest};
        return "interior{ior " + text(ior) + " fade_power 1001 fade_distance " +
               text(1 / strongest) + " fade_color " + text(left) + '}';
    }

    void add(const PointLight& light) {
        out_ += "light_source{" + text(light.position) + ',' + lamp(light.intensity) + "}\n";
    }
    void add(const SpotLight& light) {
        notes_.insert("spot: its rim fades otherwise");
        const double outer = light.coneDegrees / 2;
        out_ += "light_source{" + text(light.position) + ',' + lamp(light.intensity) +
                " spotlight point_at " + text(light.target) + " radius " +
                text(outer * (1 - light.blend)) + " falloff " + text(outer) + "}\n";
    }
    void add(const SunLight& light) {
        if (light.angleDegrees > 0) notes_.insert("the sun is a point");
        out_ += "light_source{" + text(glm::normalize(light.direction) * -1e5) + ',' +
                text(scaled(light.irradiance, 1 / kPi)) + " parallel point_at 0}\n";
    }
    /// POV-Ray's diffuse light lacks Lambert's 1 / pi.
    static std::string lamp(const Color& intensity) {
        return text(scaled(intensity, 1 / (2 * kPi * kFadeDistance * kFadeDistance))) +
               " fade_power 2 fade_distance " + text(kFadeDistance);
    }

    const Scene& scene_;
    std::string out_;
    std::set<std::string> notes_;
};

}  // namespace

PovrayScene povrayScene(const Scene& scene) { return Writer(scene).run(); }

}  // namespace glint::bench
