#include "gui/app/actions.h"

#include <QMenu>
#include <QRegularExpression>
#include <QSettings>
#include <QWidget>

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

#define T(text) QT_TRANSLATE_NOOP("Actions", text)
constexpr ActionRow kRows[] = {
    {"file.new", T("&New"), "Ctrl+N", "new", T("Start a new scene")},
    {"file.startPage", T("S&tart page"), "", "grid", T("Templates, demos and recent files")},
    {"file.open", T("&Open…"), "Ctrl+O", "open", T("Open a scene file")},
    {"file.save", T("&Save"), "Ctrl+S", "save", T("Save the scene")},
    {"file.saveAs", T("Save &as…"), "Ctrl+Shift+S", "", T("Save the scene under another name")},
    {"file.export", T("&Export picture…"), "F12", "export", T("Render the picture to a file in the background")},
    {"file.quit", T("&Quit"), "Ctrl+Q", "", T("Close the window")},

    {"edit.undo", T("&Undo"), "Ctrl+Z", "undo", T("Take back the last edit")},
    {"edit.redo", T("&Redo"), "Ctrl+Shift+Z | Ctrl+Y", "redo", T("Do again what was taken back")},
    {"edit.cut", T("Cu&t"), "Ctrl+X", "", T("Copy the selected objects as text and delete them")},
    {"edit.copy", T("&Copy"), "Ctrl+C", "", T("Copy the selection as text; the picture if nothing is selected")},
    {"edit.paste", T("&Paste"), "Ctrl+V", "", T("Add what is on the clipboard")},
    {"edit.duplicate", T("&Duplicate"), "Ctrl+D", "duplicate", T("Copy the selection; the copy follows the pointer")},
    {"edit.delete", T("De&lete"), "Del | X", "delete", T("Delete the selection")},
    {"edit.selectAll", T("Select &all"), "Ctrl+A", "", T("Select every object and light")},
    {"edit.selectNone", T("Select &none"), "Esc", "", T("Select nothing")},
    {"edit.rename", T("Rena&me"), "F2", "", T("Rename the active item")},
    {"edit.hide", T("&Hide"), "H", "eye-off", T("Hide the selection")},
    {"edit.showAll", T("&Show all"), "Alt+H", "eye", T("Show everything that is hidden")},
    {"edit.group", T("&Group"), "Ctrl+G", "group", T("Put the selection into a new group")},
    {"edit.ungroup", T("U&ngroup"), "Ctrl+Shift+G", "", T("Dissolve the selected groups")},
    {"edit.preferences", T("Pre&ferences…"), "Ctrl+,", "settings", T("Theme, language, threads, navigation, shortcuts")},

    {"tool.select", T("&Select"), "Q", "select", T("Select only"), true},
    {"tool.move", T("&Move"), "W", "move", T("Move the selection"), true},
    {"tool.rotate", T("&Rotate"), "E", "rotate", T("Turn the selection"), true},
    {"tool.scale", T("S&cale"), "R", "scale", T("Scale the selection"), true},
    {"tool.snap", T("S&nap"), "", "snap", T("Snap to steps; Ctrl while dragging does the opposite"), true},

    {"view.frameSelected", T("&Frame selected"), "F | .", "frame", T("Bring the selection into view")},
    {"view.frameAll", T("Frame &all"), "Home | A", "", T("Bring everything into view")},
    {"view.front", T("Front"), "Num+1", "", T("Look along −z")},
    {"view.behind", T("Back"), "Ctrl+Num+1", "", T("Look along +z")},
    {"view.right", T("Right"), "Num+3", "", T("Look along −x")},
    {"view.left", T("Left"), "Ctrl+Num+3", "", T("Look along +x")},
    {"view.top", T("Top"), "Num+7", "", T("Look down")},
    {"view.bottom", T("Bottom"), "Ctrl+Num+7", "", T("Look up")},
    {"view.projection", T("&Perspective / orthographic"), "Num+5", "", T("Switch the projection, keeping sizes at the target")},
    {"view.camera", T("Look through &camera"), "Num+0", "camera", T("Make the selected camera the active one")},
    {"view.previous", T("Pre&vious view"), "Alt+Left", "", T("Where the view was before")},
    {"view.next", T("Ne&xt view"), "Alt+Right", "", T("Go forward again")},
    {"view.overlay", T("&Overlay"), "Shift+Alt+Z", "", T("Show outlines, handles and marks over the picture"), true},
    {"view.grid", T("&Grid"), "G", "grid", T("Show the ground grid"), true},
    {"view.darker", T("&Darker"), "[", "", T("Half a stop less exposure")},
    {"view.brighter", T("&Brighter"), "]", "", T("Half a stop more exposure")},

    {"render.pause", T("&Pause"), "Space", "pause", T("Stop rendering and keep the samples"), true},
    {"render.errorReport", T("E&rror report…"), "", "", T("Measure how the error of this scene falls with time")},
    {"render.copy", T("&Copy picture"), "Ctrl+Shift+C", "image", T("Copy the picture as it is shown")},

    {"window.light", T("&Light theme"), "", "", T("Switch between dark and light"), true},

    {"help.shortcuts", T("&Shortcuts"), "F1", "keyboard", T("Show all mouse and keyboard shortcuts")},
    {"help.search", T("&Find a command…"), "F3", "search", T("Search all commands by name")},
    {"help.about", T("&About Glint"), "", "", T("Version and licence")},
    {"add.menu", T("&Add…"), "Shift+A", "add", T("Add something at the pointer")},
};
#undef T

QList<QKeySequence> sequences(const char* keys) {
    QList<QKeySequence> out;
    for (const QString& key : QString::fromLatin1(keys).split(" | ", Qt::SkipEmptyParts)) out << QKeySequence(key, QKeySequence::PortableText);
    return out;
}

}  // namespace

namespace {

QString settingOf(const QString& id) { return "shortcuts/" + id; }

/// What the person chose for the action, else the table's keys.
QList<QKeySequence> keptKeys(Memory memory, const ActionRow& row) {
    if (memory == Memory::None) return sequences(row.keys);
    const QVariant kept = QSettings().value(settingOf(row.id));
    return kept.isValid() ? sequences(kept.toString().toLatin1().constData()) : sequences(row.keys);
}

void showKeysInTip(QAction* action) {
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    action->setToolTip(key.isEmpty() ? action->statusTip() : QStringLiteral("%1 (%2)").arg(action->statusTip(), key));
}

}  // namespace

Actions::Actions(QWidget* window, Memory memory) : QObject(window), memory_(memory) {
    for (const ActionRow& row : kRows) {
        auto* action = new QAction(tr(row.text), this);
        action->setObjectName(row.id);
        action->setShortcuts(keptKeys(memory, row));
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
    if (memory_ == Memory::Settings) QSettings().setValue(settingOf(action->objectName()), keys.toString(QKeySequence::PortableText));
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
    if (group == "view") return tr("View");
    if (group == "render") return tr("Render");
    return tr("Window and help");
}

void Actions::fill(QMenu* menu, std::initializer_list<const char*> ids) const {
    for (const char* id : ids) {
        if (*id == '-') menu->addSeparator();
        else menu->addAction((*this)[id]);
    }
}

}  // namespace glint
