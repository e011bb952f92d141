#include "gui/app/missing_assets.h"

#include <algorithm>
#include <utility>

#include "gui/app/document.h"
#include "gui/app/renderer.h"
#include "gui/app/text.h"
#include "gui/panels/environment_picker.h"
#include "gui/widgets/message_bar.h"

namespace glint {

MissingAssets::MissingAssets(const Document& document, const Renderer& renderer,
                             std::function<EnvironmentPicker&()> environment, MessageBar& messages,
                             QObject* parent)
    : QObject(parent),
      document_(document),
      renderer_(renderer),
      environment_(std::move(environment)),
      messages_(messages) {
    connect(&renderer, &Renderer::frameReady, this, &MissingAssets::check);
    connect(&document, &Document::changed, this, [this](const Scene& before) {
        if (before.environment.image != document_.scene().environment.image) told_.clear();
    });
}

void MissingAssets::check() {
    if (!renderer_.isCurrent()) return;  // What an older scene lacked says nothing of this one.
    const std::vector<Error>& warnings = renderer_.frame()->warnings;
    const auto missing = std::find_if(warnings.begin(), warnings.end(), [](const Error& warning) {
        return warning.pointer == "/environment/image";
    });
    if (missing == warnings.end()) {
        told_.clear();
        return;
    }
    const std::string& image = document_.scene().environment.image;
    if (image.empty() || image == told_) return;
    told_ = image;
    messages_.show(MessageBar::Level::Warning,
                   tr("The environment's picture %1 cannot be shown: %2")
                       .arg(toQString(image), toQString(missing->message)),
                   toQString(*missing),
                   {{tr("Locate…"), [this] { environment_().browse(); }},
                    {tr("Leave it out"), [this] { environment_().chooseNone(); }}});
}

}  // namespace glint
