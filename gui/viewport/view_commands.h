// ViewCommands: moves of the view that menus and keys ask for: frame, standard views, projection,
// history, saved views.
#pragma once

#include <QObject>

#include "gui/viewport/bounds.h"

namespace glint {

class RenderView;

class ViewCommands : public QObject {
    Q_OBJECT

  public:
    static constexpr int kSavedViews = 9;  ///< as many as there are digits

    explicit ViewCommands(RenderView& view, QObject* parent = nullptr);

    void frameSelected();
    void frameAll();
    /// Looks along this world direction at the same target.
    void lookAlong(const DVec3& direction);
    void toggleProjection();
    void back();
    void forward();
    /// Saved views 1 to kSavedViews. Storing is an edit, going there is not.
    void goToSavedView(int number);
    void storeView(int number);

  private:
    void go(const Camera& camera);
    void frame(const Bounds& bounds);

    RenderView& view_;
};

}  // namespace glint
