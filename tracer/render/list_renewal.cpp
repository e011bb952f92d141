#include "tracer/render/list_renewal.h"

#include <chrono>

namespace glint {

void ListRenewal::begin(const RenderScene& scene) {
    if (!scene.lists->hasMoved() || isBusy()) return;
    old_ = scene.lists;
    built_ = std::async(std::launch::async, [shapes = scene.shapes] {
        return std::make_shared<const ShapeLists>(shapes);
    });
}

std::shared_ptr<const RenderScene> ListRenewal::finish(const RenderScene& scene) {
    if (!isBusy() || built_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return nullptr;
    Lists lists = built_.get();
    const bool isOfScene = scene.lists == old_;
    old_.reset();
    if (!isOfScene) return nullptr;
    auto out = std::make_shared<RenderScene>(scene);
    out->lists = std::move(lists);
    return out;
}

}  // namespace glint
