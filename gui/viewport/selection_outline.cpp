#include "gui/viewport/selection_outline.h"

#include <QtConcurrent>
#include <algorithm>
#include <cmath>

#include "gui/viewport/bounds.h"
#include "gui/viewport/overlay.h"
#include "gui/viewport/view_context.h"

namespace glint {

namespace {

/// Pixels of the frame on which points of the selected objects fall.
std::vector<QPoint> seedsOf(const Scene& scene, const SilhouetteRequest& request) {
    constexpr std::size_t kMost = 500;  // Of more objects every one has neighbours that are found.
    const ViewProjection view(
        fittedCamera(scene.viewCamera(), scene.film, request.width, request.height), request.width,
        request.height);
    std::vector<QPoint> out;
    for (std::size_t i = 0; i < std::min(kMost, request.selected.size()); ++i) {
        const Object* object = scene.objects.find(request.selected[i]);
        if (!object) continue;
        const Affine world = worldFromObject(scene, *object);
        for (const DVec3& point : hullPoints(object->shape))
            if (const auto at = view.project(world.point(point))) out.push_back(at->toPoint());
        if (const auto at = view.project(world.translation)) out.push_back(at->toPoint());
    }
    const QRect all(0, 0, request.width, request.height);
    std::erase_if(out, [&](const QPoint& p) { return !all.contains(p); });
    return out;
}

SilhouetteRequest requestFor(const ViewContext& context) {
    const SessionFrame* frame = context.renderer.frame();
    SilhouetteRequest out;
    if (!frame || !frame->scene) return out;
    const auto& items = context.selection.items();
    out.selected = objectsWithin(context.document.scene(), items);
    if (out.selected.empty()) return out;
    if (items.back().kind == ItemKind::Object) out.active = ObjectId{items.back().id};
    out.scene = frame->scene;
    out.width = frame->width;
    out.height = frame->height;
    return out;
}

bool sameSelection(const SilhouetteRequest& a, const SilhouetteRequest& b) {
    return a.selected == b.selected && a.active == b.active;
}
bool samePicture(const SilhouetteRequest& a, const SilhouetteRequest& b) {
    return sameSelection(a, b) && a.scene == b.scene && a.width == b.width && a.height == b.height;
}

}  // namespace

SelectionOutline::SelectionOutline(QObject* parent) : QObject(parent) {
    connect(&watcher_, &QFutureWatcher<QImage>::finished, this, &SelectionOutline::take);
}

SelectionOutline::~SelectionOutline() { watcher_.waitForFinished(); }

const QImage& SelectionOutline::image(const ViewContext& context) {
    SilhouetteRequest request = requestFor(context);
    if (!sameSelection(request, shown_)) image_ = {};
    if (request.selected.empty()) {
        shown_ = wanted_ = {};
        return image_;
    }
    if (samePicture(request, wanted_)) return image_;
    // Two device pixels on a usual screen, and as thick to the eye on a finer one.
    thickness_ =
        std::max(1, static_cast<int>(std::lround(1.5 * context.widget.devicePixelRatioF())));
    wanted_ = std::move(request);
    document_ = context.document.scene();
    if (!watcher_.isRunning()) start();
    return image_;
}

void SelectionOutline::start() {
    running_ = wanted_;
    const OverlayColors colors;
    watcher_.setFuture(QtConcurrent::run(
        [request = running_, scene = document_, thickness = thickness_, colors]() mutable {
            request.seeds = seedsOf(scene, request);
            return outlineImage(silhouette(request), request.width, request.height, thickness,
                                colors.selected, colors.active);
        }));
}

void SelectionOutline::take() {
    if (sameSelection(running_, wanted_)) {
        image_ = watcher_.result();
        shown_ = running_;
        emit ready();
    }
    if (!wanted_.selected.empty() && !samePicture(wanted_, running_)) start();
}

}  // namespace glint
