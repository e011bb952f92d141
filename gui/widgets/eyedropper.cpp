#include "gui/widgets/eyedropper.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWidget>

namespace glint {

Eyedropper::Eyedropper(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
    QApplication::setOverrideCursor(Qt::CrossCursor);
}

Eyedropper::~Eyedropper() { QApplication::restoreOverrideCursor(); }

void Eyedropper::end() {
    qApp->removeEventFilter(this);
    deleteLater();
}

bool Eyedropper::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride) {
        if (static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape) return false;
        // Accepted, it comes back as a key: Esc is a shortcut of the window's as well.
        event->accept();
        if (event->type() == QEvent::KeyPress) end();
        return true;
    }
    if (event->type() != QEvent::MouseButtonPress || !watched->isWidgetType()) return false;
    const auto* press = static_cast<QMouseEvent*>(event);
    const auto* picture = dynamic_cast<const PictureSource*>(watched);
    const auto color = picture && press->button() == Qt::LeftButton ? picture->colorAt(press->globalPosition().toPoint()) : std::nullopt;
    end();
    if (color) emit picked(*color);
    return true;
}

}  // namespace glint
