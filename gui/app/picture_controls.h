// PictureControls: the actions that choose what the viewport shows and where it works: channels,
// filter, region, isolation; and the one that copies it.
#pragma once

#include <QObject>

#include "tracer/render/frame_painter.h"

namespace glint {

class Actions;
class Document;
class Renderer;
class RenderView;
class Selection;

class PictureControls : public QObject {
    Q_OBJECT

  public:
    PictureControls(Actions& actions, Renderer& renderer, RenderView& view, Document& document,
                    Selection& selection, QObject* parent);

  private:
    void connectChannels();
    void toggleIsolation(bool on);
    void toggleComparison(bool on);
    void copyPicture();
    void showState();

    Actions& actions_;
    Renderer& renderer_;
    RenderView& view_;
    Document& document_;
    Selection& selection_;
};

/// The ids of the actions of the channels, in their order.
extern const char* const kChannelActions[kChannels];

}  // namespace glint
