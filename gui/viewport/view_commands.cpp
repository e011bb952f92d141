#include "gui/viewport/view_commands.h"

#include "gui/viewport/navigation.h"
#include "gui/viewport/render_view.h"

namespace glint {

ViewCommands::ViewCommands(RenderView& view, QObject* parent) : QObject(parent), view_(view) {}

void ViewCommands::go(const Camera& camera) {
    ViewContext& context = view_.context();
    const Camera& current = context.document.scene().viewCamera();
    if (camera == current) return;
    context.history.leave(current);
    context.document.navigate(camera);
}

void ViewCommands::frame(const Bounds& bounds) {
    const Scene& scene = view_.context().document.scene();
    go(framed(scene.viewCamera(), bounds,
              static_cast<double>(scene.film.width) / scene.film.height));
}

void ViewCommands::frameSelected() {
    ViewContext& context = view_.context();
    const Bounds bounds = boundsOf(context.document.scene(), context.selection.items());
    bounds.isEmpty() ? frameAll() : frame(bounds);
}

void ViewCommands::frameAll() { frame(boundsOf(view_.context().document.scene())); }

void ViewCommands::lookAlong(const DVec3& direction) {
    go(lookingAlong(view_.context().document.scene().viewCamera(), direction));
}

void ViewCommands::toggleProjection() {
    const Camera& camera = view_.context().document.scene().viewCamera();
    const bool perspective = camera.projection == Projection::Perspective;
    go(withProjection(camera, perspective ? Projection::Orthographic : Projection::Perspective));
}

void ViewCommands::back() {
    ViewContext& context = view_.context();
    if (const auto camera = context.history.back(context.document.scene().viewCamera()))
        context.document.navigate(*camera);
}

void ViewCommands::forward() {
    ViewContext& context = view_.context();
    if (const auto camera = context.history.forward(context.document.scene().viewCamera()))
        context.document.navigate(*camera);
}

void ViewCommands::goToSavedView(int number) {
    const auto& views = view_.context().document.scene().views;
    if (number >= 1 && static_cast<std::size_t>(number) <= views.size())
        go(views[static_cast<std::size_t>(number) - 1]);
}

void ViewCommands::storeView(int number) {
    Document& document = view_.context().document;
    Scene scene = document.committed();
    Camera camera = scene.viewCamera();
    camera.name.clear();
    // A file holds views without gaps: those before a new one start as the same view.
    const auto count = static_cast<std::size_t>(number);
    if (scene.views.size() < count) scene.views.resize(count, camera);
    scene.views[count - 1] = camera;
    document.edit(std::move(scene), tr("Store view %1").arg(number));
}

}  // namespace glint
