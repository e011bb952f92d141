// glint: the editor. `glint [scene]`.
#include <QApplication>
#include <QCommandLineParser>
#include <QTimer>

#include "gui/app/file_controller.h"
#include "gui/app/main_window.h"
#include "gui/app/text.h"

namespace {

/// Saves a picture of the window some time after its start and quits: for looking at the editor without a person.
void takeScreenshotLater(QWidget* window, const QString& file, int milliseconds) {
    QTimer::singleShot(milliseconds, window, [window, file] { QCoreApplication::exit(window->grab().save(file) ? 0 : 3); });
}

}  // namespace

int main(int argc, char** argv) {
    QApplication app(argc, argv);
    QApplication::setApplicationName("glint");
    QApplication::setOrganizationName("glint");
    QApplication::setApplicationVersion(GLINT_VERSION);

    QCommandLineParser parser;
    parser.setApplicationDescription(QApplication::translate("main", "Scene editor whose viewport is a ray tracer."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument("scene", QApplication::translate("main", "Scene file to open."), "[scene]");
    QCommandLineOption screenshot("screenshot", {}, "file"), after("after", {}, "ms", "2000"), size("size", {}, "WxH");
    for (QCommandLineOption* option : {&screenshot, &after, &size}) {
        option->setFlags(QCommandLineOption::HiddenFromHelp);
        parser.addOption(*option);
    }
    parser.process(app);

    const bool visit = parser.isSet(screenshot);
    glint::MainWindow window(visit ? glint::Memory::None : glint::Memory::Settings);
    const QStringList wanted = parser.value(size).split('x');
    if (wanted.size() == 2) window.resize(wanted[0].toInt(), wanted[1].toInt());
    else if (visit || window.width() < 900) window.resize(1440, 900);
    if (!parser.positionalArguments().isEmpty()) window.files().load(glint::toPath(parser.positionalArguments().first()));
    else if (window.preferences().values().startPage) window.showStartPage();
    window.show();
    if (visit) takeScreenshotLater(&window, parser.value(screenshot), parser.value(after).toInt());
    return QApplication::exec();
}
