#include "gui/app/edit_controller.h"

#include <algorithm>

#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>
#include <cmath>

#include "gui/app/document.h"
#include "gui/app/selection.h"
#include "gui/app/text.h"
#include "gui/viewport/bounds.h"
#include "gui/viewport/render_view.h"
#include "gui/widgets/icons.h"
#include "tracer/io/scene_json.h"
#include "tracer/scene/edit.h"

namespace glint {

namespace {

/// The material for a new object: that of the active object, else the first, else a new one.
MaterialId materialForNew(Scene& scene, const Selection& selection) {
    for (auto item = selection.items().rbegin(); item != selection.items().rend(); ++item)
        if (item->kind == ItemKind::Object)
            if (const MaterialId used = scene.objects.at(ObjectId{item->id}).material) return used;
    if (!scene.materials.empty()) return scene.materials.ids().front();
    auto [next, id] = withMaterial(std::move(scene), Material{"White", Diffuse{}});
    scene = std::move(next);
    return id;
}

/// The shape's reach below its origin, metres: so high it rests on the ground.
double reachBelow(const Shape& shape) {
    Bounds bounds;
    for (const DVec3& point : hullPoints(shape)) bounds.add(point);
    return bounds.isEmpty() ? 0 : -bounds.lower.y;
}

Object objectAt(const ViewContext::Placement& place, const Shape& shape, std::string name) {
    Object object;
    object.name = std::move(name);
    object.shape = shape;
    object.transform.translate = place.position + place.normal * reachBelow(shape);
    // Numbers that a person can read: a pixel is hardly ever finer than a millimetre.
    for (int i = 0; i < 3; ++i)
        object.transform.translate[i] = std::round(object.transform.translate[i] * 1000) / 1000;
    return object;
}

}  // namespace

EditController::EditController(Document& document, Selection& selection, RenderView& view,
                               QObject* parent)
    : QObject(parent), document_(document), selection_(selection), view_(view) {}

void EditController::remove() {
    if (selection_.isEmpty()) return;
    document_.edit(removed(document_.committed(), selection_.items()), tr("Delete"));
}

void EditController::duplicate() {
    if (selection_.isEmpty()) return;
    auto [scene, copies] = duplicated(document_.committed(), selection_.items());
    if (copies.empty()) return;
    const bool overPicture = view_.underMouse() && view_.isActiveWindow();
    if (!overPicture) {
        document_.edit(std::move(scene), tr("Duplicate"));
        selection_.set(copies);
        return;
    }
    document_.preview(scene);
    selection_.set(copies);
    view_.beginFollow(std::move(scene), tr("Duplicate"));
}

void EditController::copy() {
    const auto objects = objectsWithin(document_.scene(), selection_.items());
    std::vector<LightId> lights;
    std::vector<CameraId> cameras;
    for (const Item item : selection_.items()) {
        if (item.kind == ItemKind::Light) lights.push_back(LightId{item.id});
        if (item.kind == ItemKind::Camera && item.id != 0) cameras.push_back(CameraId{item.id});
    }
    if (objects.empty() && lights.empty() && cameras.empty()) return;
    QGuiApplication::clipboard()->setText(
        toQString(formatObjects(document_.scene(), objects, lights, cameras)));
}

void EditController::cut() {
    copy();
    remove();
}

void EditController::paste() {
    auto pasted =
        pasteObjects(document_.committed(), QGuiApplication::clipboard()->text().toStdString());
    if (!pasted.ok()) {
        emit refused(tr("The clipboard holds no objects: %1").arg(toQString(pasted.error())));
        return;
    }
    PastedObjects result = std::move(pasted).value();
    std::vector<Item> items;
    const auto note = [&](const auto& ids) {
        for (const auto id : ids) items.push_back(Item::of(id));
    };
    note(result.added);
    note(result.lights);
    note(result.cameras);
    document_.edit(std::move(result.scene), tr("Paste"));
    selection_.set(std::move(items));
}

void EditController::selectAll() {
    std::vector<Item> items;
    const Scene& scene = document_.scene();
    scene.objects.forEach([&](ObjectId id, const Object&) { items.push_back(Item::of(id)); });
    scene.lights.forEach([&](LightId id, const Light&) { items.push_back(Item::of(id)); });
    selection_.set(std::move(items));
}

void EditController::hideSelected() {
    Scene scene = document_.committed();
    for (const Item item : selection_.items()) scene = withVisible(std::move(scene), item, false);
    document_.edit(std::move(scene), tr("Hide"));
}

void EditController::hideRest() {
    Scene scene = document_.committed();
    const std::vector<ObjectId> kept = objectsWithin(scene, selection_.items());
    if (kept.empty()) return;
    for (const ObjectId id : document_.committed().objects.ids())
        if (std::find(kept.begin(), kept.end(), id) == kept.end() && scene.objects.at(id).visible)
            scene = withVisible(std::move(scene), Item::of(id), false);
    document_.edit(std::move(scene), tr("Hide the rest"));
}

void EditController::showAll() {
    Scene scene = document_.committed();
    const auto show = [&](auto ids) {
        for (const auto id : ids)
            if (!isVisible(scene, Item::of(id)))
                scene = withVisible(std::move(scene), Item::of(id), true);
    };
    show(scene.objects.ids());
    show(scene.groups.ids());
    show(scene.lights.ids());
    document_.edit(std::move(scene), tr("Show all"));
}

void EditController::group() {
    std::vector<Item> items = topmost(document_.committed(), selection_.items());
    std::erase_if(items, [](Item item) {
        return item.kind != ItemKind::Object && item.kind != ItemKind::Group;
    });
    if (items.empty()) return;
    Group group;
    group.name = tr("Group").toStdString();
    group.parent = parentOf(document_.committed(), items.front());
    auto [scene, id] = withGroup(document_.committed(), std::move(group));
    for (const Item item : items) scene = movedInto(std::move(scene), item, id);
    document_.edit(std::move(scene), tr("Group"));
    selection_.set({Item::of(id)});
}

void EditController::ungroup() {
    Scene scene = document_.committed();
    for (const Item item : selection_.items())
        if (item.kind == ItemKind::Group) scene = withoutGroup(std::move(scene), GroupId{item.id});
    document_.edit(std::move(scene), tr("Ungroup"));
}

void EditController::changeExposure(double stops) {
    Scene scene = document_.committed();
    scene.display.exposureEv += stops;
    document_.edit(std::move(scene), tr("Exposure"), QStringLiteral("exposure"));
}

void EditController::lookThroughSelectedCamera() {
    CameraId camera;
    for (const Item item : selection_.items())
        if (item.kind == ItemKind::Camera) camera = CameraId{item.id};
    lookThrough(camera);
}

void EditController::lookThrough(CameraId camera) {
    Scene scene = document_.committed();
    scene.activeCamera = camera;
    document_.edit(std::move(scene), tr("Look through camera"));
}

void EditController::fillAddMenu(QMenu* menu, const std::function<QPointF()>& placeAt) {
    for (const std::string_view kind : AllShapes::kinds) {
        if (kind == Mesh::kind) continue;  // Needs a file: it comes by drop or open.
        QAction* action = menu->addAction(icon("shape-" + toQString(kind)), labelOf(kind));
        action->setObjectName("add." + toQString(kind));
        connect(action, &QAction::triggered, this,
                [this, kind, placeAt] { addShape(kind, placeAt()); });
    }
    menu->addSeparator();
    connect(menu->addAction(icon("light-point"), tr("Ball light")), &QAction::triggered, this,
            [this, placeAt] { addBallLight(placeAt()); });
    for (const std::string_view kind : AllLights::kinds) {
        QAction* action =
            menu->addAction(icon("light-" + toQString(kind)), tr("%1 light").arg(labelOf(kind)));
        action->setObjectName("add.light." + toQString(kind));
        connect(action, &QAction::triggered, this,
                [this, kind, placeAt] { addLight(kind, placeAt()); });
    }
    menu->addSeparator();
    connect(menu->addAction(icon("camera"), tr("Camera from view")), &QAction::triggered, this,
            &EditController::addCamera);
    connect(menu->addAction(icon("group"), tr("Empty group")), &QAction::triggered, this,
            &EditController::addGroup);
}

void EditController::finishAdding(Scene scene, Item item, const QString& text) {
    document_.edit(std::move(scene), text);
    selection_.set({item});
}

void EditController::addShape(std::string_view kind, const QPointF& at) {
    Scene scene = document_.committed();
    const auto place = view_.context().placementAt(at);
    AllShapes::withKind(kind, [&](const auto& shape) {
        Object object = objectAt(place, shape, labelOf(kind).toStdString());
        object.material = materialForNew(scene, selection_);
        auto [next, id] = withObject(std::move(scene), std::move(object));
        finishAdding(std::move(next), Item::of(id), tr("Add %1").arg(labelOf(kind).toLower()));
    });
}

void EditController::addBallLight(const QPointF& at) {
    constexpr double kRadius = 0.3, kHeight = 2, kRadiance = 30;
    Object object =
        objectAt(view_.context().placementAt(at), Sphere{kRadius}, tr("Ball light").toStdString());
    object.transform.translate.y += kHeight;
    object.emission = {kRadiance, kRadiance, kRadiance};
    auto [scene, id] = withObject(document_.committed(), std::move(object));
    finishAdding(std::move(scene), Item::of(id), tr("Add ball light"));
}

void EditController::addLight(std::string_view kind, const QPointF& at) {
    constexpr double kHeight = 2;  // metres above the surface
    const DVec3 position = view_.context().placementAt(at).position + DVec3(0, kHeight, 0);
    AllLights::withKind(kind, [&](auto light) {
        if constexpr (requires { light.target; }) light.target = position - DVec3(0, kHeight, 0);
        if constexpr (requires { light.position; }) light.position = position;
        auto [scene, id] =
            withLight(document_.committed(), Light{labelOf(kind).toStdString(), light});
        finishAdding(std::move(scene), Item::of(id), tr("Add light"));
    });
}

void EditController::addGroup() {
    Group group;
    group.name = tr("Group").toStdString();
    auto [scene, id] = withGroup(document_.committed(), std::move(group));
    finishAdding(std::move(scene), Item::of(id), tr("Add group"));
}

void EditController::addCamera() {
    Camera camera = document_.scene().viewCamera();
    camera.name = tr("Camera").toStdString();
    auto [scene, id] = withCamera(document_.committed(), std::move(camera));
    finishAdding(std::move(scene), Item::of(id), tr("Add camera"));
}

}  // namespace glint
