// Every edit undoes and redoes to an equal document: random edits through the whole window. 400 of
// them, or 10 000 with GLINT_FULL=1.
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QListWidget>
#include <QMimeData>
#include <QTreeView>
#include <map>
#include <random>

#include "gui/app/actions.h"
#include "gui/app/renderer.h"
#include "gui/panels/environment_picker.h"
#include "gui/panels/object_list.h"
#include "gui/panels/object_model.h"
#include "gui/panels/property_panel.h"
#include "gui/widgets/message_bar.h"
#include "support.h"
#include "tracer/io/scene_check.h"
#include "tracer/io/scene_json.h"

namespace glint {

using namespace test;

namespace {

/// Edits without a plan, each by the command, widget or gesture that a person would use.
class RandomEditor {
  public:
    RandomEditor(MainWindow& window, unsigned seed) : window_(window), random_(seed) {}

    void step() {
        switch (below(12)) {
            case 0:
            case 1:
                return select();
            case 2:
            case 3:
                return command();
            case 4:
            case 5:
                return typeNumber();
            case 6:
                return pressField();
            case 7:
                return listEdit();
            case 8:
                return drop();
            case 9:
                return dragGizmo();
            case 10:
                return walk();
            default:
                return environment();
        }
    }
    [[nodiscard]] const QString& last() const { return last_; }

  private:
    int below(std::size_t n) { return static_cast<int>(random_() % n); }
    Document& document() { return window_.document(); }

    std::vector<Item> items() {
        std::vector<Item> out;
        const Scene& scene = document().scene();
        const auto collect = [&](auto id, const auto&) { out.push_back(Item::of(id)); };
        scene.objects.forEach(collect);
        scene.groups.forEach(collect);
        scene.lights.forEach(collect);
        scene.cameras.forEach(collect);
        return out;
    }
    Item any() {
        const auto all = items();
        return all.empty() ? Item{ItemKind::Camera, 0}
                           : all[static_cast<std::size_t>(below(all.size()))];
    }
    void trigger(const QString& id) {
        last_ = id;
        if (auto* action = window_.findChild<QAction*>(id); action && action->isEnabled())
            action->trigger();
    }

    void select() {
        std::vector<Item> chosen;
        for (int i = 0; i <= below(4); ++i)
            if (const Item item = any();
                std::find(chosen.begin(), chosen.end(), item) == chosen.end())
                chosen.push_back(item);
        last_ = "select";
        window_.selection().set(chosen);
    }
    void command() {
        static const char* ids[] = {
            "edit.delete",   "edit.duplicate", "edit.hide", "edit.showAll", "edit.group",
            "edit.ungroup",  "edit.cut",       "edit.copy", "edit.paste",   "view.darker",
            "view.brighter", "add.sphere",     "add.box",   "add.torus",    "add.point",
            "add.sun",       "add.group"};
        // Few things are enough to go wrong, and quick.
        constexpr std::size_t kMost = 40;
        if (items().size() > kMost) {
            window_.selection().set(items());
            return trigger("edit.delete");
        }
        trigger(ids[below(std::size(ids))]);
    }
    void typeNumber() {
        const auto numbers = window_.findChildren<DragNumber*>();
        auto* number = numbers[below(static_cast<std::size_t>(numbers.size()))];
        if (!number->isEnabled()) return;
        last_ = "type into " + number->objectName();
        static const char* texts[] = {"0.5", "2", "1", "-3", "0", "1/3", "1e3", "nonsense", "45"};
        number->setFocus();
        number->selectAll();
        QTest::keyClicks(number, texts[below(std::size(texts))]);
        QTest::keyClick(number, Qt::Key_Return);
    }
    void pressField() {
        const auto boxes = window_.properties().findChildren<QCheckBox*>();
        const auto combos = window_.properties().findChildren<QComboBox*>();
        if (below(2) && !boxes.isEmpty()) {
            auto* box = boxes[below(static_cast<std::size_t>(boxes.size()))];
            last_ = "press " + box->objectName();
            box->click();
        } else if (!combos.isEmpty()) {
            auto* combo = combos[below(static_cast<std::size_t>(combos.size()))];
            if (combo->count() == 0) return;
            last_ = "choose " + combo->objectName();
            emit combo->activated(below(static_cast<std::size_t>(combo->count())));
        }
        QCoreApplication::processEvents();  // The panel may be made anew.
    }
    void listEdit() {
        ObjectModel& model = *window_.objectList().model();
        const QModelIndex index = model.indexOf(any());
        switch (below(3)) {
            case 0:
                last_ = "rename",
                model.setData(index, QStringLiteral("Name %1").arg(below(60)), Qt::EditRole);
                return;
            case 1:
                last_ = "eye", model.toggle(index.siblingAtColumn(ObjectModel::VisibleColumn));
                return;
            default:
                last_ = "lock", model.toggle(index.siblingAtColumn(ObjectModel::LockedColumn));
                return;
        }
    }
    void drop() {
        last_ = "drop";
        ObjectModel& model = *window_.objectList().model();
        const std::unique_ptr<QMimeData> data(
            model.mimeData({model.indexOf(any()), model.indexOf(any())}));
        model.dropMimeData(data.get(), Qt::MoveAction, -1, -1,
                           below(3) ? model.indexOf(any()) : QModelIndex());
    }
    void dragGizmo() {
        static const char* tools[] = {"tool.move", "tool.rotate", "tool.scale"};
        trigger(tools[below(3)]);
        last_ = "drag";
        RenderView& view = window_.view();
        const auto frame = view.context().gizmoFrame();
        const auto origin =
            frame ? view.context().projection().project(frame->origin) : std::nullopt;
        if (!origin || !view.rect().contains(origin->toPoint())) return;
        const QPoint from = origin->toPoint() + QPoint(below(80), 0);
        const QPoint to = from + QPoint(below(120) - 60, below(120) - 60);
        if (below(4) == 0) {
            QTest::mousePress(&view, Qt::LeftButton, {}, from);
            QTest::mouseMove(&view, to);
            QTest::keyClick(&view, Qt::Key_Escape);
            QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
        } else {
            drag(&view, Qt::LeftButton, from, to, below(3) ? Qt::NoModifier : Qt::ControlModifier);
        }
    }
    void walk() {
        for (int i = below(6); i >= 0; --i) trigger(below(2) ? "edit.undo" : "edit.redo");
    }
    void environment() {
        QListWidget* list = window_.environment().thumbnails();
        last_ = "environment";
        emit list->itemActivated(list->item(below(static_cast<std::size_t>(list->count()))));
    }

    MainWindow& window_;
    std::mt19937 random_;
    QString last_;
};

/// The documents that the undo stack has led to, by its index.
class History {
  public:
    explicit History(MainWindow& window) : document_(window.document()) {
        states_[0] = document_.scene();
    }

    /// After each step. Empty, or what is wrong.
    QString check() {
        const QUndoStack& stack = document_.undoStack();
        const int index = stack.index();
        const Scene& scene = document_.scene();
        if (!sceneProblems(scene).empty())
            return "unsound: " + QString::fromStdString(sceneProblems(scene).front().text());
        const QUndoCommand* command = index > 0 ? stack.command(index - 1) : nullptr;
        // The same command is the same state; another one at the same place takes its place, and
        // what came after is gone.
        if (commands_[index] == command && states_.contains(index) &&
            stack.undoText() == texts_[index]) {
            if (scene == states_[index]) return {};
            if (index != stack.count())
                return "another document than before after " + stack.undoText();
        }
        for (auto later = states_.upper_bound(index); later != states_.end();)
            later = later->first > stack.count() || index == stack.count() ? states_.erase(later)
                                                                           : std::next(later);
        commands_[index] = command;
        texts_[index] = stack.undoText();
        states_[index] = scene;
        return {};
    }
    /// All the way back and forth: every index that was seen holds the same document again.
    QString walkAll() {
        QUndoStack& stack = document_.undoStack();
        const auto compare = [&]() -> QString {
            const auto known = states_.find(stack.index());
            return known == states_.end() || known->second == document_.scene()
                       ? QString()
                       : QStringLiteral("index %1: %2").arg(stack.index()).arg(stack.undoText());
        };
        QString wrong;
        while (wrong.isEmpty() && stack.canUndo()) stack.undo(), wrong = compare();
        while (wrong.isEmpty() && stack.canRedo()) stack.redo(), wrong = compare();
        return wrong;
    }

  private:
    Document& document_;
    std::map<int, Scene> states_;
    std::map<int, const QUndoCommand*> commands_;
    std::map<int, QString> texts_;
};

}  // namespace

class UndoTest : public QObject {
    Q_OBJECT

  private slots:
    void randomEditsUndoAndRedoToEqualDocuments() {
        const int steps = qEnvironmentVariableIsSet("GLINT_FULL") ? 10000 : 400;
        constexpr unsigned kSeed = 7;
        const auto window = openWindow();
        window->renderer().setPaused(true);
        RandomEditor editor(*window, kSeed);
        History history(*window);
        for (int i = 0; i < steps; ++i) {
            editor.step();
            const QString wrong = history.check();
            QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("seed %1, step %2 (%3): %4")
                                                     .arg(kSeed)
                                                     .arg(i)
                                                     .arg(editor.last(), wrong)));
        }
        const int edits = window->document().undoStack().count();
        QVERIFY(edits > steps / 8);
        const QString wrong = history.walkAll();
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        QVERIFY(parseScene(formatScene(window->document().scene()), "scene").ok());
        std::printf("%d steps, %d edits on the stack\n", steps, edits);
    }
};

}  // namespace glint

QTEST_MAIN(glint::UndoTest)
#include "undo_test.moc"
