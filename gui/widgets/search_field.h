// SearchField: a line to type into, with a button that clears it. The button comes with the first
// focus: the style looks for its picture in every icon theme of the system, too long a search for
// the start.
#pragma once

#include <QLineEdit>

namespace glint {

class SearchField : public QLineEdit {
    Q_OBJECT

  public:
    using QLineEdit::QLineEdit;

  protected:
    void focusInEvent(QFocusEvent* event) override {
        setClearButtonEnabled(true);
        QLineEdit::focusInEvent(event);
    }
};

}  // namespace glint
