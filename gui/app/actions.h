// Actions: one table of everything a person can do by menu, key or command search.
#pragma once

#include <QAction>
#include <QObject>
#include <map>
#include <vector>

class QMenu;
class QWidget;

namespace glint {

class Actions : public QObject {
    Q_OBJECT

  public:
    /// Makes all actions and adds them to `window`, so that their keys work.
    explicit Actions(QWidget* window);

    /// The action with this id of the table in actions.cpp.
    [[nodiscard]] QAction* operator[](const char* id) const;
    /// In the order of the table.
    [[nodiscard]] const std::vector<QAction*>& all() const { return ordered_; }
    /// Heading under which the shortcut sheet lists the action.
    [[nodiscard]] static QString groupOf(const QAction* action);
    /// Adds actions by id; "-" is a separator.
    void fill(QMenu* menu, std::initializer_list<const char*> ids) const;

    template <class Receiver, class Function>
    void on(const char* id, Receiver* receiver, Function&& function) {
        connect((*this)[id], &QAction::triggered, receiver, std::forward<Function>(function));
    }

  private:
    std::map<QString, QAction*> byId_;
    std::vector<QAction*> ordered_;
};

}  // namespace glint
