#include "gui/app/tool_bar.h"

#include <QComboBox>

#include "gui/app/actions.h"
#include "gui/app/document.h"
#include "gui/panels/form_builder.h"
#include "gui/viewport/render_view.h"

namespace glint {

ToolBar::ToolBar(Document& document, RenderView& view, const Actions& actions, QWidget* parent)
    : QToolBar(tr("Tools"), parent), document_(document), view_(view) {
    setObjectName("toolBar");
    setMovable(false);
    const int side = fontMetrics().height() + 2;
    setIconSize({side, side});
    for (const char* id : {"tool.select", "tool.move", "tool.rotate", "tool.scale"})
        addAction(actions[id]);
    addSeparator();
    addToolOptions();
    addAction(actions["tool.snap"]);
    addSeparator();
    for (const char* id : {"render.pause", "view.region", "view.filter"}) addAction(actions[id]);
    addSceneFields();
    auto* space = new QWidget(this);
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(space);
    addAction(actions["file.export"]);
}

void ToolBar::addToolOptions() {
    auto* axes = new QComboBox(this);
    axes->addItems({tr("World"), tr("Local")});
    axes->setToolTip(tr("Axes of the handles"));
    axes->setObjectName("tool.axes");
    connect(axes, &QComboBox::activated, this, [this](int index) {
        ToolOptions tools = view_.tools();
        tools.localAxes = index == 1;
        view_.setTools(tools);
    });
    auto* pivot = new QComboBox(this);
    pivot->addItems({tr("Median"), tr("Active"), tr("Individual")});
    pivot->setToolTip(tr("Point that turns and scales go about"));
    pivot->setObjectName("tool.pivot");
    connect(pivot, &QComboBox::activated, this, [this](int index) {
        ToolOptions tools = view_.tools();
        tools.pivot = static_cast<Pivot>(index);
        view_.setTools(tools);
    });
    addWidget(axes);
    addWidget(pivot);
}

void ToolBar::addSceneFields() {
    const auto targets = std::make_shared<const std::vector<std::uint32_t>>(1, 0u);
    const auto bind = [&](const auto& lens, const QString& path, std::string_view name,
                          const FieldMeta& meta, auto initial) {
        return FieldBinding<decltype(initial)>{&document_,    lens, targets, path,
                                               labelOf(name), meta, initial};
    };
    const auto add = [&](const FieldEditor& editor, const QString& tip) {
        editor.widget->setToolTip(tip);
        editor.widget->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
        addWidget(editor.widget);
        connect(&document_, &Document::changed, editor.widget,
                [this, editor] { editor.refresh(document_.scene()); });
        editor.refresh(document_.scene());
    };
    const auto integrator = memberOf(partOf(&Scene::render), &RenderSettings::integrator);
    add(makeEditor(bind(integrator, "toolBar.integrator", "integrator", {}, Integrator::Path),
                   this),
        tr("How light is traced"));
    const auto exposure = memberOf(partOf(&Scene::display), &Display::exposureEv);
    add(makeEditor(bind(exposure, "toolBar.exposure", "exposure_ev",
                        {.min = -100, .max = 100, .unit = "EV"}, 0.0),
                   this),
        tr("Exposure: each step doubles the brightness ([ and ])"));
}

}  // namespace glint
