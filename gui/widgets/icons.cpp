#include "gui/widgets/icons.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

// Resources of a static library must be asked for, outside any namespace.
static void initIconResources() { Q_INIT_RESOURCE(icons); }

namespace glint {

namespace {

/// The drawing with its one colour put in.
QByteArray colored(const QString& name, const QString& color) {
    QFile file(":/icons/" + name + ".svg");
    if (!file.open(QIODevice::ReadOnly)) return {};
    return file.readAll().replace("currentColor", color.toLatin1());
}

/// Draws an SVG whose "currentColor" is the palette's. Qt's own SVG icons stay black (see the
/// palette's theme).
class PaletteIconEngine : public QIconEngine {
  public:
    explicit PaletteIconEngine(QString name) : name_(std::move(name)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode,
               QIcon::State state) override {
        QSvgRenderer renderer(colored(name_, color(mode, state)));
        renderer.render(painter, rect);
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        const QString key = QStringLiteral("glint-icon/%1/%2x%3/%4")
                                .arg(name_)
                                .arg(size.width())
                                .arg(size.height())
                                .arg(color(mode, state));
        QPixmap pixmap;
        if (QPixmapCache::find(key, &pixmap)) return pixmap;
        pixmap = QPixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        QPixmapCache::insert(key, pixmap);
        return pixmap;
    }
    [[nodiscard]] QIconEngine* clone() const override { return new PaletteIconEngine(*this); }

  private:
    static QString color(QIcon::Mode mode, QIcon::State) {
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        const auto role =
            mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::ButtonText;
        return QApplication::palette().color(group, role).name();
    }

    QString name_;
};

}  // namespace

QIcon icon(const QString& name) {
    static const bool ready = (initIconResources(), true);
    return ready ? QIcon(new PaletteIconEngine(name)) : QIcon();
}

void drawIcon(QPainter& painter, const QString& name, const QRectF& rect, const QColor& color) {
    initIconResources();
    QSvgRenderer renderer(colored(name, color.name()));
    renderer.render(&painter, rect);
}

}  // namespace glint
