// RenderPanel: film, render and display settings of the scene.
#pragma once

#include "gui/panels/form_panel.h"

namespace glint {

class RenderPanel : public FormPanel {
    Q_OBJECT

  public:
    explicit RenderPanel(Document& document, QWidget* parent = nullptr);
};

}  // namespace glint
