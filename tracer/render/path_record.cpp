#include "tracer/render/path_record.h"

#include <cstdio>

#include "tracer/render/layers.h"

namespace glint {

int PathRecord::leave(int parent, PathEvent event, const Rgb& weight, double chance) {
    PathVertex vertex;
    vertex.parent = parent;
    vertex.event = event;
    vertex.weight = weight;
    vertex.chance = chance;
    vertices.push_back(vertex);
    return static_cast<int>(vertices.size()) - 1;
}

void PathRecord::travel(int vertex, double length, const Medium& medium) {
    PathVertex& v = vertices[static_cast<std::size_t>(vertex)];
    v.length += length;
    if (isBlack(medium.absorption)) return;
    v.absorbedLength += length;
    WorkCounts uncounted;
    v.transmitted *= transmittance<kAllFeatures>(medium, length, uncounted);
}

void PathRecord::arrive(int vertex, const RenderScene& scene, const SurfacePoint& point,
                        const Rgb& throughput) {
    PathVertex& v = vertices[static_cast<std::size_t>(vertex)];
    v.hit = true;
    v.object = point.instance(scene).object;
    v.position = point.position + scene.origin;
    v.outside = point.outside;
    v.eta = point.eta;
    v.throughput = throughput;
}

void PathRecord::add(int vertex, const RenderScene& scene, PathLight::Kind kind,
                     std::uint32_t light, const Rgb& visible, const Rgb& adds) {
    PathLight out{
        .kind = kind, .source = LightKind::Environment, .visible = visible, .value = adds};
    if (light < scene.lights.lights.size()) {
        const CompiledLight& source = scene.lights.lights[light];
        out.source = source.kind;
        if (source.shape != kNoShape) out.object = scene.shapes[source.shape].object;
        out.light = source.id;
    }
    vertices[static_cast<std::size_t>(vertex)].lights.push_back(out);
}

PathRecord recordSample(const RenderScene& scene, const SamplePlace& place) {
    PathRecord record;
    LayerSample layers;
    KernelState state{.scene = scene, .cancel = {}, .rays = {}};
    state.layers = &layers;
    state.record = &record;
    record.value = chooseKernel(scene, static_cast<Features>(Feature::Layers))
                       .run(state, place.x, place.y, static_cast<std::uint32_t>(place.sample));
    // A clamped sample is smaller than what its paths found.
    if (scene.settings.clamp <= 0) return record;
    Rgb sum(0.0f);
    for (const PathVertex& vertex : record.vertices)
        for (const PathLight& light : vertex.lights) sum += light.value;
    const float scale =
        maxComponent(sum) > 0 ? maxComponent(record.value) / maxComponent(sum) : 1.0f;
    for (PathVertex& vertex : record.vertices)
        for (PathLight& light : vertex.lights) light.value *= scale;
    return record;
}

namespace {

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

std::string triple(const Rgb& c) {
    if (c.x == c.y && c.y == c.z) return number(static_cast<double>(c.x));
    return number(static_cast<double>(c.x)) + " " + number(static_cast<double>(c.y)) + " " +
           number(static_cast<double>(c.z));
}

std::string nameOf(const Scene& document, ObjectId id) {
    const Object* object = document.objects.find(id);
    if (!object) return "object " + std::to_string(id.value);
    std::string out = object->name.empty() ? "object " + std::to_string(id.value) : object->name;
    if (const auto* material = document.materials.find(object->material))
        out += " (" + material->name + ")";
    return out;
}

std::string eventName(PathEvent event) {
    switch (event) {
        case PathEvent::Camera:
            return "camera";
        case PathEvent::Smooth:
            return "scattered";
        case PathEvent::Reflection:
            return "reflected";
        case PathEvent::Refraction:
            return "refracted";
        case PathEvent::Straight:
            return "straight through";
    }
    return {};
}

std::string sourceName(const PathLight& light, const Scene& document) {
    if (light.object != ObjectId{}) return nameOf(document, light.object);
    if (const Light* entry = document.lights.find(light.light); entry && !entry->name.empty())
        return entry->name;
    switch (light.source) {
        case LightKind::Point:
            return "point light";
        case LightKind::Spot:
            return "spot light";
        case LightKind::Sun:
            return "sun";
        case LightKind::Area:
            return "area light";
        case LightKind::Environment:
            break;
    }
    return "environment";
}

/// What became of the path between the vertex before and this one.
std::string wayText(const PathVertex& v) {
    std::string out;
    const auto say = [&out](const std::string& text) { out += (out.empty() ? "" : ", ") + text; };
    if (v.event == PathEvent::Reflection || v.event == PathEvent::Refraction ||
        v.event == PathEvent::Straight)
        say("Fresnel weight " + triple(v.weight));
    if (v.event == PathEvent::Smooth) say("weight " + triple(v.weight));
    if (v.chance < 1) say("chance " + number(v.chance));
    if (v.hit || v.length > 0) say(v.length < kInfinity ? number(v.length) + " m" : "to infinity");
    if (v.absorbedLength > 0)
        say("absorbed over " + number(v.absorbedLength) + " m to " + triple(v.transmitted));
    if (v.hit && v.eta != 1) say("index " + number(static_cast<double>(v.eta)));
    return out;
}

std::string lightText(const PathLight& light, const Scene& document) {
    switch (light.kind) {
        case PathLight::Kind::Emission:
            return "shines itself";
        case PathLight::Kind::Environment:
            return light.source == LightKind::Sun ? "sun" : "environment";
        case PathLight::Kind::Direct:
            break;
    }
    return "direct light: " + sourceName(light, document);
}

/// Rows of a vertex, its lights and all below; returns what they add.
Rgb appendRows(const PathRecord& record, const Scene& document, int index, int depth,
               std::vector<PathRow>& rows) {
    const PathVertex& v = record.vertices[static_cast<std::size_t>(index)];
    const std::size_t own = rows.size();
    const std::string end = v.hit              ? nameOf(document, v.object)
                            : v.lights.empty() ? "nothing"
                                               : "sky";
    rows.push_back({index, depth, eventName(v.event) + " -> " + end, wayText(v), Rgb(0.0f),
                    Rgb(0.0f), v.object});
    Rgb total(0.0f);
    for (const PathLight& light : v.lights) {
        const std::string how = light.kind == PathLight::Kind::Direct && light.visible != Rgb(1.0f)
                                    ? "visible " + triple(light.visible)
                                    : "";
        rows.push_back({index, depth + 1, lightText(light, document), how, light.value, light.value,
                        light.object});
        total += light.value;
    }
    rows[own].contribution = total;
    for (std::size_t child = static_cast<std::size_t>(index) + 1; child < record.vertices.size();
         ++child)
        if (record.vertices[child].parent == index)
            total += appendRows(record, document, static_cast<int>(child), depth + 1, rows);
    rows[own].total = total;
    return total;
}

}  // namespace

std::vector<PathRow> pathRows(const PathRecord& record, const Scene& document) {
    std::vector<PathRow> rows;
    if (!record.vertices.empty()) appendRows(record, document, 0, 0, rows);
    return rows;
}

std::string pathText(const PathRecord& record, const Scene& document) {
    std::string out;
    for (const PathRow& row : pathRows(record, document)) {
        const std::string what =
            std::string(static_cast<std::size_t>(2 * row.depth), ' ') + row.what;
        char line[64];
        std::snprintf(line, sizeof line, "%-52.52s ", what.c_str());
        out += line + triple(row.total) + (row.how.empty() ? "" : "   [" + row.how + "]") + "\n";
    }
    return out;
}

}  // namespace glint
