// ShortcutPage: the keys of all commands, to be changed. A key that another command has is refused
// with its name.
#pragma once

#include <QWidget>

class QAction;
class QKeySequenceEdit;
class QLabel;

namespace glint {

class Actions;

class ShortcutPage : public QWidget {
    Q_OBJECT

  public:
    explicit ShortcutPage(Actions& actions, QWidget* parent = nullptr);

  private:
    void change(QAction* action, QKeySequenceEdit* edit);

    Actions& actions_;
    QLabel* note_;
};

}  // namespace glint
