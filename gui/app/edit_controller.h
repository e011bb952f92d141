// EditController: what the Edit and Add menus do: each command makes a new scene from the present
// one and the selection, and hands it to the document with a name.
#pragma once

#include <QObject>
#include <QPointF>
#include <functional>
#include <string_view>

#include "gui/app/item.h"

class QMenu;

namespace glint {

class Document;
class RenderView;
class Selection;

class EditController : public QObject {
    Q_OBJECT

  public:
    EditController(Document& document, Selection& selection, RenderView& view,
                   QObject* parent = nullptr);

    void remove();
    /// The copies follow the pointer if it is over the picture.
    void duplicate();
    void copy();
    void cut();
    void paste();
    void selectAll();
    void hideSelected();
    void hideRest();
    void showAll();
    void group();
    void ungroup();
    /// Changes the exposure by so many stops.
    void changeExposure(double stops);
    void lookThroughSelectedCamera();
    /// Makes one of `cameras` the active one; none: the scene's own.
    void lookThrough(CameraId camera);

    /// Fills a menu with every shape and light; new things stand where `placeAt` says, in the
    /// view's pixels.
    void fillAddMenu(QMenu* menu, const std::function<QPointF()>& placeAt);
    void addShape(std::string_view kind, const QPointF& at);
    void addBallLight(const QPointF& at);
    void addLight(std::string_view kind, const QPointF& at);
    void addGroup();
    void addCamera();

  signals:
    /// Something could not be done, for the message bar.
    void refused(const QString& reason);

  private:
    void finishAdding(Scene scene, Item item, const QString& text);

    Document& document_;
    Selection& selection_;
    RenderView& view_;
};

}  // namespace glint
