// Actions: one table of everything a person can do by menu, key or command search.
#pragma once

#include <QAction>
#include <QObject>
#include <map>
#include <vector>

#include "gui/app/memory.h"

class QMenu;
class QWidget;

namespace glint {

class Actions : public QObject {
    Q_OBJECT

  public:
    /// Makes all actions and adds them to `window`, so that their keys work: those that the person
    /// chose, else the table's.
    Actions(QWidget* window, Memory memory);

    /// The action with this id of the table in actions.cpp.
    [[nodiscard]] QAction* operator[](const char* id) const;
    /// In the order of the table.
    [[nodiscard]] const std::vector<QAction*>& all() const { return ordered_; }
    /// Heading under which the shortcut sheet lists the action.
    [[nodiscard]] static QString groupOf(const QAction* action);
    /// The action's name without mnemonic and dots.
    [[nodiscard]] static QString plainText(const QAction* action);
    /// Gives the action other keys, and keeps them.
    void setKeys(QAction* action, const QKeySequence& keys);
    void resetKeys();
    /// The action that has these keys, if any.
    [[nodiscard]] const QAction* userOf(const QKeySequence& keys) const;
    /// Adds actions by id; "-" is a separator.
    void fill(QMenu* menu, std::initializer_list<const char*> ids) const;

    template <class Receiver, class Function>
    void on(const char* id, Receiver* receiver, Function&& function) {
        connect((*this)[id], &QAction::triggered, receiver, std::forward<Function>(function));
    }

  private:
    Memory memory_;
    std::map<QString, QAction*> byId_;
    std::vector<QAction*> ordered_;
};

}  // namespace glint
