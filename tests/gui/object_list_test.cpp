#include "gui/panels/object_list.h"

#include <QAbstractItemModelTester>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QMimeData>
#include <QTreeView>

#include "gui/panels/object_model.h"
#include "support.h"

namespace glint {

using namespace test;

class ObjectListTest : public QObject {
    Q_OBJECT

    static Scene manyObjects(int count) {
        Scene scene = smallScene();
        std::vector<Object> objects;
        for (int i = 0; i < count; ++i)
            objects.push_back({"Object " + std::to_string(i), Sphere{}});
        scene.objects.addAll(std::move(objects));
        return scene;
    }

  private slots:
    void modelFollowsEdits() {
        Document document;
        document.replace(smallScene(), {});
        ObjectModel model(document);
        QAbstractItemModelTester tester(&model,
                                        QAbstractItemModelTester::FailureReportingMode::QtTest);
        QCOMPARE(model.rowCount(), 3);  // Ball, light, camera.
        auto [scene, group] = withGroup(document.scene(), Group{"G", {}, {}});
        document.edit(scene, "Group");
        document.edit(movedInto(document.scene(), kBall, group), "Move");
        QCOMPARE(model.rowCount(), 3);
        QCOMPARE(model.rowCount(model.indexOf(Item::of(group))), 1);
        document.edit(withObject(document.scene(), Object{"Second", Box{}}).scene, "Add");
        QCOMPARE(model.rowCount(), 4);
        document.edit(removed(document.scene(), {Item::of(group)}), "Delete");
        QCOMPARE(model.rowCount(), 3);
        while (document.undoStack().canUndo()) document.undoStack().undo();
        QCOMPARE(model.rowCount(), 3);
        while (document.undoStack().canRedo()) document.undoStack().redo();
        QCOMPARE(model.rowCount(), 3);
    }
    void renamingInPlace() {
        Document document;
        Selection selection(document);
        document.replace(smallScene(), {});
        ObjectList list(document, selection);
        list.show();
        selection.set({kBall});
        list.renameActive();
        auto* editor = list.tree()->findChild<QLineEdit*>();
        QVERIFY(editor);
        editor->selectAll();
        QTest::keyClicks(editor, "Marble");
        QTest::keyClick(editor, Qt::Key_Return);
        // The view takes the editor's text in the next event.
        QTRY_COMPARE_WITH_TIMEOUT(nameOf(document.scene(), kBall), std::string("Marble"),
                                  kPatienceMs);
        document.undoStack().undo();
        QCOMPARE(nameOf(document.scene(), kBall), std::string("Ball"));
    }
    void aTakenNameIsRefusedWithAReason() {
        Document document;
        document.replace(manyObjects(1), {});
        ObjectModel model(document);
        QSignalSpy refused(&model, &ObjectModel::refused);
        QVERIFY(!model.setData(model.indexOf(kBall), "Object 0", Qt::EditRole));
        QCOMPARE(refused.count(), 1);
        QCOMPARE(nameOf(document.scene(), kBall), std::string("Ball"));
    }
    void manySelectedRowsAreFewRanges() {
        // The tree goes through all ranges for every row that it paints.
        constexpr int kGroups = 3, kEach = 20;
        Scene scene;
        std::vector<GroupId> groups;
        for (int i = 0; i < kGroups; ++i)
            groups.push_back(scene.groups.add({"Group " + std::to_string(i), {}, {}}));
        std::vector<Item> items;
        for (int i = 0; i < kGroups * kEach; ++i) {
            Object object{"Object " + std::to_string(i), Sphere{}};
            object.parent = groups[static_cast<std::size_t>(i % kGroups)];
            items.push_back(Item::of(scene.objects.add(std::move(object))));
        }
        Document document;
        Selection selection(document);
        document.replace(scene, {});
        ObjectList list(document, selection);
        selection.set(items);
        const QItemSelectionModel& rows = *list.tree()->selectionModel();
        QCOMPARE(rows.selectedRows().size(), qsizetype(kGroups * kEach));
        QCOMPARE(rows.selection().size(), qsizetype(kGroups));
    }
    void whatMovesIntoAGroupStaysSelected() {
        Document document;
        Selection selection(document);
        document.replace(smallScene(), {});
        ObjectList list(document, selection);
        QAbstractItemModelTester tester(list.model(),
                                        QAbstractItemModelTester::FailureReportingMode::QtTest);
        auto [scene, group] = withGroup(document.scene(), Group{"G", {}, {}});
        document.edit(scene, "Group");
        selection.set({kBall});
        document.edit(movedInto(document.scene(), kBall, group), "Move");
        QCOMPARE(selection.items(), std::vector<Item>{kBall});
        QCOMPARE(list.tree()->selectionModel()->selectedRows().size(), qsizetype(1));
        document.undoStack().undo();
        QCOMPARE(selection.items(), std::vector<Item>{kBall});
    }
    void closedGroupsStayClosedUntilAnotherScene() {
        Document document;
        Selection selection(document);
        auto [scene, group] = withGroup(smallScene(), Group{"G", {}, {}});
        document.replace(movedInto(scene, kBall, group), {});
        ObjectList list(document, selection);
        const auto isOpen = [&] {
            return list.tree()->isExpanded(list.tree()->model()->index(0, 0));
        };
        QVERIFY(isOpen());
        list.tree()->collapse(list.tree()->model()->index(0, 0));
        document.edit(withGroup(document.scene(), Group{"Another", {}, {}}).scene, "Group");
        QVERIFY(!isOpen());
        document.replace(movedInto(scene, kBall, group), {});
        QVERIFY(isOpen());
    }
    void clickOnTheEyeHides() {
        Document document;
        Selection selection(document);
        document.replace(smallScene(), {});
        ObjectList list(document, selection);
        list.resize(300, 400);
        list.show();
        auto* tree = list.tree();
        const QModelIndex eye = tree->model()->index(0, ObjectModel::VisibleColumn);
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualRect(eye).center());
        QVERIFY(!document.scene().objects.at(ObjectId{1}).visible);
        document.undoStack().undo();
        QVERIFY(document.scene().objects.at(ObjectId{1}).visible);
    }
    void clickingARowSelectsItsItem() {
        Document document;
        Selection selection(document);
        document.replace(smallScene(), {});
        ObjectList list(document, selection);
        list.resize(300, 400);
        list.show();
        auto* tree = list.tree();
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, {},
                          tree->visualRect(tree->model()->index(0, 0)).center());
        QCOMPARE(selection.items(), std::vector<Item>{kBall});
        selection.clear();
        QVERIFY(!tree->selectionModel()->hasSelection());
    }
    void droppingOnAGroupKeepsThePlace() {
        Document document;
        Group group{"G", {}, {}};
        group.transform.translate = {5, 0, 0};
        auto [scene, id] = withGroup(smallScene(), group);
        document.replace(scene, {});
        ObjectModel model(document);
        const std::unique_ptr<QMimeData> data(model.mimeData({model.indexOf(kBall)}));
        model.dropMimeData(data.get(), Qt::MoveAction, -1, -1, model.indexOf(Item::of(id)));
        QCOMPARE(parentOf(document.scene(), kBall), id);
        QVERIFY(glm::length(worldFromItem(document.scene(), kBall).translation) < 1e-12);
        QCOMPARE(document.undoStack().count(), 1);
    }
    void searchShowsMatchesOnly() {
        Document document;
        Selection selection(document);
        document.replace(manyObjects(30), {});
        ObjectList list(document, selection);
        list.show();
        list.findChild<QLineEdit*>()->setText("object 2");
        QCOMPARE(list.tree()->model()->rowCount(), 11);  // 2 and 20 to 29.
    }
    void thousandsOfObjectsDoNotStall() {
        Document document;
        Selection selection(document);
        document.replace(manyObjects(5000), {});
        ObjectList list(document, selection);
        list.resize(300, 600);
        list.show();
        QElapsedTimer clock;
        clock.start();
        std::vector<Item> all;
        document.scene().objects.forEach(
            [&](ObjectId id, const Object&) { all.push_back(Item::of(id)); });
        selection.set(all);
        document.edit(renamed(document.scene(), kBall, "Renamed"), "Rename");
        // Generous, as a busy machine must not fail it: the quadratic version takes minutes.
        QVERIFY2(clock.elapsed() < 2000, qPrintable(QString::number(clock.elapsed())));
        QCOMPARE(list.tree()->selectionModel()->selectedRows().size(), qsizetype(5001));
    }
};

}  // namespace glint

QTEST_MAIN(glint::ObjectListTest)
#include "object_list_test.moc"
