// LazyDock: a dock whose content is made when it is first seen or asked for. What stands behind
// another tab, or is hidden, costs the start nothing.
#pragma once

#include <QDockWidget>
#include <functional>

namespace glint {

class LazyDock : public QDockWidget {
    Q_OBJECT

  public:
    using Make = std::function<QWidget*(QWidget* parent)>;
    LazyDock(const QString& title, Make make, QWidget* parent);

    /// Made here if the dock has not been seen yet.
    QWidget* content();

  private:
    void makeIfSeen();

    Make make_;
    bool seen_ = false;
};

}  // namespace glint
