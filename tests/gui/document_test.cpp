#include "gui/app/document.h"

#include <QSignalSpy>

#include "gui/app/selection.h"
#include "support.h"

namespace glint {

using namespace test;

class DocumentTest : public QObject {
    Q_OBJECT

    static Scene renamedBall(const Document& document, const char* name) {
        return renamed(document.committed(), kBall, name);
    }

  private slots:
    void everyEditUndoesAndRedoes() {
        Document document;
        document.replace(smallScene(), {});
        std::vector<Scene> states{document.scene()};
        document.edit(renamedBall(document, "A"), "Rename");
        states.push_back(document.scene());
        document.edit(removed(document.committed(), {kBall}), "Delete");
        states.push_back(document.scene());
        for (int i = 1; i >= 0; --i) {
            document.undoStack().undo();
            QVERIFY(document.scene() == states[static_cast<std::size_t>(i)]);
        }
        for (std::size_t i = 1; i < states.size(); ++i) {
            document.undoStack().redo();
            QVERIFY(document.scene() == states[i]);
        }
    }
    void editWithoutChangeLeavesNoStep() {
        Document document;
        document.edit(Scene(document.scene()), "Nothing");
        QCOMPARE(document.undoStack().count(), 0);
        QVERIFY(!document.isModified());
    }
    void previewIsOneStep() {
        Document document;
        document.replace(smallScene(), {});
        const Scene before = document.scene();
        for (const char* name : {"A", "B", "C"}) document.preview(renamedBall(document, name));
        QCOMPARE(document.undoStack().count(), 0);
        document.commitPreview("Rename");
        QCOMPARE(document.undoStack().count(), 1);
        QCOMPARE(nameOf(document.scene(), kBall), std::string("C"));
        document.undoStack().undo();
        QVERIFY(document.scene() == before);
    }
    void canceledPreviewLeavesNothing() {
        Document document;
        document.replace(smallScene(), {});
        const Scene before = document.scene();
        document.preview(renamedBall(document, "A"));
        document.cancelPreview();
        QVERIFY(document.scene() == before);
        QVERIFY(!document.isModified());
    }
    void stepsWithTheSameKeyMerge() {
        Document document;
        document.replace(smallScene(), {});
        const Scene before = document.scene();
        document.edit(renamedBall(document, "A"), "Rename", "name");
        document.edit(renamedBall(document, "B"), "Rename", "name");
        QCOMPARE(document.undoStack().count(), 1);
        document.edit(renamedBall(document, "Ball"), "Rename", "name");
        QCOMPARE(document.undoStack().count(), 0);
        QVERIFY(document.scene() == before);
    }
    void navigationIsNoEdit() {
        Document document;
        document.replace(smallScene(), {});
        Camera camera = document.scene().camera;
        camera.position.x += 1;
        document.navigate(camera);
        QVERIFY(!document.isModified());
        QCOMPARE(document.undoStack().count(), 0);
    }
    void undoKeepsTheView() {
        Document document;
        document.replace(smallScene(), {});
        document.edit(renamedBall(document, "A"), "Rename");
        Camera camera = document.scene().camera;
        camera.position.x += 1;
        document.navigate(camera);
        document.undoStack().undo();
        QCOMPARE(nameOf(document.scene(), kBall), std::string("Ball"));
        QVERIFY(document.scene().camera == camera);
    }
    void undoOfACameraEditMovesTheCameraBack() {
        Document document;
        document.replace(smallScene(), {});
        const Camera before = document.scene().camera;
        Scene scene = document.scene();
        scene.camera.verticalFovDegrees = 20;
        document.edit(scene, "Angle of view");
        document.undoStack().undo();
        QVERIFY(document.scene().camera == before);
    }
    void selectionFollowsWhatGoesAndComes() {
        Document document;
        Selection selection(document);
        document.replace(smallScene(), {});
        selection.set({kBall});
        document.edit(removed(document.committed(), {kBall}), "Delete");
        QVERIFY(selection.isEmpty());
        document.undoStack().undo();
        QCOMPARE(selection.items(), std::vector<Item>{kBall});
        document.undoStack().redo();
        QVERIFY(selection.isEmpty());
    }
    void newDocumentSelectsNothingOnItsWay() {
        Document document;
        Selection selection(document);
        const QSignalSpy changes(&selection, &Selection::changed);
        document.replace(smallScene(), {});
        QCOMPARE(changes.count(), 0);
        selection.set({kBall});
        document.replace(Scene{}, {});
        QVERIFY(selection.isEmpty());
        QCOMPARE(changes.count(), 2);
    }
    void savedDocumentIsUnmodified() {
        Document document;
        document.replace(smallScene(), {});
        document.edit(renamedBall(document, "A"), "Rename");
        QVERIFY(document.isModified());
        document.setSaved("/tmp/a.json", document.scene());
        QVERIFY(!document.isModified());
        document.undoStack().undo();
        QVERIFY(document.isModified());
    }
    void recoveredDocumentCountsAsModified() {
        Document document;
        document.replace(smallScene(), {}, Document::Origin::Recovered);
        QVERIFY(document.isModified());
    }

    void removingAGroupTakesItsContent() {
        auto [scene, group] = withGroup(smallScene(), Group{"G", {}, {}});
        scene = movedInto(scene, kBall, group);
        QVERIFY(removed(scene, {Item::of(group)}).objects.empty());
    }
    void duplicateOfAGroupHoldsCopies() {
        auto [scene, group] = withGroup(smallScene(), Group{"G", {}, {}});
        scene = movedInto(scene, kBall, group);
        const CopiedItems copied = duplicated(scene, {Item::of(group), kBall});
        QCOMPARE(copied.copies.size(), std::size_t(1));
        QCOMPARE(copied.scene.objects.size(), std::size_t(2));
        QVERIFY(copied.scene.objects.at(ObjectId{2}).parent == GroupId{copied.copies.front().id});
    }
    void transformingALightMovesIt() {
        const Scene scene = smallScene();
        const Item light = Item::of(LightId{1});
        const Scene moved = transformed(scene, light, Affine{DMat3(1.0), {1, 2, 3}});
        QVERIFY(worldFromItem(moved, light).translation ==
                worldFromItem(scene, light).translation + DVec3(1, 2, 3));
    }
};

}  // namespace glint

QTEST_MAIN(glint::DocumentTest)
#include "document_test.moc"
