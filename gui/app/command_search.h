// CommandSearch: every action by name. Type a few letters, Enter runs it.
#pragma once

#include <QFrame>

class QLineEdit;
class QListWidget;

namespace glint {

class Actions;

class CommandSearch : public QFrame {
    Q_OBJECT

  public:
    CommandSearch(const Actions& actions, QWidget* parent);
    /// Opens over the middle of the parent.
    void open();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void filter(const QString& text);
    void run();

    const Actions& actions_;
    QLineEdit* line_;
    QListWidget* list_;
};

}  // namespace glint
