// ShortcutSheet: all mouse and keyboard shortcuts on one page (F1).
#pragma once

#include <QDialog>

namespace glint {

class Actions;

class ShortcutSheet : public QDialog {
    Q_OBJECT

  public:
    ShortcutSheet(const Actions& actions, QWidget* parent);
};

}  // namespace glint
