// Section: a titled, collapsible part of a panel. Its fields stand in a form: label, editor, reset.
#pragma once

#include <QWidget>

class QFormLayout;
class QToolButton;
class QVBoxLayout;

namespace glint {

class Section : public QWidget {
    Q_OBJECT

  public:
    explicit Section(const QString& title, QWidget* parent = nullptr);

    /// A row of label and editor; without a label the editor takes the whole width.
    void addRow(QWidget* label, QWidget* editor);
    void addWide(QWidget* editor);
    /// Above the rows that are there.
    void addHead(QWidget* widget);
    [[nodiscard]] QString title() const;

  private:
    QToolButton* header_;
    QWidget* body_;
    QFormLayout* form_;
};

}  // namespace glint
