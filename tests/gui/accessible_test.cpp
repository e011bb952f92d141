// Everything that can be operated has a name for those who hear it read, and can be reached by
// keyboard.
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QScrollBar>

#include "gui/app/actions.h"
#include "gui/app/export_dialog.h"
#include "gui/app/preferences_dialog.h"
#include "gui/panels/property_panel.h"
#include "support.h"

namespace glint {

using namespace test;

namespace {

bool canBeOperated(const QWidget* widget) {
    return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QLineEdit*>(widget) ||
           qobject_cast<const QComboBox*>(widget) ||
           qobject_cast<const QAbstractItemView*>(widget) ||
           qobject_cast<const QAbstractSpinBox*>(widget);
}

/// Parts that Qt makes: the whole they belong to speaks for them.
bool isPart(const QWidget* widget) {
    for (const QWidget* up = widget->parentWidget(); up; up = up->parentWidget())
        if (qobject_cast<const QComboBox*>(up) || qobject_cast<const QLineEdit*>(up) ||
            qobject_cast<const QAbstractSpinBox*>(up) || qobject_cast<const QAbstractItemView*>(up))
            return true;
    return widget->objectName().startsWith("qt_");
}

QString placeOf(const QWidget* widget) {
    QStringList way;
    for (; widget; widget = widget->parentWidget())
        way.prepend(QString(widget->metaObject()->className()) + ' ' + widget->objectName());
    return way.join(" / ");
}

/// Widgets under `root` that are shown and have no name.
QStringList nameless(const QWidget& root) {
    QStringList out;
    for (QWidget* widget : root.findChildren<QWidget*>()) {
        if (!canBeOperated(widget) || isPart(widget) || !widget->isVisibleTo(&root)) continue;
        QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(widget);
        if (!spoken || spoken->text(QAccessible::Name).trimmed().isEmpty()) out << placeOf(widget);
    }
    return out;
}

/// Widgets under `root` that Tab does not reach and whose work no action does.
QStringList unreachable(const QWidget& root) {
    QStringList out;
    for (QWidget* widget : root.findChildren<QWidget*>()) {
        const bool field = qobject_cast<QLineEdit*>(widget) || qobject_cast<QComboBox*>(widget) ||
                           qobject_cast<QAbstractItemView*>(widget);
        if (!field || isPart(widget) || !widget->isVisibleTo(&root)) continue;
        if (!(widget->focusPolicy() & Qt::TabFocus)) out << placeOf(widget);
    }
    return out;
}

}  // namespace

class AccessibleTest : public QObject {
    Q_OBJECT

    std::unique_ptr<MainWindow> window_;

  private slots:
    void initTestCase() { window_ = openWindow(); }

    void everythingInTheWindowHasAName() {
        for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) dock->show();
        for (const Item item : {kBall, Item::of(LightId{1}), Item::of(CameraId{0})}) {
            window_->selection().set({item});
            QCoreApplication::processEvents();
            const QStringList found = nameless(*window_);
            QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
            const QStringList far = unreachable(*window_);
            QVERIFY2(far.isEmpty(), qPrintable(far.join('\n')));
        }
    }
    void everythingInDialogsHasAName() {
        for (const char* id :
             {"file.export", "edit.preferences", "help.shortcuts", "render.errorReport"}) {
            window_->actions()[id]->trigger();
            QCoreApplication::processEvents();
            for (QDialog* dialog : window_->findChildren<QDialog*>()) {
                const QStringList found = nameless(*dialog);
                QVERIFY2(found.isEmpty(), qPrintable(QString(id) + ":\n" + found.join('\n')));
                dialog->close();
            }
        }
        window_->showStartPage();
        QCoreApplication::processEvents();
        QVERIFY2(nameless(*window_).isEmpty(), qPrintable(nameless(*window_).join('\n')));
    }
    void theCheckFindsWhatHasNoName() {
        QWidget bare;
        auto* line = new QLineEdit(&bare);
        QCOMPARE(nameless(bare).size(), 1);
        line->setAccessibleName("Name");
        QVERIFY(nameless(bare).isEmpty());
        line->setFocusPolicy(Qt::NoFocus);
        QCOMPARE(unreachable(bare).size(), 1);
    }
    void everyActionHasAPlaceToBeFound() {
        for (const QAction* action : window_->actions().all()) {
            QVERIFY2(!Actions::plainText(action).isEmpty(), qPrintable(action->objectName()));
            QVERIFY2(!action->statusTip().isEmpty(), qPrintable(action->objectName()));
        }
    }
};

}  // namespace glint

QTEST_MAIN(glint::AccessibleTest)
#include "accessible_test.moc"
