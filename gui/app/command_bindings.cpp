#include "gui/app/command_bindings.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QMessageBox>
#include <QShortcut>
#include <QUndoStack>

#include "gui/app/actions.h"
#include "gui/app/command_search.h"
#include "gui/app/edit_controller.h"
#include "gui/app/selection.h"
#include "gui/app/shortcut_sheet.h"
#include "gui/panels/object_list.h"
#include "gui/viewport/render_view.h"
#include "gui/viewport/view_commands.h"

namespace glint {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(CommandBindings)
};

void bindUndo(Actions& actions, QUndoStack& stack) {
    QAction* undo = actions["edit.undo"];
    QAction* redo = actions["edit.redo"];
    actions.on("edit.undo", &stack, &QUndoStack::undo);
    actions.on("edit.redo", &stack, &QUndoStack::redo);
    const auto update = [undo, redo, steps = &stack] {
        undo->setEnabled(steps->canUndo());
        redo->setEnabled(steps->canRedo());
        undo->setText(steps->canUndo() ? Text::tr("&Undo %1").arg(steps->undoText())
                                       : Text::tr("&Undo"));
        redo->setText(steps->canRedo() ? Text::tr("&Redo %1").arg(steps->redoText())
                                       : Text::tr("&Redo"));
    };
    QObject::connect(&stack, &QUndoStack::indexChanged, &actions, update);
    QObject::connect(&stack, &QUndoStack::undoTextChanged, &actions, update);
    update();
}

}  // namespace

void bindEditCommands(Actions& actions, EditController& edits, QUndoStack& stack,
                      Selection& selection, ObjectList& objects) {
    bindUndo(actions, stack);
    actions.on("edit.cut", &edits, &EditController::cut);
    actions.on("edit.copy", &edits,
               [&] { selection.isEmpty() ? actions["render.copy"]->trigger() : edits.copy(); });
    actions.on("edit.paste", &edits, &EditController::paste);
    actions.on("edit.duplicate", &edits, &EditController::duplicate);
    actions.on("edit.delete", &edits, &EditController::remove);
    actions.on("edit.selectAll", &edits, &EditController::selectAll);
    actions.on("edit.selectNone", &selection, &Selection::clear);
    actions.on("edit.rename", &objects, &ObjectList::renameActive);
    actions.on("edit.hide", &edits, &EditController::hideSelected);
    actions.on("edit.hideRest", &edits, &EditController::hideRest);
    actions.on("edit.showAll", &edits, &EditController::showAll);
    actions.on("edit.group", &edits, &EditController::group);
    actions.on("edit.ungroup", &edits, &EditController::ungroup);
}

void bindViewCommands(Actions& actions, ViewCommands& views, EditController& edits,
                      RenderView& picture) {
    actions.on("view.frameSelected", &views, &ViewCommands::frameSelected);
    actions.on("view.frameAll", &views, &ViewCommands::frameAll);
    const std::pair<const char*, DVec3> directions[] = {
        {"view.front", {0, 0, -1}}, {"view.behind", {0, 0, 1}}, {"view.right", {-1, 0, 0}},
        {"view.left", {1, 0, 0}},   {"view.top", {0, -1, 0}},   {"view.bottom", {0, 1, 0}}};
    for (const auto& [id, direction] : directions)
        actions.on(id, &views, [&views, direction = direction] { views.lookAlong(direction); });
    actions.on("view.projection", &views, &ViewCommands::toggleProjection);
    actions.on("view.previous", &views, &ViewCommands::back);
    actions.on("view.next", &views, &ViewCommands::forward);
    actions.on("view.camera", &edits, &EditController::lookThroughSelectedCamera);
    actions.on("view.overlay", &picture, &RenderView::setOverlayShown);
    actions.on("view.grid", &picture, &RenderView::setGridShown);
    actions["view.overlay"]->setChecked(picture.isOverlayShown());
    actions["view.grid"]->setChecked(picture.isGridShown());
    actions.on("render.inspect", &picture,
               [&picture] { picture.inspect(picture.pointerOrCenter()); });
    constexpr double kHalfStop = 0.5;
    actions.on("view.darker", &edits, [&edits] { edits.changeExposure(-kHalfStop); });
    actions.on("view.brighter", &edits, [&edits] { edits.changeExposure(kHalfStop); });
}

void bindTools(Actions& actions, RenderView& picture) {
    auto* group = new QActionGroup(&actions);
    const std::pair<const char*, Tool> tools[] = {{"tool.select", Tool::Select},
                                                  {"tool.move", Tool::Move},
                                                  {"tool.rotate", Tool::Rotate},
                                                  {"tool.scale", Tool::Scale}};
    for (const auto& [id, tool] : tools) {
        group->addAction(actions[id]);
        actions[id]->setChecked(picture.tools().tool == tool);
        actions.on(id, &picture, [&picture, tool = tool] {
            ToolOptions options = picture.tools();
            options.tool = tool;
            picture.setTools(options);
        });
    }
    actions["tool.snap"]->setChecked(picture.tools().snap);
    actions.on("tool.snap", &picture, [&picture](bool on) {
        ToolOptions options = picture.tools();
        options.snap = on;
        picture.setTools(options);
    });
}

void bindHelp(Actions& actions, CommandSearch& search, QWidget& window) {
    actions.on("help.shortcuts", &window, [&] { (new ShortcutSheet(actions, &window))->show(); });
    actions.on("help.search", &search, &CommandSearch::open);
    actions.on("help.about", &window, [&window] {
        auto* box = new QMessageBox(
            QMessageBox::Information, Text::tr("About Glint"),
            Text::tr("Glint %1\nA scene editor whose viewport is a ray tracer.\nMIT licence.")
                .arg(GLINT_VERSION),
            QMessageBox::Ok, &window);
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->setModal(false);
        box->show();
    });
}

void bindSavedViews(QWidget& window, ViewCommands& views) {
    for (int number = 1; number <= ViewCommands::kSavedViews; ++number) {
        const auto key = static_cast<Qt::Key>(Qt::Key_0 + number);
        auto* go = new QShortcut(QKeySequence(Qt::CTRL | key), &window);
        auto* store = new QShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | key), &window);
        QObject::connect(go, &QShortcut::activated, &views,
                         [&views, number] { views.goToSavedView(number); });
        QObject::connect(store, &QShortcut::activated, &views,
                         [&views, number] { views.storeView(number); });
    }
}

}  // namespace glint
