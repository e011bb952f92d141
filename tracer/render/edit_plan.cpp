#include "tracer/render/edit_plan.h"

#include <algorithm>

namespace glint {

namespace {

/// The materials that were changed and all mixes that rest on them.
std::uint64_t changedMaterials(const Scene& before, const Scene& after) {
    std::uint64_t bits = 0;
    std::vector<MaterialId> changed;
    using Materials = Table<Material, MaterialId>;
    Materials::forEachDifference(before.materials, after.materials,
                                 [&](MaterialId id, const Material* a, const Material* b) {
                                     if (a && b && a->value == b->value) return;
                                     // One that came or went may have been named by mixes or
                                     // objects, which then differ themselves, or by nothing.
                                     changed.push_back(id);
                                     bits |= materialBit(id);
                                 });
    const auto restsOn = [&](const Material& material) {
        const auto* mix = std::get_if<Mix>(&material.value);
        if (!mix) return false;
        const auto has = [&](const MixPart& part) {
            return std::find(changed.begin(), changed.end(), part.material) != changed.end();
        };
        return has(mix->a) || has(mix->b);
    };
    for (std::size_t found = 0; found != changed.size();) {
        found = changed.size();
        for (const Scene* scene : {&before, &after})
            scene->materials.forEach([&](MaterialId id, const Material& material) {
                if (!restsOn(material) ||
                    std::find(changed.begin(), changed.end(), id) != changed.end())
                    return;
                changed.push_back(id);
                bits |= materialBit(id);
            });
    }
    return bits;
}

/// What counts of an object for its pixels beside light and material. One that goes into a group
/// without moving stays what it is.
bool sameForm(const Scene& before, const Object& a, const Scene& after, const Object& b) {
    const bool samePlace = (a.transform == b.transform && a.parent == b.parent) ||
                           worldFromObject(before, a) == worldFromObject(after, b);
    return a.shape == b.shape && a.twoSided == b.twoSided && samePlace;
}

bool sameObjects(const Scene& before, const Scene& after, std::uint64_t& materials) {
    bool same = true;
    using Objects = Table<Object, ObjectId>;
    Objects::forEachDifference(
        before.objects, after.objects, [&](ObjectId, const Object* a, const Object* b) {
            const bool shownBefore = a && isVisible(before, *a),
                       shownAfter = b && isVisible(after, *b);
            if (!shownBefore && !shownAfter) return;
            same = same && shownBefore && shownAfter && sameForm(before, *a, after, *b);
            if (same && a->material != b->material) materials |= materialBit(a->material);
        });
    return same;
}

bool sameGroups(const Scene& before, const Scene& after) {
    bool same = true;
    using Groups = Table<Group, GroupId>;
    Groups::forEachDifference(
        before.groups, after.groups, [&](GroupId, const Group* a, const Group* b) {
            // What was in one that came or went differs itself.
            if (a && b)
                same = same && a->parent == b->parent && a->transform == b->transform &&
                       a->visible == b->visible;
        });
    return same;
}

/// But for colour and visibility, which are the mix's.
bool sameLights(const Scene& before, const Scene& after) {
    bool same = true;
    using Lights = Table<Light, LightId>;
    Lights::forEachDifference(before.lights, after.lights,
                              [&](LightId, const Light* a, const Light* b) {
                                  if (!a || !b) {
                                      const Light& only = a ? *a : *b;
                                      same = same && !only.visible;
                                      return;
                                  }
                                  if (!a->visible && !b->visible) return;
                                  Light colored = *b;
                                  lightColor(colored) = lightColor(*a);
                                  same = same && a->value == colored.value;
                              });
    return same;
}

bool sameEnvironment(const Environment& a, const Environment& b) {
    return a.image == b.image && a.sky == b.sky && a.rotationDegrees == b.rotationDegrees &&
           a.visibleToCamera == b.visibleToCamera;
}

bool sameCamera(Camera a, const Camera& b) {
    a.name = b.name;
    return a == b;
}

/// But for the rules that end a render.
bool sameRender(RenderSettings a, const RenderSettings& b) {
    a.spp = b.spp;
    a.timeSeconds = b.timeSeconds;
    a.errorPercent = b.errorPercent;
    return a == b;
}

}  // namespace

EditPlan planEdit(const Scene& traced, const Scene& next, const LightGroups& groups) {
    EditPlan plan;
    if (!(traced.film == next.film) || !sameCamera(traced.viewCamera(), next.viewCamera()) ||
        !sameRender(traced.render, next.render) ||
        !sameEnvironment(traced.environment, next.environment) ||
        !(traced.textures == next.textures) || !sameGroups(traced, next) ||
        !sameLights(traced, next))
        return plan;
    plan.materials = changedMaterials(traced, next);
    if (!sameObjects(traced, next, plan.materials)) return plan;
    const auto mix = lightMixBetween(traced, next, groups);
    // Clamped samples are not the sum of their groups.
    if (!mix || (!mix->isUnit() && traced.render.clamp > 0)) return plan;
    plan.mix = *mix;
    plan.kind = plan.materials ? EditPlan::Kind::Retrace : EditPlan::Kind::Keep;
    return plan;
}

Scene withLightsOf(const Scene& traced, Scene next) {
    traced.objects.forEach([&](ObjectId id, const Object& object) {
        const Object* now = next.objects.find(id);
        if (!now || now->emission == object.emission) return;
        Object lit = *now;
        lit.emission = object.emission;
        next.objects.set(id, std::move(lit));
    });
    traced.lights.forEach([&](LightId id, const Light& light) {
        if (const Light* now = next.lights.find(id); now && !(*now == light))
            next.lights.set(id, light);
    });
    next.environment = traced.environment;
    return next;
}

bool sameStructure(const RenderScene& before, const RenderScene& after) {
    if (before.shapes.size() != after.shapes.size() || before.clearShadows != after.clearShadows)
        return false;
    for (std::size_t i = 0; i < before.shapes.size(); ++i) {
        const ShapeInstance &a = before.shapes[i], &b = after.shapes[i];
        if (a.object != b.object || a.dielectric != b.dielectric ||
            isBlack(before.materials[a.material].straight) !=
                isBlack(after.materials[b.material].straight))
            return false;
    }
    return before.casters.casters == after.casters.casters &&
           before.highlights.surfaces == after.highlights.surfaces;
}

bool sameViewpoint(const Camera& a, const Camera& b) {
    Camera other = b;
    other.name = a.name;
    other.verticalFovDegrees = a.verticalFovDegrees;
    other.orthoHeight = a.orthoHeight;
    return a == other;
}

}  // namespace glint
