#include "gui/panels/form_panel.h"

#include <QVBoxLayout>

#include "gui/panels/form_builder.h"

namespace glint {

FormPanel::FormPanel(Document& document, std::function<void(FormBuilder&)> build,
                     std::function<QString(const Scene&)> structure, QWidget* parent)
    : FormScroll(parent),
      document_(document),
      build_(std::move(build)),
      structure_(std::move(structure)) {
    connect(&document, &Document::changed, this, &FormPanel::onChanged);
    rebuild();
}

void FormPanel::onChanged() {
    if (structure_(document_.scene()) != builtFor_) return rebuild();
    for (const auto& refresh : refreshes_) refresh(document_.scene());
}

void FormPanel::rebuild() {
    builtFor_ = structure_(document_.scene());
    QWidget* content = newForm();
    auto* layout = new QVBoxLayout(content);
    FormBuilder form(document_, std::make_shared<const std::vector<std::uint32_t>>(1, 0u), content);
    build_(form);
    refreshes_ = form.takeRefreshes();
    layout->addStretch(1);
    showForm();
    for (const auto& refresh : refreshes_) refresh(document_.scene());
}

}  // namespace glint
