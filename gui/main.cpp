// glint: the editor. `glint [scene]`.
#include <QApplication>
#include <QCommandLineParser>
#include <QScreen>
#include <QTimer>
#include <cstdio>
#include <optional>

#include "gui/app/file_reading.h"
#include "gui/app/main_window.h"
#include "gui/app/text.h"
#include "gui/viewport/render_view.h"
#include "tracer/base/heap.h"

namespace {

/// Saves a picture of the window some time after its start and quits: for looking at the editor
/// without a person.
void takeScreenshotLater(QWidget* window, const QString& file, int milliseconds) {
    QTimer::singleShot(milliseconds, window, [window, file] {
        QCoreApplication::exit(window->grab().save(file) ? 0 : 3);
    });
}

/// Says on standard output that the first picture of the scene has been drawn, and quits: for
/// measuring the start.
void sayFirstPicture(glint::MainWindow& window) {
    // Queued: when it is said, the picture has been handed to the screen.
    QObject::connect(
        &window.view(), &glint::RenderView::pictureShown, &window,
        [] {
            std::puts("first picture");
            std::fflush(stdout);
            QCoreApplication::quit();
        },
        Qt::QueuedConnection);
}

/// Theme and language of a screenshot; nothing of it is kept.
void dress(glint::MainWindow& window, bool light, const QString& language) {
    glint::PreferenceValues values = window.preferences().values();
    values.theme = light ? glint::Theme::Light : glint::Theme::Dark;
    values.language = language == "zh" ? glint::Language::Chinese : glint::Language::English;
    window.preferences().set(values);
}

/// The size of a first start: large, but with its frame inside the screen.
void fitToScreen(QWidget& window) {
    constexpr QSize kWanted(1440, 900), kFrame(16, 48);
    window.resize(kWanted.boundedTo(QGuiApplication::primaryScreen()->availableSize() - kFrame));
}

void selectByName(glint::MainWindow& window, const QString& name) {
    window.document().scene().objects.forEach([&](glint::ObjectId id, const glint::Object& object) {
        if (glint::toQString(object.name) == name) window.selection().set({glint::Item::of(id)});
    });
}

}  // namespace

int main(int argc, char** argv) {
    glint::keepFreedMemory();
    QApplication app(argc, argv);
    QApplication::setApplicationName("glint");
    QApplication::setOrganizationName("glint");
    QApplication::setApplicationVersion(GLINT_VERSION);

    QCommandLineParser parser;
    parser.setApplicationDescription(
        QApplication::translate("main", "Scene editor whose viewport is a ray tracer."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument("scene", QApplication::translate("main", "Scene file to open."),
                                 "[scene]");
    QCommandLineOption screenshot("screenshot", {}, "file"), after("after", {}, "ms", "2000"),
        size("size", {}, "WxH"), light("light"), language("language", {}, "code"),
        select("select", {}, "name"), firstPicture("first-picture");
    for (QCommandLineOption* option :
         {&screenshot, &after, &size, &light, &language, &select, &firstPicture}) {
        option->setFlags(QCommandLineOption::HiddenFromHelp);
        parser.addOption(*option);
    }
    parser.process(app);

    std::optional<glint::FileReading> scene;
    if (const QStringList files = parser.positionalArguments(); !files.isEmpty())
        scene = glint::readInBackground(glint::toPath(files.first()));
    const bool visit = parser.isSet(screenshot);
    glint::MainWindow window(visit ? glint::Memory::None : glint::Memory::Settings, scene);
    if (visit) dress(window, parser.isSet(light), parser.value(language));
    const QStringList wanted = parser.value(size).split('x');
    if (wanted.size() == 2)
        window.resize(wanted[0].toInt(), wanted[1].toInt());
    else if (visit)
        window.resize(1440, 900);
    else if (window.width() < 900)
        fitToScreen(window);
    if (!scene && window.preferences().values().startPage) window.showStartPage();
    window.show();
    if (const QString selected = parser.value(select); !selected.isEmpty()) {
        selectByName(window, selected);
        QObject::connect(&window.document(), &glint::Document::replaced, &window,
                         [&window, selected] { selectByName(window, selected); });
    }
    if (parser.isSet(firstPicture)) sayFirstPicture(window);
    if (visit) takeScreenshotLater(&window, parser.value(screenshot), parser.value(after).toInt());
    return QApplication::exec();
}
