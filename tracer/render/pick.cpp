#include "tracer/render/pick.h"

#include "tracer/render/surface.h"

namespace glint {

std::optional<Pick> pick(const RenderScene& scene, int width, int height, double x, double y) {
    const double fx = x / width * scene.film.width, fy = y / height * scene.film.height;
    const Ray ray = scene.camera.ray(fx, fy, DVec2(0.5));
    const ShapeHit hit = scene.lists->closest(ray, scene.cameraMedia);
    if (!hit.found()) return std::nullopt;
    const SurfacePoint point = surfacePoint(scene, ray, hit, scene.cameraMedia);
    return Pick{point.instance(scene).object, point.position + scene.origin, point.frame.n, hit.t};
}

}  // namespace glint
