#include "tests/support/random_scene.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "tracer/io/material_graph.h"

namespace glint::test {

namespace {

class Maker {
  public:
    explicit Maker(std::uint64_t seed) : random_(seed) {}

    Scene make() {
        fill(scene_.film);
        fill(scene_.display);
        fill(scene_.render);
        makeEnvironment();
        for (int i = count(4); i > 0; --i) scene_.textures.add(named<Texture>());
        for (int i = count(8); i > 0; --i) scene_.materials.add(makeMaterial());
        for (int i = count(5); i > 0; --i) scene_.groups.add(named<Group>());
        for (int i = count(12); i > 0; --i) scene_.objects.add(makeObject());
        for (int i = count(5); i > 0; --i) scene_.lights.add(makeLight());
        makeCameras();
        if (chance(0.3))
            scene_.editor =
                R"({"panels": {"left": 240, "open": true}, "list": [1, 2.5, "x", null]})";
        return std::move(scene_);
    }

  private:
    bool chance(double p) { return std::bernoulli_distribution(p)(random_); }
    int count(int most) { return std::uniform_int_distribution(0, most)(random_); }
    double uniform(double a, double b) { return std::uniform_real_distribution(a, b)(random_); }

    /// A number in the field's range, now plain, now with all its digits, now very large or small.
    double number(const FieldMeta& meta) {
        double value = std::round(uniform(-20, 20)) / 4;
        if (chance(0.5)) value = uniform(-10, 10);
        if (chance(0.1)) value *= std::pow(10, uniform(-25, 25));
        if (value >= meta.min && value <= meta.max && !(meta.exclusiveMin && value == meta.min))
            return value;
        const double low = std::max(meta.min, -1e6), high = std::min(meta.max, low + 1e6);
        return low + (high - low) * uniform(0.001, 0.999);
    }

    std::string text() {
        static const std::vector<std::string> texts{
            "",        "Ball",   "Kugel \xC3\xA4", "\xE7\x90\x83",     "a/b~c",
            "\"q\\\"", "t\tn\n", "clear 1",        "\xF0\x9F\x94\xB4", " "};
        return texts[static_cast<std::size_t>(count(static_cast<int>(texts.size()) - 1))];
    }
    std::string freshName() { return text() + std::to_string(++names_); }

    void random(const FieldMeta& meta, double& out) { out = number(meta); }
    void random(const FieldMeta& meta, int& out) {
        out = static_cast<int>(std::floor(std::max(number(meta), meta.min)));
    }
    void random(const FieldMeta&, bool& out) { out = chance(0.5); }
    void random(const FieldMeta& meta, std::string& out) {
        out = meta.required ? freshName() : text();
    }
    void random(const FieldMeta& meta, Color& out) {
        out = {number(meta), number(meta), number(meta)};
    }
    void random(const FieldMeta& meta, DVec2& out) { out = {number(meta), number(meta)}; }
    void random(const FieldMeta& meta, DVec3& out) {
        out = {number(meta), number(meta), number(meta)};
    }
    void random(const FieldMeta& meta, std::vector<Color>& out) {
        out.resize(static_cast<std::size_t>(count(3)));
        for (Color& color : out) random(meta, color);
    }
    void random(const FieldMeta&, MaterialId& out) { out = someId(scene_.materials); }
    void random(const FieldMeta&, GroupId& out) { out = someId(scene_.groups); }
    void random(const FieldMeta&, MixPart& out) {
        out.material = someId(scene_.materials);
        out.clear = !out.material;
    }
    void random(const FieldMeta&, Transform& out) {
        if (chance(0.3)) return;
        out.translate = {uniform(-5, 5), uniform(-5, 5), uniform(-5, 5)};
        out.rotateDegrees = {uniform(-180, 180), uniform(-180, 180), 90};
        out.scale = {uniform(0.5, 2), -uniform(0.5, 2), 1};
        if (!chance(0.3)) return;
        const Affine a = toAffine(out);
        const DMat3& m = a.linear;
        const DVec3& t = a.translation;
        out = {};
        out.matrix = {m[0].x, m[1].x, m[2].x, t.x,    m[0].y, m[1].y,
                      m[2].y, t.y,    m[0].z, m[1].z, m[2].z, t.z};
    }
    void random(const FieldMeta&, Shape& out) { randomKind<AllShapes>(out); }
    template <class E>
    requires std::is_enum_v<E>
    void random(const FieldMeta&, E& out) {
        out = static_cast<E>(count(static_cast<int>(enumNames(E{}).size()) - 1));
    }
    template <class T>
    void random(const FieldMeta& meta, std::optional<T>& out) {
        if (!chance(0.5)) return;
        out.emplace();
        random(meta, *out);
    }
    template <class T>
    void random(const FieldMeta& meta, Textured<T>& out) {
        if (chance(0.2)) out.texture = someId(scene_.textures);
        if (!out.texture) random(meta, out.value);
    }
    template <class T>
    requires requires { T::fields(); }
    void random(const FieldMeta&, T& out) { fill(out); }

    /// Each field is left at its default now and then.
    template <class T>
    void fill(T& value) {
        forEachField(value, [&](std::string_view, const FieldMeta& meta, auto& member) {
            if (meta.required || chance(0.7)) random(meta, member);
        });
    }

    template <class List>
    void randomKind(typename List::Variant& out) {
        int left = count(static_cast<int>(List::kinds.size()) - 1);
        List::forEach([&](auto value) {
            if (left-- != 0) return;
            fill(value);
            out = value;
        });
    }

    template <class T>
    T named() {
        T value;
        fill(value);
        return value;
    }

    /// One of the table's ids, or none.
    template <class T, class IdType>
    IdType someId(const Table<T, IdType>& table) {
        std::vector<IdType> ids = table.ids();
        ids.push_back({});
        return ids[static_cast<std::size_t>(count(static_cast<int>(ids.size()) - 1))];
    }

    void makeEnvironment() {
        Environment& environment = scene_.environment;
        fill(environment);
        environment.intensity = std::min(environment.intensity, 100.0);
        if (environment.sky) environment.image.clear();
    }

    Material makeMaterial() {
        Material out{freshName(), {}};
        randomKind<AllMaterials>(out.value);
        if (auto* translucent = std::get_if<Translucent>(&out.value))
            for (auto* share : {&translucent->reflectance, &translucent->transmittance})
                if (!share->texture)
                    share->value = {share->value.r / 2, share->value.g / 2, share->value.b / 2};
        return out;
    }

    Object makeObject() {
        Object out = named<Object>();
        if (std::holds_alternative<Plane>(out.shape)) out.emission = {};
        const bool sheet =
            std::holds_alternative<Quad>(out.shape) || std::holds_alternative<Disk>(out.shape);
        if (sheet && out.material &&
            materialGraph(scene_).content.at(out.material.value).solidGlass)
            out.material = {};
        return out;
    }

    Light makeLight() {
        Light out{freshName(), {}, chance(0.5), text()};
        randomKind<AllLights>(out.value);
        return out;
    }

    Camera makeCamera() {
        Camera out = named<Camera>();
        out.target = out.position * 1.0 + DVec3(uniform(1, 2), uniform(1, 2), uniform(1, 2)) *
                                              (1 + glm::length(out.position));
        out.up = {uniform(-2, -1), uniform(1, 2), 0};
        out.verticalFovDegrees = uniform(1, 179);
        return out;
    }

    void makeCameras() {
        for (int i = count(3); i > 0; --i) {
            Camera camera = makeCamera();
            camera.name = freshName();
            scene_.cameras.add(camera);
        }
        for (int i = count(9); i > 0; --i) scene_.views.push_back(makeCamera());
        scene_.activeCamera = someId(scene_.cameras);
        if (!scene_.activeCamera) scene_.camera = makeCamera();
    }

    std::mt19937_64 random_;
    Scene scene_;
    int names_ = 0;
};

}  // namespace

Scene randomScene(std::uint64_t seed) { return Maker(seed).make(); }

}  // namespace glint::test
