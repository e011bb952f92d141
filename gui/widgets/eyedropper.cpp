#include "gui/widgets/eyedropper.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPointer>
#include <QWidget>

namespace glint {

Eyedropper::Eyedropper(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
    QApplication::setOverrideCursor(Qt::CrossCursor);
}

Eyedropper::~Eyedropper() { end(); }

void Eyedropper::end() {
    if (ended_) return;
    ended_ = true;
    qApp->removeEventFilter(this);
    QApplication::restoreOverrideCursor();
}

bool Eyedropper::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride) {
        if (static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape) return false;
        // Accepted, it comes back as a key: Esc is a shortcut of the window's as well.
        event->accept();
        if (event->type() == QEvent::KeyPress) {
            end();
            deleteLater();
        }
        return true;
    }
    if (event->type() != QEvent::MouseButtonPress || !watched->isWidgetType()) return false;
    const auto* press = static_cast<QMouseEvent*>(event);
    auto* picture = dynamic_cast<PictureSource*>(watched);
    end();
    const auto tell = [self = QPointer(this)](const Color& color) {
        if (!self) return;
        emit self->picked(color);
        self->deleteLater();
    };
    if (!picture || press->button() != Qt::LeftButton ||
        !picture->tellColor(press->globalPosition().toPoint(), tell))
        deleteLater();
    return true;
}

}  // namespace glint
