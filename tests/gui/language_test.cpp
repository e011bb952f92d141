// Every word a person reads is there in English and in Chinese, and changes while the program runs.
#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>

#include "gui/app/actions.h"
#include "gui/app/material_presets.h"
#include "gui/app/preferences.h"
#include "gui/app/preferences_dialog.h"
#include "gui/app/shortcut_sheet.h"
#include "gui/panels/property_panel.h"
#include "support.h"

namespace glint {

using namespace test;

namespace {

const QString kTranslation =
    QStringLiteral(GLINT_SOURCE_DIR "/resources/translations/glint_zh_CN.ts");

void speak(MainWindow& window, Language language) {
    PreferenceValues values = window.preferences().values();
    values.language = language;
    window.preferences().set(values);
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
}

bool isEnglish(const QString& text) {
    static const QRegularExpression word(QStringLiteral("[A-Za-z]{3,}")),
        chinese(QStringLiteral("[\\x{4e00}-\\x{9fff}]"));
    return text.contains(word) && !text.contains(chinese);
}

/// What is no word of the program: names in the scene, files, languages, and terms that stay as
/// they are.
bool mayBeEnglish(const QString& text) {
    static const QRegularExpression plain(
        QStringLiteral("^(Glint|English|Ball|Key|White|Phong|sRGB|path: "
                       ".*|[a-z_]+\\.exr|.*/.*|(Ctrl|Shift|Alt|Num|Home|Del|Esc|Space)\\b.*|Scroll "
                       "Left|Scroll Right|overcast|room|sky|studio|sunset|qt_.*)$"));
    return plain.match(text.trimmed()).hasMatch();
}

QStringList textsOf(const QWidget& widget) {
    QStringList out{widget.toolTip(), widget.accessibleName()};
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) out << label->text();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) out << button->text();
    if (const auto* dock = qobject_cast<const QDockWidget*>(&widget)) out << dock->windowTitle();
    if (const auto* combo = qobject_cast<const QComboBox*>(&widget))
        for (int i = 0; i < combo->count(); ++i) out << combo->itemText(i);
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) out << line->placeholderText();
    return out;
}

QStringList englishIn(const QWidget& window) {
    QStringList out;
    const auto check = [&](const QString& text, const QObject* where) {
        if (isEnglish(text) && !mayBeEnglish(text))
            out << text + " (" + where->metaObject()->className() + ' ' + where->objectName() + ')';
    };
    for (const QWidget* widget : window.findChildren<QWidget*>())
        for (const QString& text : textsOf(*widget)) check(text, widget);
    for (const QAction* action : window.findChildren<QAction*>())
        for (const QString& text : {action->text(), action->toolTip(), action->statusTip()})
            check(text, action);
    out.removeDuplicates();
    return out;
}

}  // namespace

class LanguageTest : public QObject {
    Q_OBJECT

  private slots:
    void cleanup() { applyLanguage(Language::English); }

    void noTranslationIsUnfinished() {
        QFile file(kTranslation);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(file.readAll());
        QVERIFY(text.count("<message") > 400);
        QVERIFY(!text.contains("unfinished"));
        QVERIFY(!text.contains("<translation></translation>"));
    }
    void englishKnowsSingularAndPlural() {
        QFile english(QStringLiteral(GLINT_SOURCE_DIR "/resources/translations/glint_en.ts")),
            chinese(kTranslation);
        QVERIFY(english.open(QIODevice::ReadOnly) && chinese.open(QIODevice::ReadOnly));
        // What depends on a number is in both files.
        QCOMPARE(english.readAll().count("numerus=\"yes\""),
                 chinese.readAll().count("numerus=\"yes\""));
        applyLanguage(Language::English);
        QCOMPARE(QCoreApplication::translate("glint::StatusLine", "%n warning(s)", nullptr, 1),
                 QStringLiteral("1 warning"));
        QCOMPARE(QCoreApplication::translate("glint::StatusLine", "%n warning(s)", nullptr, 2),
                 QStringLiteral("2 warnings"));
    }
    void everyWidgetSpeaksChinese() {
        Scene scene = smallScene();
        const auto window = openWindow(scene);
        speak(*window, Language::Chinese);
        const Item items[] = {kBall, Item::of(LightId{1}), {ItemKind::Camera, 0}};
        for (const Item item : items) {
            window->selection().set({item});
            QCoreApplication::processEvents();
            const QStringList english = englishIn(*window);
            QVERIFY2(english.isEmpty(), qPrintable(english.join('\n')));
        }
    }
    void everyTypeOfThingHasChineseFields() {
        const auto window = openWindow();
        speak(*window, Language::Chinese);
        const auto show = [&](Scene scene, Item item) {
            window->document().edit(std::move(scene), "test");
            window->selection().set({item});
            const QStringList english = englishIn(window->properties());
            QVERIFY2(english.isEmpty(), qPrintable(english.join('\n')));
        };
        AllShapes::forEach([&](const auto& shape) {
            Scene scene = window->document().scene();
            Object ball = scene.objects.at(ObjectId{1});
            ball.shape = shape;
            scene.objects.set(ObjectId{1}, ball);
            show(scene, kBall);
        });
        AllMaterials::forEach([&](const auto& material) {
            Scene scene = window->document().scene();
            scene.materials.set(MaterialId{1}, {"White", material});
            show(scene, kBall);
        });
        AllLights::forEach([&](const auto& light) {
            Scene scene = window->document().scene();
            scene.lights.set(LightId{1}, {"Key", light, true, {}});
            show(scene, Item::of(LightId{1}));
        });
    }
    void presetsHaveChineseNames() {
        applyLanguage(Language::Chinese);
        for (const MaterialPreset& preset : materialPresets()) {
            QVERIFY2(!isEnglish(presetText(preset.name)), qPrintable(preset.name));
            QVERIFY2(!isEnglish(presetText(preset.category)), qPrintable(preset.category));
        }
    }
    void dialogsSpeakChinese() {
        const auto window = openWindow();
        speak(*window, Language::Chinese);
        window->actions()["edit.preferences"]->trigger();
        const auto* dialog = window->findChild<PreferencesDialog*>();
        QVERIFY(dialog);
        const QStringList english = englishIn(*dialog);
        QVERIFY2(english.isEmpty(), qPrintable(english.join('\n')));
    }
    void switchingKeepsTheWorkAndGoesBack() {
        const auto window = openWindow();
        window->selection().set({kBall});
        Scene scene = window->document().scene();
        scene.display.exposureEv = 1;
        window->document().edit(scene, "test");
        const Scene before = window->document().scene();
        speak(*window, Language::Chinese);
        QCOMPARE(window->menuBar()->actions().front()->text(), QStringLiteral("文件(&F)"));
        QVERIFY(window->document().scene() == before);
        QVERIFY(window->document().undoStack().canUndo());
        QCOMPARE(window->selection().items(), std::vector<Item>{kBall});
        speak(*window, Language::English);
        QCOMPARE(window->menuBar()->actions().front()->text(), QStringLiteral("&File"));
        QVERIFY(window->actions()["edit.undo"]->isEnabled());
        window->actions()["edit.undo"]->trigger();
        QCOMPARE(window->document().scene().display.exposureEv, 0.0);
    }
};

}  // namespace glint

QTEST_MAIN(glint::LanguageTest)
#include "language_test.moc"
