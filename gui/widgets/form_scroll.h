// FormScroll: a form that scrolls up and down, is replaced as a whole, and is never narrower than its fields need.
#pragma once

#include <QScrollArea>

namespace glint {

class FormScroll : public QScrollArea {
    Q_OBJECT

  public:
    explicit FormScroll(QWidget* parent = nullptr);

  protected:
    /// Shows `form` in place of the old one, which goes when its events are over.
    void setForm(QWidget* form);
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void fitWidth();
};

}  // namespace glint
