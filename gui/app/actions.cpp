#include "gui/app/actions.h"

#include <QMenu>
#include <QRegularExpression>
#include <QSettings>
#include <QWidget>
#include <optional>

#include "gui/widgets/icons.h"
#include "tracer/base/check.h"

namespace glint {

namespace {

struct ActionRow {
    const char* id;  ///< "group.name"
    const char* text;
    const char* keys;  ///< portable text, alternatives split by " | "
    const char* icon;  ///< empty: none
    const char* tip;
    bool checkable = false;
};

constexpr ActionRow kRows[] = {
    {"file.new", QT_TRANSLATE_NOOP("glint::Actions", "&New"), "Ctrl+N", "new",
     QT_TRANSLATE_NOOP("glint::Actions", "Start a new scene")},
    {"file.startPage", QT_TRANSLATE_NOOP("glint::Actions", "S&tart page"), "", "grid",
     QT_TRANSLATE_NOOP("glint::Actions", "Templates, demos and recent files")},
    {"file.open", QT_TRANSLATE_NOOP("glint::Actions", "&Open…"), "Ctrl+O", "open",
     QT_TRANSLATE_NOOP("glint::Actions", "Open a scene file")},
    {"file.save", QT_TRANSLATE_NOOP("glint::Actions", "&Save"), "Ctrl+S", "save",
     QT_TRANSLATE_NOOP("glint::Actions", "Save the scene")},
    {"file.saveAs", QT_TRANSLATE_NOOP("glint::Actions", "Save &as…"), "Ctrl+Shift+S", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Save the scene under another name")},
    {"file.export", QT_TRANSLATE_NOOP("glint::Actions", "&Export picture…"), "F12", "export",
     QT_TRANSLATE_NOOP("glint::Actions", "Render the picture to a file in the background")},
    {"file.quit", QT_TRANSLATE_NOOP("glint::Actions", "&Quit"), "Ctrl+Q", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Close the window")},

    {"edit.undo", QT_TRANSLATE_NOOP("glint::Actions", "&Undo"), "Ctrl+Z", "undo",
     QT_TRANSLATE_NOOP("glint::Actions", "Take back the last edit")},
    {"edit.redo", QT_TRANSLATE_NOOP("glint::Actions", "&Redo"), "Ctrl+Shift+Z | Ctrl+Y", "redo",
     QT_TRANSLATE_NOOP("glint::Actions", "Do again what was taken back")},
    {"edit.cut", QT_TRANSLATE_NOOP("glint::Actions", "Cu&t"), "Ctrl+X", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Copy the selected objects as text and delete them")},
    {"edit.copy", QT_TRANSLATE_NOOP("glint::Actions", "&Copy"), "Ctrl+C", "",
     QT_TRANSLATE_NOOP("glint::Actions",
                       "Copy the selection as text; the picture if nothing is selected")},
    {"edit.paste", QT_TRANSLATE_NOOP("glint::Actions", "&Paste"), "Ctrl+V", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Add what is on the clipboard")},
    {"edit.duplicate", QT_TRANSLATE_NOOP("glint::Actions", "&Duplicate"), "Ctrl+D", "duplicate",
     QT_TRANSLATE_NOOP("glint::Actions", "Copy the selection; the copy follows the pointer")},
    {"edit.delete", QT_TRANSLATE_NOOP("glint::Actions", "De&lete"), "Del | X", "delete",
     QT_TRANSLATE_NOOP("glint::Actions", "Delete the selection")},
    {"edit.selectAll", QT_TRANSLATE_NOOP("glint::Actions", "Select &all"), "Ctrl+A", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Select every object and light")},
    {"edit.selectNone", QT_TRANSLATE_NOOP("glint::Actions", "Select &none"), "Esc", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Select nothing")},
    {"edit.rename", QT_TRANSLATE_NOOP("glint::Actions", "Rena&me"), "F2", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Rename the active item")},
    {"edit.hide", QT_TRANSLATE_NOOP("glint::Actions", "&Hide"), "H", "eye-off",
     QT_TRANSLATE_NOOP("glint::Actions", "Hide the selection")},
    {"edit.hideRest", QT_TRANSLATE_NOOP("glint::Actions", "Hide the &rest"), "Shift+H", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Hide every object but the selected ones")},
    {"edit.showAll", QT_TRANSLATE_NOOP("glint::Actions", "&Show all"), "Alt+H", "eye",
     QT_TRANSLATE_NOOP("glint::Actions", "Show everything that is hidden")},
    {"edit.group", QT_TRANSLATE_NOOP("glint::Actions", "&Group"), "Ctrl+G", "group",
     QT_TRANSLATE_NOOP("glint::Actions", "Put the selection into a new group")},
    {"edit.ungroup", QT_TRANSLATE_NOOP("glint::Actions", "U&ngroup"), "Ctrl+Shift+G", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Dissolve the selected groups")},
    {"edit.preferences", QT_TRANSLATE_NOOP("glint::Actions", "Pre&ferences…"), "Ctrl+,", "settings",
     QT_TRANSLATE_NOOP("glint::Actions", "Theme, language, threads, navigation, shortcuts")},

    {"tool.select", QT_TRANSLATE_NOOP("glint::Actions", "&Select"), "Q", "select",
     QT_TRANSLATE_NOOP("glint::Actions", "Select only"), true},
    {"tool.move", QT_TRANSLATE_NOOP("glint::Actions", "&Move"), "W", "move",
     QT_TRANSLATE_NOOP("glint::Actions", "Move the selection"), true},
    {"tool.rotate", QT_TRANSLATE_NOOP("glint::Actions", "&Rotate"), "E", "rotate",
     QT_TRANSLATE_NOOP("glint::Actions", "Turn the selection"), true},
    {"tool.scale", QT_TRANSLATE_NOOP("glint::Actions", "S&cale"), "R", "scale",
     QT_TRANSLATE_NOOP("glint::Actions", "Scale the selection"), true},
    {"tool.snap", QT_TRANSLATE_NOOP("glint::Actions", "S&nap"), "", "snap",
     QT_TRANSLATE_NOOP("glint::Actions", "Snap to steps; Ctrl while dragging does the opposite"),
     true},

    {"view.frameSelected", QT_TRANSLATE_NOOP("glint::Actions", "&Frame selected"), "F | .", "frame",
     QT_TRANSLATE_NOOP("glint::Actions", "Bring the selection into view")},
    {"view.frameAll", QT_TRANSLATE_NOOP("glint::Actions", "Frame &all"), "Home | A", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Bring everything into view")},
    {"view.front", QT_TRANSLATE_NOOP("glint::Actions", "Front"), "Num+1", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Look along −z")},
    {"view.behind", QT_TRANSLATE_NOOP("glint::Actions", "Back"), "Ctrl+Num+1", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Look along +z")},
    {"view.right", QT_TRANSLATE_NOOP("glint::Actions", "Right"), "Num+3", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Look along −x")},
    {"view.left", QT_TRANSLATE_NOOP("glint::Actions", "Left"), "Ctrl+Num+3", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Look along +x")},
    {"view.top", QT_TRANSLATE_NOOP("glint::Actions", "Top"), "Num+7", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Look down")},
    {"view.bottom", QT_TRANSLATE_NOOP("glint::Actions", "Bottom"), "Ctrl+Num+7", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Look up")},
    {"view.projection", QT_TRANSLATE_NOOP("glint::Actions", "&Perspective / orthographic"), "Num+5",
     "", QT_TRANSLATE_NOOP("glint::Actions", "Switch the projection, keeping sizes at the target")},
    {"view.camera", QT_TRANSLATE_NOOP("glint::Actions", "Look through &camera"), "Num+0", "camera",
     QT_TRANSLATE_NOOP("glint::Actions", "Make the selected camera the active one")},
    {"view.previous", QT_TRANSLATE_NOOP("glint::Actions", "Pre&vious view"), "Alt+Left", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Where the view was before")},
    {"view.next", QT_TRANSLATE_NOOP("glint::Actions", "Ne&xt view"), "Alt+Right", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Go forward again")},
    {"view.overlay", QT_TRANSLATE_NOOP("glint::Actions", "&Overlay"), "Shift+Alt+Z", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Show outlines, handles and marks over the picture"),
     true},
    {"view.grid", QT_TRANSLATE_NOOP("glint::Actions", "&Grid"), "G", "grid",
     QT_TRANSLATE_NOOP("glint::Actions", "Show the ground grid"), true},
    {"view.filter", QT_TRANSLATE_NOOP("glint::Actions", "&Filtered"), "Shift+F", "filter",
     QT_TRANSLATE_NOOP("glint::Actions",
                       "Show the picture denoised; samples, error and files stay as they are"),
     true},
    {"view.region", QT_TRANSLATE_NOOP("glint::Actions", "&Region"), "Ctrl+B", "region",
     QT_TRANSLATE_NOOP("glint::Actions",
                       "Mark the only part of the picture that is rendered on; the rest stays")},
    {"view.regionClear", QT_TRANSLATE_NOOP("glint::Actions", "Whole pic&ture"), "Ctrl+Alt+B", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Render the whole picture again")},
    {"view.compare", QT_TRANSLATE_NOOP("glint::Actions", "Before the last &step"), "B", "",
     QT_TRANSLATE_NOOP(
         "glint::Actions",
         "Show the picture as it was before the last step, to compare; press again to come back"),
     true},
    {"view.isolate", QT_TRANSLATE_NOOP("glint::Actions", "Render se&lected only"), "/", "",
     QT_TRANSLATE_NOOP("glint::Actions",
                       "Show the picture with nothing but the selected objects and the lights"),
     true},

    {"render.inspect", QT_TRANSLATE_NOOP("glint::Actions", "&Inspect pixel"), "I", "search",
     QT_TRANSLATE_NOOP(
         "glint::Actions",
         "Explain the pixel under the pointer: its paths and what light they found (Alt+click)")},

    {"channel.beauty", QT_TRANSLATE_NOOP("glint::Actions", "&Beauty"), "Shift+1", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Show the picture"), true},
    {"channel.albedo", QT_TRANSLATE_NOOP("glint::Actions", "&Albedo"), "1", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Show what share of light the surfaces send back"), true},
    {"channel.normal", QT_TRANSLATE_NOOP("glint::Actions", "&Normal"), "2", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Show which way the surfaces face"), true},
    {"channel.depth", QT_TRANSLATE_NOOP("glint::Actions", "&Depth"), "3", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Show how far the surfaces are"), true},
    {"channel.position", QT_TRANSLATE_NOOP("glint::Actions", "&Position"), "4", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Show where the surfaces are"), true},
    {"channel.object", QT_TRANSLATE_NOOP("glint::Actions", "&Objects"), "5", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Show a colour for each object"), true},
    {"channel.material", QT_TRANSLATE_NOOP("glint::Actions", "&Materials"), "6", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Show a colour for each material"), true},
    {"channel.samples", QT_TRANSLATE_NOOP("glint::Actions", "&Samples"), "7", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Show how many samples each pixel has"), true},
    {"channel.error", QT_TRANSLATE_NOOP("glint::Actions", "&Error"), "8", "",
     QT_TRANSLATE_NOOP("glint::Actions",
                       "Show how good each part of the picture is: the 95 % bound of its error"),
     true},
    {"channel.luminance", QT_TRANSLATE_NOOP("glint::Actions", "&Luminance"), "9", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Show brightness in stops from middle grey"), true},

    {"view.darker", QT_TRANSLATE_NOOP("glint::Actions", "&Darker"), "[", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Half a stop less exposure")},
    {"view.brighter", QT_TRANSLATE_NOOP("glint::Actions", "&Brighter"), "]", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Half a stop more exposure")},

    {"render.pause", QT_TRANSLATE_NOOP("glint::Actions", "&Pause"), "Space", "pause",
     QT_TRANSLATE_NOOP("glint::Actions", "Stop rendering and keep the samples"), true},
    {"render.errorReport", QT_TRANSLATE_NOOP("glint::Actions", "E&rror report…"), "", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Measure how the error of this scene falls with time")},
    {"render.copy", QT_TRANSLATE_NOOP("glint::Actions", "&Copy picture"), "Ctrl+Shift+C", "image",
     QT_TRANSLATE_NOOP("glint::Actions", "Copy the picture as it is shown")},

    {"window.light", QT_TRANSLATE_NOOP("glint::Actions", "&Light theme"), "", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Switch between dark and light"), true},

    {"help.shortcuts", QT_TRANSLATE_NOOP("glint::Actions", "&Shortcuts"), "F1", "keyboard",
     QT_TRANSLATE_NOOP("glint::Actions", "Show all mouse and keyboard shortcuts")},
    {"help.search", QT_TRANSLATE_NOOP("glint::Actions", "&Find a command…"), "F3", "search",
     QT_TRANSLATE_NOOP("glint::Actions", "Search all commands by name")},
    {"help.about", QT_TRANSLATE_NOOP("glint::Actions", "&About Glint"), "", "",
     QT_TRANSLATE_NOOP("glint::Actions", "Version and licence")},
    {"add.menu", QT_TRANSLATE_NOOP("glint::Actions", "&Add…"), "Shift+A", "add",
     QT_TRANSLATE_NOOP("glint::Actions", "Add something at the pointer")},
};

QList<QKeySequence> sequences(const char* keys) {
    QList<QKeySequence> out;
    for (const QString& key : QString::fromLatin1(keys).split(" | ", Qt::SkipEmptyParts))
        out << QKeySequence(key, QKeySequence::PortableText);
    return out;
}

}  // namespace

namespace {

QString settingOf(const QString& id) { return "shortcuts/" + id; }

/// What the person chose for the action, else the table's keys.
QList<QKeySequence> keptKeys(const std::optional<QSettings>& settings, const ActionRow& row) {
    if (!settings) return sequences(row.keys);
    const QVariant kept = settings->value(settingOf(row.id));
    return kept.isValid() ? sequences(kept.toString().toLatin1().constData()) : sequences(row.keys);
}

void showKeysInTip(QAction* action) {
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    action->setToolTip(key.isEmpty() ? action->statusTip()
                                     : QStringLiteral("%1 (%2)").arg(action->statusTip(), key));
}

}  // namespace

Actions::Actions(QWidget* window, Memory memory) : QObject(window), memory_(memory) {
    std::optional<QSettings> settings;
    if (memory == Memory::Settings) settings.emplace();
    for (const ActionRow& row : kRows) {
        auto* action = new QAction(tr(row.text), this);
        action->setObjectName(row.id);
        action->setShortcuts(keptKeys(settings, row));
        action->setCheckable(row.checkable);
        if (*row.icon) action->setIcon(icon(row.icon));
        action->setStatusTip(tr(row.tip));
        showKeysInTip(action);
        byId_[row.id] = action;
        ordered_.push_back(action);
        window->addAction(action);
    }
}

QString Actions::plainText(const QAction* action) {
    QString text = action->text().remove(QStringLiteral("…"));
    // "文件(&F)": the mnemonic stands in brackets where letters are not of the alphabet.
    static const QRegularExpression brackets(QStringLiteral("\\(&.\\)"));
    return text.remove(brackets).remove('&');
}

void Actions::setKeys(QAction* action, const QKeySequence& keys) {
    action->setShortcuts(keys.isEmpty() ? QList<QKeySequence>() : QList{keys});
    showKeysInTip(action);
    if (memory_ == Memory::Settings)
        QSettings().setValue(settingOf(action->objectName()),
                             keys.toString(QKeySequence::PortableText));
}

void Actions::resetKeys() {
    for (const ActionRow& row : kRows) {
        QAction* action = (*this)[row.id];
        action->setShortcuts(sequences(row.keys));
        showKeysInTip(action);
        if (memory_ == Memory::Settings) QSettings().remove(settingOf(row.id));
    }
}

const QAction* Actions::userOf(const QKeySequence& keys) const {
    if (keys.isEmpty()) return nullptr;
    for (const QAction* action : ordered_)
        if (action->shortcuts().contains(keys)) return action;
    return nullptr;
}

QAction* Actions::operator[](const char* id) const {
    const auto found = byId_.find(id);
    GLINT_CHECK(found != byId_.end());
    return found->second;
}

QString Actions::groupOf(const QAction* action) {
    const QString group = action->objectName().section('.', 0, 0);
    if (group == "file") return tr("File");
    if (group == "edit" || group == "add") return tr("Edit");
    if (group == "tool") return tr("Tools");
    if (group == "view" || group == "channel") return tr("View");
    if (group == "render") return tr("Render");
    return tr("Window and help");
}

void Actions::fill(QMenu* menu, std::initializer_list<const char*> ids) const {
    for (const char* id : ids) {
        if (*id == '-')
            menu->addSeparator();
        else
            menu->addAction((*this)[id]);
    }
}

}  // namespace glint
