// glint: the editor. `glint [scene]`.
#include <QApplication>
#include <QCommandLineParser>
#include <QScreen>
#include <QTimer>
#include <cstdio>

#include "gui/app/file_controller.h"
#include "gui/app/main_window.h"
#include "gui/app/renderer.h"
#include "gui/app/text.h"
#include "gui/viewport/render_view.h"
#include "tracer/base/heap.h"

namespace {

/// Saves a picture of the window some time after its start and quits: for looking at the editor without a person.
void takeScreenshotLater(QWidget* window, const QString& file, int milliseconds) {
    QTimer::singleShot(milliseconds, window, [window, file] { QCoreApplication::exit(window->grab().save(file) ? 0 : 3); });
}

/// Says on standard output that the first picture of the scene has been drawn, and quits: for measuring the start.
class FirstPicture : public QObject {
  public:
    explicit FirstPicture(glint::MainWindow& window) : QObject(&window), window_(window) { window.view().installEventFilter(this); }

    bool eventFilter(QObject*, QEvent* event) override {
        // Queued: when it is said, the picture has been handed to the screen.
        if (event->type() == QEvent::Paint && window_.renderer().frame()) QMetaObject::invokeMethod(this, &FirstPicture::say, Qt::QueuedConnection);
        return false;
    }

  private:
    void say() {
        std::puts("first picture");
        std::fflush(stdout);
        QCoreApplication::quit();
    }

    glint::MainWindow& window_;
};

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
    parser.setApplicationDescription(QApplication::translate("main", "Scene editor whose viewport is a ray tracer."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument("scene", QApplication::translate("main", "Scene file to open."), "[scene]");
    QCommandLineOption screenshot("screenshot", {}, "file"), after("after", {}, "ms", "2000"), size("size", {}, "WxH"),
        light("light"), language("language", {}, "code"), select("select", {}, "name"), firstPicture("first-picture");
    for (QCommandLineOption* option : {&screenshot, &after, &size, &light, &language, &select, &firstPicture}) {
        option->setFlags(QCommandLineOption::HiddenFromHelp);
        parser.addOption(*option);
    }
    parser.process(app);

    const bool visit = parser.isSet(screenshot);
    glint::MainWindow window(visit ? glint::Memory::None : glint::Memory::Settings);
    if (visit) dress(window, parser.isSet(light), parser.value(language));
    const QStringList wanted = parser.value(size).split('x');
    if (wanted.size() == 2) window.resize(wanted[0].toInt(), wanted[1].toInt());
    else if (visit) window.resize(1440, 900);
    else if (window.width() < 900) fitToScreen(window);
    if (!parser.positionalArguments().isEmpty()) window.files().load(glint::toPath(parser.positionalArguments().first()));
    else if (window.preferences().values().startPage) window.showStartPage();
    window.show();
    const QString selected = parser.value(select);
    if (!selected.isEmpty()) QObject::connect(&window.document(), &glint::Document::replaced, &window, [&window, selected] { selectByName(window, selected); });
    if (parser.isSet(firstPicture)) new FirstPicture(window);
    if (visit) takeScreenshotLater(&window, parser.value(screenshot), parser.value(after).toInt());
    return QApplication::exec();
}
