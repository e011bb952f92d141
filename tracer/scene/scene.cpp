#include "tracer/scene/scene.h"

namespace glint {

const Color& lightColor(const Light& light) {
    return std::visit(
        [](const auto& value) -> const Color& {
            if constexpr (requires { value.irradiance; })
                return value.irradiance;
            else
                return value.intensity;
        },
        light.value);
}

Color& lightColor(Light& light) { return const_cast<Color&>(lightColor(std::as_const(light))); }

Affine toAffine(const Transform& transform) {
    if (transform.matrix) {
        const auto& m = *transform.matrix;
        return {DMat3(DVec3(m[0], m[4], m[8]), DVec3(m[1], m[5], m[9]), DVec3(m[2], m[6], m[10])),
                DVec3(m[3], m[7], m[11])};
    }
    DMat3 linear = rotationFromDegrees(transform.rotateDegrees);
    for (int axis = 0; axis < 3; ++axis) linear[axis] *= transform.scale[axis];
    return {linear, transform.translate};
}

Transform toTransform(const Affine& affine) {
    Transform out;
    out.translate = affine.translation;
    const DMat3& m = affine.linear;
    out.scale = {glm::length(m[0]), glm::length(m[1]), glm::length(m[2])};
    if (glm::determinant(m) < 0) out.scale.x = -out.scale.x;
    const DMat3 r(m[0] / out.scale.x, m[1] / out.scale.y, m[2] / out.scale.z);
    // Angles of Rz * Ry * Rx.
    const double cosY = std::hypot(r[0].x, r[0].y);
    const double y = std::atan2(-r[0].z, cosY);
    const bool locked = cosY < 1e-12;
    const double x = locked ? std::atan2(-r[2].y, r[1].y) : std::atan2(r[1].z, r[2].z);
    const double z = locked ? 0 : std::atan2(r[0].y, r[0].x);
    out.rotateDegrees = {radiansToDegrees(x), radiansToDegrees(y), radiansToDegrees(z)};

    // A shear cannot be said that way: keep the matrix.
    const Affine back = toAffine(out);
    const double size = glm::length(m[0]) + glm::length(m[1]) + glm::length(m[2]);
    double error = 0;
    for (int c = 0; c < 3; ++c) error = std::max(error, glm::length(back.linear[c] - m[c]));
    if (error <= 1e-12 * size) return out;
    Transform sheared;
    const DVec3& t = affine.translation;
    sheared.matrix = {m[0].x, m[1].x, m[2].x, t.x,    m[0].y, m[1].y,
                      m[2].y, t.y,    m[0].z, m[1].z, m[2].z, t.z};
    return sheared;
}

Affine worldFromGroup(const Scene& scene, GroupId group) {
    Affine out;
    while (group) {
        const Group& g = scene.groups.at(group);
        out = toAffine(g.transform) * out;
        group = g.parent;
    }
    return out;
}

Affine worldFromObject(const Scene& scene, const Object& object) {
    return worldFromGroup(scene, object.parent) * toAffine(object.transform);
}

bool isVisible(const Scene& scene, const Object& object) {
    if (!object.visible) return false;
    for (GroupId group = object.parent; group; group = scene.groups.at(group).parent)
        if (!scene.groups.at(group).visible) return false;
    return true;
}

}  // namespace glint
