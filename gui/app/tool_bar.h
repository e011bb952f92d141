// The tool bar's fields that are not plain actions: axes, pivot, integrator, exposure.
#pragma once

#include <QToolBar>

namespace glint {

class Actions;
class Document;
class RenderView;

class ToolBar : public QToolBar {
    Q_OBJECT

  public:
    ToolBar(Document& document, RenderView& view, const Actions& actions, QWidget* parent);

  private:
    void addToolOptions();
    void addSceneFields();

    Document& document_;
    RenderView& view_;
};

}  // namespace glint
