// FormScroll: a form that scrolls up and down, is replaced as a whole, and is never narrower than
// its fields need.
#pragma once

#include <QScrollArea>

class QVBoxLayout;

namespace glint {

class FormScroll : public QScrollArea {
    Q_OBJECT

  public:
    explicit FormScroll(QWidget* parent = nullptr);

  protected:
    /// An empty form, not shown yet. The old one goes when its events are over.
    [[nodiscard]] QWidget* newForm();
    /// Shows the new form when it is filled.
    void showForm();
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void fitWidth();

    QVBoxLayout* layout_;
    QWidget* form_ = nullptr;
};

}  // namespace glint
