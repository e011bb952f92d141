// MissingAssets: says in the message bar which file the scene asks for and the disk has not, and
// helps to find it.
#pragma once

#include <QObject>
#include <functional>
#include <string>

namespace glint {

class Document;
class EnvironmentPicker;
class MessageBar;
class Renderer;

class MissingAssets : public QObject {
    Q_OBJECT

  public:
    /// `environment` is asked for only when the person wants another picture.
    MissingAssets(const Document& document, const Renderer& renderer,
                  std::function<EnvironmentPicker&()> environment, MessageBar& messages,
                  QObject* parent);

  private:
    /// Once for each choice of a file: a person who dismissed the message is not told again at
    /// every edit.
    void check();

    const Document& document_;
    const Renderer& renderer_;
    std::function<EnvironmentPicker&()> environment_;
    MessageBar& messages_;
    std::string told_;  ///< the environment's picture that was missing when last told
};

}  // namespace glint
