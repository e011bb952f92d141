// Which action calls which command: the Edit menu's, the view's, the tools'.
#pragma once

class QUndoStack;
class QWidget;

namespace glint {

class Actions;
class CommandSearch;
class EditController;
class ObjectList;
class RenderView;
class Selection;
class ViewCommands;

/// Undo and redo, named by what they take back, and the edits of the selection. With nothing
/// selected, copy copies the picture.
void bindEditCommands(Actions& actions, EditController& edits, QUndoStack& stack,
                      Selection& selection, ObjectList& objects);
/// Moves of the view, overlays, exposure.
void bindViewCommands(Actions& actions, ViewCommands& views, EditController& edits,
                      RenderView& picture);
/// The tools of the view, of which one is chosen, and snapping.
void bindTools(Actions& actions, RenderView& picture);
/// The sheet of shortcuts, the search for commands, and what this program is.
void bindHelp(Actions& actions, CommandSearch& search, QWidget& window);
/// Ctrl+1 to 9 go to a saved view, with Shift they store it; for as long as `window` lives.
void bindSavedViews(QWidget& window, ViewCommands& views);

}  // namespace glint
