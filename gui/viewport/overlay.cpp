#include "gui/viewport/overlay.h"

#include <QLineF>
#include <QPainter>
#include <QRegion>
#include <algorithm>
#include <cmath>

#include "gui/viewport/bounds.h"
#include "gui/widgets/icons.h"

namespace glint {

namespace {

const OverlayColors kColors;
constexpr double kGlyphSize = 22;

double cross(const QPointF& o, const QPointF& a, const QPointF& b) {
    return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

/// A line of the world, cut where it passes behind the viewer.
void drawLine(QPainter& painter, const ViewProjection& view, DVec3 a, DVec3 b) {
    constexpr double kNear = 1e-2;
    const double za = view.depth(a), zb = view.depth(b);
    if (za < kNear && zb < kNear) return;
    if (za < kNear) a = b + (a - b) * ((zb - kNear) / (zb - za));
    if (zb < kNear) b = a + (b - a) * ((za - kNear) / (za - zb));
    const auto p = view.project(a), q = view.project(b);
    if (p && q) painter.drawLine(*p, *q);
}

QPen haloPen(const QColor& color, double width) {
    QPen pen(color, width);
    pen.setJoinStyle(Qt::RoundJoin);
    return pen;
}

/// A stroke with a dark rim, readable on any picture.
template <class Draw>
void drawWithHalo(QPainter& painter, const QColor& color, double width, Draw&& draw) {
    painter.setPen(haloPen(QColor(0, 0, 0, 140), width + 2));
    draw();
    painter.setPen(haloPen(color, width));
    draw();
}

QString glyphName(const Scene& scene, Item item) {
    if (item.kind == ItemKind::Camera) return QStringLiteral("camera");
    const auto& light = scene.lights.at(LightId{item.id}).value;
    return "light-" +
           QString::fromUtf8(kindOf(light).data(), static_cast<qsizetype>(kindOf(light).size()));
}

QColor colorOf(const std::vector<Item>& selected, Item item) {
    if (selected.empty() || std::find(selected.begin(), selected.end(), item) == selected.end())
        return {220, 220, 220};
    return selected.back() == item ? kColors.active : kColors.selected;
}

}  // namespace

QPolygonF convexHull(std::vector<QPointF> points) {
    if (points.size() < 3) return {};
    std::sort(points.begin(), points.end(), [](const QPointF& a, const QPointF& b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    });
    QPolygonF hull;
    const auto add = [&](const QPointF& p, qsizetype keep) {
        while (hull.size() >= keep + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0)
            hull.removeLast();
        hull << p;
    };
    for (const QPointF& p : points) add(p, 0);
    const qsizetype lower = hull.size() - 1;
    for (auto p = points.rbegin() + 1; p != points.rend(); ++p) add(*p, lower);
    return hull;
}

QPolygonF outlineOf(const Scene& scene, const Object& object, const ViewProjection& view) {
    const Affine world = worldFromObject(scene, object);
    std::vector<DVec3> points = hullPoints(object.shape);
    if (points.empty()) points = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
    std::vector<QPointF> pixels;
    for (const DVec3& point : points)
        if (const auto pixel = view.project(world.point(point))) pixels.push_back(*pixel);
    return convexHull(std::move(pixels));
}

void paintGrid(QPainter& painter, const ViewProjection& view, const DVec3& around) {
    constexpr int kLines = 20;
    const double step =
        std::pow(10.0, std::round(std::log10(std::max(1e-6, view.metresPerPixel(around) * 60))));
    const DVec3 center(std::round(around.x / step) * step, 0, std::round(around.z / step) * step);
    const double reach = kLines * step;
    for (int i = -kLines; i <= kLines; ++i) {
        const double x = center.x + i * step, z = center.z + i * step;
        const auto pen = [&](double coordinate, const QColor& axis) {
            painter.setPen(std::abs(coordinate) < step / 2 ? QPen(axis, 1)
                                                           : QPen(QColor(255, 255, 255, 38), 1));
        };
        pen(x, kColors.axes[2]);
        drawLine(painter, view, {x, 0, center.z - reach}, {x, 0, center.z + reach});
        pen(z, kColors.axes[0]);
        drawLine(painter, view, {center.x - reach, 0, z}, {center.x + reach, 0, z});
    }
}

std::vector<Glyph> glyphsOf(const Scene& scene, const ViewProjection& view) {
    std::vector<Glyph> out;
    const auto add = [&](Item item) {
        if (const auto at = view.project(worldFromItem(scene, item).translation))
            out.push_back({item, *at});
    };
    scene.lights.forEach([&](LightId id, const Light& light) {
        const auto* sun = std::get_if<SunLight>(&light.value);
        if (!sun) return add(Item::of(id));
        // A sun is everywhere: its mark stands where it is seen in the sky.
        constexpr double kFar = 1e6;  // metres
        const double length = glm::length(sun->direction);
        if (length > 0)
            if (const auto at =
                    view.project(scene.viewCamera().position - sun->direction * (kFar / length)))
                out.push_back({Item::of(id), *at});
    });
    scene.cameras.forEach([&](CameraId id, const Camera&) {
        if (id != scene.activeCamera) add(Item::of(id));
    });
    return out;
}

std::optional<Item> glyphAt(const Scene& scene, const ViewProjection& view, const QPointF& at) {
    for (const Glyph& glyph : glyphsOf(scene, view))
        if (QLineF(glyph.at, at).length() < kGlyphSize / 2) return glyph.item;
    return std::nullopt;
}

void paintGlyphs(QPainter& painter, const Scene& scene, const std::vector<Item>& selected,
                 const ViewProjection& view) {
    for (const Glyph& glyph : glyphsOf(scene, view)) {
        const QColor color = colorOf(selected, glyph.item);
        painter.setPen(QPen(color, 1.5));
        painter.setBrush(QColor(0, 0, 0, 130));
        painter.drawEllipse(glyph.at, kGlyphSize / 2, kGlyphSize / 2);
        const QRectF square(glyph.at - QPointF(8, 8), QSizeF(16, 16));
        drawIcon(painter, glyphName(scene, glyph.item), square, color);
        if (glyph.item.kind != ItemKind::Light) continue;
        if (const auto* spot =
                std::get_if<SpotLight>(&scene.lights.at(LightId{glyph.item.id}).value)) {
            painter.setPen(QPen(color, 1, Qt::DashLine));
            drawLine(painter, view, spot->position, spot->target);
        }
    }
}

void paintSafeFrame(QPainter& painter, const FilmSettings& film, const ViewProjection& view) {
    const QRectF all(0, 0, view.width(), view.height());
    QRectF frame(QPointF(),
                 QSizeF(film.width, film.height).scaled(all.size(), Qt::KeepAspectRatio));
    frame.moveCenter(all.center());
    // Whole pixels without smoothing: nothing else that is drawn over the picture is as large.
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (const QRect& strip : QRegion(all.toAlignedRect()) - QRegion(frame.toRect()))
        painter.fillRect(strip, QColor(0, 0, 0, 90));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(255, 255, 255, 90), 1));
    painter.drawRect(frame);
}

void paintAxesCorner(QPainter& painter, const ViewProjection& view) {
    const QPointF center(36, view.height() - 36);
    const QString names = QStringLiteral("XYZ");
    for (int i = 0; i < 3; ++i) {
        DVec3 axis(0.0);
        axis[i] = 1;
        const QPointF end = center + 24 * QPointF(glm::dot(axis, view.axes().right),
                                                  -glm::dot(axis, view.axes().up));
        drawWithHalo(painter, kColors.axes[i], 2, [&] { painter.drawLine(center, end); });
        painter.setPen(kColors.axes[i]);
        painter.drawText(QRectF(end - QPointF(8, 8), QSizeF(16, 16)).translated((end - center) / 3),
                         Qt::AlignCenter, names.mid(i, 1));
    }
}

void paintGizmo(QPainter& painter, const ViewProjection& view, const GizmoFrame& frame, Tool tool,
                Handle hovered) {
    const auto origin = view.project(frame.origin);
    if (!origin || tool == Tool::Select) return;
    const auto colorFor = [&](Handle handle, const QColor& own) {
        return handle == hovered ? kColors.hovered : own;
    };
    const Handle axes[] = {Handle::X, Handle::Y, Handle::Z};
    painter.setBrush(Qt::NoBrush);
    if (tool == Tool::Rotate) {
        drawWithHalo(painter, colorFor(Handle::Free, kColors.handle), 1.5,
                     [&] { painter.drawPolyline(ring(view, frame, Handle::Free)); });
        for (int i = 0; i < 3; ++i)
            drawWithHalo(painter, colorFor(axes[i], kColors.axes[i]), 2.5,
                         [&] { painter.drawPolyline(ring(view, frame, axes[i])); });
        return;
    }
    const Handle planes[] = {Handle::YZ, Handle::ZX, Handle::XY};
    for (int i = 0; i < 3 && tool == Tool::Move; ++i) {
        QColor color = colorFor(planes[i], kColors.axes[i]);
        painter.setPen(QPen(color, 1));
        color.setAlpha(110);
        painter.setBrush(color);
        painter.drawPolygon(planeSquare(view, frame, planes[i]));
    }
    for (int i = 0; i < 3; ++i) {
        const auto end = axisEnd(view, frame, i);
        if (!end) continue;
        const QColor color = colorFor(axes[i], kColors.axes[i]);
        painter.setBrush(Qt::NoBrush);
        drawWithHalo(painter, color, 2.5, [&] { painter.drawLine(*origin, *end); });
        painter.setPen(QPen(QColor(0, 0, 0, 140), 1));
        painter.setBrush(color);
        if (tool == Tool::Scale)
            painter.drawRect(QRectF(*end - QPointF(5, 5), QSizeF(10, 10)));
        else
            painter.drawEllipse(*end, 5.5, 5.5);
    }
    painter.setPen(QPen(QColor(0, 0, 0, 140), 1));
    painter.setBrush(colorFor(Handle::Free, kColors.handle));
    painter.drawEllipse(*origin, 5, 5);
}

}  // namespace glint
