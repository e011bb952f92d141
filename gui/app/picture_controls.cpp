#include "gui/app/picture_controls.h"

#include <QActionGroup>
#include <QClipboard>
#include <QGuiApplication>

#include "gui/app/actions.h"
#include "gui/app/document.h"
#include "gui/app/renderer.h"
#include "gui/app/selection.h"
#include "gui/viewport/render_view.h"

namespace glint {

const char* const kChannelActions[kChannels] = {
    "channel.beauty", "channel.albedo",   "channel.normal",  "channel.depth", "channel.position",
    "channel.object", "channel.material", "channel.samples", "channel.error", "channel.luminance"};

PictureControls::PictureControls(Actions& actions, Renderer& renderer, RenderView& view,
                                 Document& document, Selection& selection, QObject* parent)
    : QObject(parent),
      actions_(actions),
      renderer_(renderer),
      view_(view),
      document_(document),
      selection_(selection) {
    connectChannels();
    connect(actions["view.filter"], &QAction::triggered, &renderer, &Renderer::setFiltered);
    connect(actions["view.region"], &QAction::triggered, &view, &RenderView::beginRegion);
    connect(actions["view.regionClear"], &QAction::triggered, &renderer,
            [this] { renderer_.setRegion(std::nullopt); });
    connect(actions["view.isolate"], &QAction::triggered, this, &PictureControls::toggleIsolation);
    connect(actions["render.copy"], &QAction::triggered, this, &PictureControls::copyPicture);
    connect(actions["view.compare"], &QAction::triggered, this, &PictureControls::toggleComparison);
    connect(&document.undoStack(), &QUndoStack::indexChanged, this, &PictureControls::showState);
    connect(&renderer, &Renderer::viewChanged, this, &PictureControls::showState);
    connect(&selection, &Selection::changed, this, &PictureControls::showState);
    showState();
}

// Digits are for the picture only while it has the focus: elsewhere they may be typed.
void PictureControls::connectChannels() {
    auto* group = new QActionGroup(this);
    for (std::size_t i = 0; i < kChannels; ++i) {
        QAction* action = actions_[kChannelActions[i]];
        group->addAction(action);
        action->setShortcutContext(Qt::WidgetShortcut);
        view_.addAction(action);
        connect(action, &QAction::triggered, &renderer_,
                [this, i] { renderer_.setChannel(static_cast<Channel>(i)); });
    }
}

void PictureControls::toggleIsolation(bool on) {
    std::vector<ObjectId> objects;
    if (on) objects = objectsWithin(document_.scene(), selection_.items());
    renderer_.setIsolated(std::move(objects));
}

void PictureControls::copyPicture() {
    const SessionFrame* frame = renderer_.frame();
    if (!frame || frame->width == 0) return;
    const QImage image(reinterpret_cast<const uchar*>(frame->pixels.data()), frame->width,
                       frame->height, qsizetype{4} * frame->width, QImage::Format_RGB32);
    QGuiApplication::clipboard()->setImage(image.copy());
}

void PictureControls::toggleComparison(bool on) {
    const Scene* before = document_.sceneBefore();
    renderer_.setCompared(on && before ? std::optional(*before) : std::nullopt);
}

void PictureControls::showState() {
    actions_[kChannelActions[static_cast<std::size_t>(renderer_.channel())]]->setChecked(true);
    actions_["view.filter"]->setChecked(renderer_.isFiltered());
    actions_["view.regionClear"]->setEnabled(renderer_.region().has_value());
    actions_["view.isolate"]->setChecked(renderer_.isIsolated());
    actions_["view.compare"]->setChecked(renderer_.isComparing());
    actions_["view.compare"]->setEnabled(renderer_.isComparing() || document_.sceneBefore());
    actions_["view.isolate"]->setEnabled(renderer_.isIsolated() || !selection_.isEmpty());
}

}  // namespace glint
