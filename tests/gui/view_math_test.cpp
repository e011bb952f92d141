// Projection, navigation and gizmo: pure math, no widgets.
#include <QtTest>

#include "gui/viewport/gizmo.h"
#include "gui/viewport/navigation.h"
#include "gui/viewport/overlay.h"

namespace glint {

namespace {

Camera frontCamera() {
    Camera camera;
    camera.position = {0, 0, 6};
    camera.target = {0, 0, 0};
    return camera;
}

bool isNear(const DVec3& a, const DVec3& b, double tolerance = 1e-9) {
    return glm::length(a - b) <= tolerance;
}

}  // namespace

class ViewMathTest : public QObject {
    Q_OBJECT

  private slots:
    void rayThroughAProjectedPointHitsIt() {
        for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
            Camera camera = frontCamera();
            camera.projection = projection;
            const ViewProjection view(camera, 800, 600);
            const DVec3 point(0.7, -0.4, 1.5);
            const auto pixel = view.project(point);
            QVERIFY(pixel);
            const ViewRay ray = view.ray(*pixel);
            QVERIFY(isNear(ray.origin + ray.direction * glm::dot(point - ray.origin, ray.direction),
                           point));
        }
    }
    void fieldOfViewSpansTheHeight() {
        Camera camera = frontCamera();
        camera.verticalFovDegrees = 90;
        const auto top = ViewProjection(camera, 800, 600).project({0, 6, 0});
        QVERIFY(top);
        QCOMPARE(top->y(), 0.0);
        QCOMPARE(top->x(), 400.0);
    }
    void pointsBehindTheViewerHaveNoPixel() {
        QVERIFY(!ViewProjection(frontCamera(), 800, 600).project({0, 0, 7}));
    }

    void orbitKeepsDistanceAndPivotOnScreen() {
        const DVec3 pivot(0.5, 0.3, 1);
        const Camera before = frontCamera(), after = orbited(before, pivot, 0.4, -0.2);
        QCOMPARE(glm::length(after.position - pivot), glm::length(before.position - pivot));
        const auto a = ViewProjection(before, 800, 600).project(pivot),
                   b = ViewProjection(after, 800, 600).project(pivot);
        QVERIFY(QLineF(*a, *b).length() < 1e-6);
    }
    void orbitStopsAtThePoles() {
        Camera camera = frontCamera();
        for (int i = 0; i < 100; ++i) camera = orbited(camera, {0, 0, 0}, 0, 0.3);
        QVERIFY(glm::length(
                    glm::cross(glm::normalize(camera.target - camera.position), camera.up)) > 0.01);
    }
    void dollyKeepsThePointUnderThePointer() {
        for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
            Camera camera = frontCamera();
            camera.projection = projection;
            const DVec3 point(1, 0.5, 0.2);
            const auto before = ViewProjection(camera, 800, 600).project(point);
            const auto after = ViewProjection(dollied(camera, point, 0.5), 800, 600).project(point);
            QVERIFY(QLineF(*before, *after).length() < 1e-6);
        }
    }
    void framingBringsAllCornersIntoView() {
        Bounds bounds;
        bounds.add({-3, 0, -1});
        bounds.add({5, 2, 4});
        for (const double aspect : {0.5, 1.0, 2.0}) {
            const ViewProjection view(framed(frontCamera(), bounds, aspect), 600 * aspect, 600);
            for (int i = 0; i < 8; ++i) {
                const DVec3 corner(i & 1 ? 5 : -3, i & 2 ? 2 : 0, i & 4 ? 4 : -1);
                const auto pixel = view.project(corner);
                QVERIFY(pixel && QRectF(0, 0, 600 * aspect, 600).contains(*pixel));
            }
        }
    }
    void changingTheProjectionKeepsSizesAtTheTarget() {
        const Camera perspective = frontCamera();
        const Camera orthographic = withProjection(perspective, Projection::Orthographic);
        const auto a = ViewProjection(perspective, 800, 600).project({1, 1, 0}),
                   b = ViewProjection(orthographic, 800, 600).project({1, 1, 0});
        QVERIFY(QLineF(*a, *b).length() < 1e-6);
        QVERIFY(isNear(withProjection(orthographic, Projection::Perspective).position,
                       perspective.position));
    }
    void lookingStraightDownChoosesAnUp() {
        const Camera camera = lookingAlong(frontCamera(), {0, -1, 0});
        QVERIFY(isNear(camera.position, {0, 6, 0}));
        QVERIFY(glm::length(glm::cross(camera.up, DVec3(0, 1, 0))) > 0.5);
    }

    void axisHandleIsHitAtItsEnd() {
        const ViewProjection view(frontCamera(), 800, 600);
        const GizmoFrame frame;
        const auto end = axisEnd(view, frame, 0);
        QVERIFY(end);
        QCOMPARE(handleAt(view, frame, Tool::Move, *end), Handle::X);
        QCOMPARE(handleAt(view, frame, Tool::Move, {400, 300}), Handle::Free);
        QCOMPARE(handleAt(view, frame, Tool::Move, {10, 10}), Handle::None);
        QCOMPARE(handleAt(view, frame, Tool::Select, *end), Handle::None);
    }
    void axisAlongTheViewHasNoHandle() {
        QVERIFY(!axisEnd(ViewProjection(frontCamera(), 800, 600), {}, 2));
    }

    void axisDragMovesAlongThatAxisOnly() {
        const ViewProjection view(frontCamera(), 800, 600);
        const auto from = view.project({0.5, 0, 0}), to = view.project({1.5, 0.8, 0});
        const GizmoDrag drag(Tool::Move, Handle::X, {}, view, *from);
        const DVec3 moved = drag.change({*to}).translation;
        QVERIFY(std::abs(moved.y) < 1e-12 && std::abs(moved.z) < 1e-12);
        QVERIFY(std::abs(moved.x - 1) < 0.05);
        QVERIFY(isNear(drag.change({*view.project({1.5, 0, 0})}).translation, {1, 0, 0}));
    }
    void freeDragFollowsThePointer() {
        const ViewProjection view(frontCamera(), 800, 600);
        const GizmoDrag drag(Tool::Move, Handle::Free, {}, view, {400, 300});
        QVERIFY(isNear(drag.change({*view.project({0.3, -0.7, 0})}).translation, {0.3, -0.7, 0}));
    }
    void snappedDragMovesByWholeSteps() {
        const ViewProjection view(frontCamera(), 800, 600);
        const GizmoDrag drag(Tool::Move, Handle::X, {}, view, {400, 300});
        QVERIFY(isNear(drag.change({.at = *view.project({0.34, 0, 0}), .snap = true}).translation,
                       {0.3, 0, 0}));
    }
    void fineDragMovesATenth() {
        const ViewProjection view(frontCamera(), 800, 600);
        const GizmoDrag drag(Tool::Move, Handle::X, {}, view, {400, 300});
        QVERIFY(isNear(drag.change({.at = *view.project({1, 0, 0}), .fine = true}).translation,
                       {0.1, 0, 0}));
    }
    void turningCounterClockwiseIsPositiveAboutAnAxisTowardsTheViewer() {
        const ViewProjection view(frontCamera(), 800, 600);
        const GizmoDrag drag(Tool::Rotate, Handle::Z, {}, view, {480, 300});
        const GizmoChange change = drag.change({QPointF(400, 220)});
        QCOMPARE(change.angle, kPi / 2);
        QVERIFY(isNear(toAffine(change, DVec3(0), DMat3(1.0)).point({1, 0, 0}), {0, 1, 0}));
    }
    void scaleNeverReachesZero() {
        const ViewProjection view(frontCamera(), 800, 600);
        const auto at = view.project({1, 0, 0});
        const GizmoDrag drag(Tool::Scale, Handle::X, {}, view, *at);
        QVERIFY(isNear(drag.change({*view.project({2, 0, 0})}).scale, {2, 1, 1}));
        QVERIFY(drag.change({QPointF(400, 300)}).scale.x != 0);
    }
    void typedNumbersAreExact() {
        const ViewProjection view(frontCamera(), 800, 600);
        QCOMPARE(GizmoDrag(Tool::Move, Handle::Y, {}, view, {}).typed(2.5).translation.y, 2.5);
        QCOMPARE(GizmoDrag(Tool::Rotate, Handle::Y, {}, view, {}).typed(90).angle, kPi / 2);
        QCOMPARE(GizmoDrag(Tool::Scale, Handle::Free, {}, view, {}).typed(3).scale.z, 3.0);
    }
    void changeKeepsThePivot() {
        GizmoChange change;
        change.angle = 1;
        change.scale = {2, 3, 4};
        const DVec3 pivot(1, 2, 3);
        QVERIFY(isNear(toAffine(change, pivot, DMat3(1.0)).point(pivot), pivot));
    }

    void hullOfASquareDropsInnerPoints() {
        const QPolygonF hull = convexHull({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}, {1, 3}});
        QCOMPARE(hull.boundingRect(), QRectF(0, 0, 4, 4));
        QVERIFY(!hull.contains(QPointF(2, 2)));
    }
    void outlineOfASphereIsItsSilhouette() {
        Scene scene;
        Object ball;
        ball.shape = Sphere{1};
        const ViewProjection view(frontCamera(), 800, 600);
        const QRectF box = outlineOf(scene, ball, view).boundingRect();
        // The silhouette of a sphere of radius r at distance d has the angle asin(r / d).
        const double expected = std::tan(std::asin(1.0 / 6)) / std::tan(degreesToRadians(20)) * 300;
        QVERIFY(std::abs(box.width() / 2 - expected) < 0.02 * expected);
        QVERIFY(std::abs(box.height() / 2 - expected) < 0.02 * expected);
    }
};

}  // namespace glint

QTEST_GUILESS_MAIN(glint::ViewMathTest)
#include "view_math_test.moc"
