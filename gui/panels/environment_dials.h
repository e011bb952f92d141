// EnvironmentDials: turns the environment and places the sun of a computed sky by dragging, above
// the form with the numbers.
#pragma once

#include <QWidget>

#include "gui/widgets/sun_dial.h"

class QLabel;

namespace glint {

class AngleDial;
class Document;
class DragNumber;

class EnvironmentDials : public QWidget {
    Q_OBJECT

  public:
    explicit EnvironmentDials(Document& document, QWidget* parent = nullptr);

  private:
    void buildSun();
    void showScene();
    void turn(double degrees, bool done);
    void placeSun(const SunAngles& angles, bool done);

    Document& document_;
    AngleDial* rotation_;
    QLabel* rotationText_;
    QWidget* sunBox_;
    SunDial* sun_;
    DragNumber* azimuth_;
    DragNumber* elevation_;
};

}  // namespace glint
