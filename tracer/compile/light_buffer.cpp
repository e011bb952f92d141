#include "tracer/compile/light_buffer.h"

#include "tracer/math/frame.h"

namespace glint {

namespace {

std::optional<LightPlace> placeOf(const CompiledLight& light,
                                  const std::vector<ShapeInstance>& shapes) {
    switch (light.kind) {
        case LightKind::Point:
        case LightKind::Spot:
            return LightPlace{false, light.position, 0};
        case LightKind::Area: {
            const ShapeInstance& shape = shapes[light.shape];
            const double ball = ballRadius(shape);
            return LightPlace{false, shape.center,
                              (1 + 1e-6) * (ball > 0 ? ball : glm::length(shape.halfSize()))};
        }
        case LightKind::Sun:
            return LightPlace{true, light.direction,
                              (1 + 1e-6) * std::sqrt(light.sin2Angle / (1 - light.sin2Angle))};
        case LightKind::Environment:
            break;
    }
    return std::nullopt;
}

}  // namespace

LightBuffer::LightBuffer(const LightPlace& place, const ShapeLists& lists, double reach)
    : place_(place), reach_(reach) {
    if (!place.infinitelyFar) {
        cells_.reserve(6 * kSide * kSide);
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {1.0, -1.0}) addFace(axis, sign, lists);
        return;
    }
    const Frame frame(place.at);
    across_ = frame.s, up_ = frame.t;
    const double spread = (1 + kDepth) * reach * place.radius;
    const auto ray = [&](double x, double y) {
        const auto on = [&](double i) { return reach * (2 * i / kFarSide - 1); };
        return Ray{on(x) * across_ + on(y) * up_, place.at};
    };
    cells_.reserve(kFarSide * kFarSide);
    for (int y = 0; y < kFarSide; ++y)
        for (int x = 0; x < kFarSide; ++x)
            addCell(RayBundle({ray(x, y), ray(x + 1, y), ray(x + 1, y + 1), ray(x, y + 1)},
                              ray(x + 0.5, y + 0.5), spread),
                    lists);
}

void LightBuffer::addFace(int axis, double sign, const ShapeLists& lists) {
    const auto ray = [&](double x, double y) {
        Ray out{place_.at, DVec3(0.0)};
        out.direction[axis] = sign;
        out.direction[(axis + 1) % 3] = 2 * x / kSide - 1;
        out.direction[(axis + 2) % 3] = 2 * y / kSide - 1;
        return out;
    };
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            addCell(RayBundle({ray(x, y), ray(x + 1, y), ray(x + 1, y + 1), ray(x, y + 1)},
                              ray(x + 0.5, y + 0.5), place_.radius),
                    lists);
}

void LightBuffer::addCell(const RayBundle& bundle, const ShapeLists& lists) {
    FewShapes few;
    if (!lists.cull(bundle, few)) return cells_.push_back(kAny);
    if (few.isEmpty()) return cells_.push_back(0);
    cells_.push_back(static_cast<std::uint16_t>(few_.size()));
    few_.push_back(std::move(few));
}

LightBuffers::LightBuffers(const LightTable& lights, const std::vector<ShapeInstance>& shapes,
                           const ShapeLists& lists) {
    if (lights.lights.size() > kMostLights || lists.hasHierarchy() ||
        lists.blockCounts().total() < 2)
        return;
    double reach = 0;
    for (const ShapeInstance& shape : shapes)
        if (!std::holds_alternative<CanonicalPlane>(shape.shape))
            reach = std::max(reach, glm::length(absolute(shape.center) + shape.halfSize()));
    std::vector<std::optional<LightBuffer>> buffers;
    for (const CompiledLight& light : lights.lights) {
        const std::optional<LightPlace> place = placeOf(light, shapes);
        buffers.emplace_back();
        if (place && place->radius <= kMostRadius * (place->infinitelyFar ? 1 : reach))
            buffers.back().emplace(*place, lists, reach);
    }
    of_ = std::move(buffers);
}

}  // namespace glint
