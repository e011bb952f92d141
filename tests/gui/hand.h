// Hand: a person's mouse and keyboard on a window: menus, fields, lists, each by real events on
// what is visible.
#pragma once

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>
#include <QTreeView>

#include "gui/app/text.h"
#include "gui/panels/form_builder.h"
#include "gui/panels/object_list.h"
#include "gui/panels/object_model.h"
#include "gui/widgets/color_button.h"
#include "gui/widgets/color_popup.h"
#include "support.h"

namespace glint::test {

class Hand {
  public:
    explicit Hand(MainWindow& window) : window_(window) {}

    /// Faults so far; each says what the hand could not do.
    [[nodiscard]] const QStringList& faults() const { return faults_; }

    /// A key on the window itself, as the system sends it: the application finds the shortcut or
    /// the focused widget.
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        // A closed list or dialog leaves no window active where there is no window manager.
        while (QWidget* popup = QApplication::activePopupWidget()) popup->close();
        window_.activateWindow();
        if (!QTest::qWaitForWindowActive(&window_)) return fault("the window is not active");
        QTest::keyClick(window_.windowHandle(), key, modifiers);
        QCoreApplication::processEvents();
    }
    /// Shift+A over the picture, then a click on the entry.
    void add(const QString& entry) {
        window_.view().setFocus();
        key(Qt::Key_A, Qt::ShiftModifier);
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        if (!menu) return fault("no add menu");
        for (QAction* action : menu->actions())
            if (action->objectName() == entry) {
                QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
                QCoreApplication::processEvents();
                return;
            }
        fault("no entry " + entry);
        menu->close();
    }
    /// A dock's tab, by its text.
    void openTab(const QString& text) {
        for (QTabBar* bar : window_.findChildren<QTabBar*>())
            for (int i = 0; i < bar->count(); ++i)
                if (bar->tabText(i) == text) {
                    QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(i).center());
                    QCoreApplication::processEvents();
                    return;
                }
        fault("no tab " + text);
    }
    /// A click on the row of the object list that shows `name`.
    void clickRow(const QString& name) {
        QTreeView* tree = window_.objectList().tree();
        const auto found = tree->model()->match(tree->model()->index(0, 0), Qt::DisplayRole, name,
                                                1, Qt::MatchExactly | Qt::MatchRecursive);
        if (found.isEmpty()) return fault("no row " + name);
        tree->scrollTo(found.first());
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, {},
                          tree->visualRect(found.first()).center());
        QCoreApplication::processEvents();
    }
    void clickThumbnail(QListWidget* list, const QString& text) {
        const auto found = list->findItems(text, Qt::MatchExactly);
        if (found.isEmpty()) return fault("no picture " + text);
        list->scrollToItem(found.first());
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                          list->visualItemRect(found.first()).center());
    }

    // ---- Fields, by their paths ----

    void set(const QString& path, double value) {
        if (auto* number = find<DragNumber>(path))
            type(number, QString::number(value, 'g', QLocale::FloatingPointShortest));
        settle();
    }
    void set(const QString& path, int value) { set(path, static_cast<double>(value)); }
    void set(const QString& path, const DVec3& value) {
        for (int i = 0; i < 3; ++i) set(path + QStringLiteral(".%1").arg(i), value[i]);
    }
    void set(const QString& path, const DVec2& value) {
        for (int i = 0; i < 2; ++i) set(path + QStringLiteral(".%1").arg(i), value[i]);
    }
    void set(const QString& path, const Color& value) {
        auto* button = find<ColorButton>(path);
        if (!button) return;
        QTest::mouseClick(button, Qt::LeftButton);
        const double channels[] = {value.r, value.g, value.b};
        for (int i = 0; i < 3; ++i)
            type(button->popup().findChild<DragNumber*>(QStringLiteral("channel%1").arg(i)),
                 QString::number(channels[i], 'g', QLocale::FloatingPointShortest));
        QTest::keyClick(&button->popup(), Qt::Key_Escape);
        if (button->popup().isVisible()) button->popup().close();
        settle();
    }
    void write(const QString& path, const QString& text) {
        auto* line = find<QLineEdit>(path);
        if (!line) return;
        QTest::mouseClick(line, Qt::LeftButton);
        line->selectAll();
        QTest::keyClicks(line, text);
        QTest::keyClick(line, Qt::Key_Return);
        settle();
    }
    void press(const QString& path) {
        if (auto* box = find<QCheckBox>(path))
            QTest::mouseClick(box, Qt::LeftButton, {}, {6, box->height() / 2});
        settle();
    }
    /// Opens the list and goes to the entry by arrow keys.
    void choose(const QString& path, const QString& text) {
        auto* combo = find<QComboBox>(path);
        if (!combo) return;
        const int wanted = combo->findText(text);
        if (wanted < 0) return fault(path + " has no " + text);
        QTest::mouseClick(combo, Qt::LeftButton, {}, {combo->width() / 2, combo->height() / 2});
        QTest::keyClick(combo->view(), Qt::Key_Home);
        for (int i = 0; i < wanted; ++i) QTest::keyClick(combo->view(), Qt::Key_Down);
        QTest::keyClick(combo->view(), Qt::Key_Return);
        settle();
    }
    template <class Enum>
    requires std::is_enum_v<Enum>
    void set(const QString& path, Enum value) {
        choose(path, labelOf(enumNames(value)[static_cast<std::size_t>(value)]));
    }
    template <class T>
    void set(const QString& path, const Textured<T>& value) {
        set(path, value.value);
    }
    /// Every field of a struct that differs from what is there.
    template <class T>
    void fill(const QString& path, const T& wanted, const T& present) {
        std::apply(
            [&](const auto&... field) {
                (fillField(path + '.' + toQString(field.name), wanted.*field.member,
                           present.*field.member),
                 ...);
            },
            T::fields());
    }

    void fault(const QString& what) { faults_ << what; }
    template <class W>
    W* find(const QString& name) {
        // An old form may still be on its way out.
        W* found = nullptr;
        for (W* candidate : window_.findChildren<W*>(name))
            if (!found || candidate->isVisible()) found = candidate;
        if (!found) fault("no field " + name);
        return found;
    }

  private:
    void settle() {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QCoreApplication::processEvents();
    }
    template <class T>
    void fillField(const QString& path, const T& wanted, const T& present) {
        if (wanted == present) return;
        if constexpr (HasFields<T>)
            fill(path, wanted, present);
        else if constexpr (std::is_same_v<T, bool>)
            press(path);
        else if constexpr (std::is_same_v<T, std::string>)
            write(path, toQString(wanted));
        else if constexpr (requires { set(path, wanted); })
            set(path, wanted);
        else
            fault("no way to fill " + path);
    }

    MainWindow& window_;
    QStringList faults_;
};

}  // namespace glint::test
