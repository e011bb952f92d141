#include "gui/viewport/material_drop.h"

#include <QDropEvent>

#include "gui/app/material_edits.h"
#include "gui/viewport/render_view.h"
#include "gui/viewport/view_context.h"

namespace glint {

MaterialDrop::MaterialDrop(RenderView& view) : QObject(&view), view_(view) {
    view.setAcceptDrops(true);
    view.installEventFilter(this);
}

std::optional<ObjectId> MaterialDrop::objectAt(const QPointF& at) const {
    const auto item = view_.context().itemAt(at);
    return item && item->kind == ItemKind::Object ? std::optional(ObjectId{item->id})
                                                  : std::nullopt;
}

void MaterialDrop::hover(const QPointF& at, MaterialId material) {
    const auto object = objectAt(at);
    if (object == shown_) return;
    Document& document = view_.context().document;
    document.cancelPreview();
    shown_ = object;
    if (object) document.preview(withAssigned(document.committed(), {*object}, material));
}

void MaterialDrop::drop(const QPointF& at, MaterialId material) {
    const auto object = objectAt(at);
    leave();
    if (!object) return;
    Document& document = view_.context().document;
    document.edit(withAssigned(document.committed(), {*object}, material), tr("Assign material"));
}

void MaterialDrop::leave() {
    if (shown_) view_.context().document.cancelPreview();
    shown_.reset();
}

bool MaterialDrop::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::DragLeave) leave();
    const bool drag = event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove;
    if (!drag && event->type() != QEvent::Drop) return QObject::eventFilter(watched, event);
    auto* moved = static_cast<QDropEvent*>(event);
    const auto material = draggedMaterial(moved->mimeData(), view_.context().document.committed());
    if (!material) return QObject::eventFilter(watched, event);
    if (drag)
        hover(moved->position(), *material);
    else
        drop(moved->position(), *material);
    moved->setDropAction(Qt::CopyAction);
    moved->accept();
    return true;
}

}  // namespace glint
