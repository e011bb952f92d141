#include "gui/panels/render_panel.h"

#include "gui/panels/form_builder.h"

namespace glint {

RenderPanel::RenderPanel(Document& document, QWidget* parent)
    : FormPanel(
          document,
          [](FormBuilder& form) {
              form.addStruct(tr("Render"), "render", partOf(&Scene::render));
              form.addStruct(tr("Film"), "film", partOf(&Scene::film));
              form.addStruct(tr("Display"), "display", partOf(&Scene::display));
          },
          [](const Scene&) { return QString(); }, parent) {
    setAccessibleName(tr("Render settings"));
}

}  // namespace glint
