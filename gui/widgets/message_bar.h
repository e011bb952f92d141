// MessageBar: what the program has to say, above the picture, without stopping anybody. Holds one
// message with actions.
#pragma once

#include <QFrame>
#include <functional>
#include <vector>

class QHBoxLayout;
class QLabel;
class QProgressBar;
class QToolButton;

namespace glint {

class MessageBar : public QFrame {
    Q_OBJECT

  public:
    enum class Level { Info, Warning, Error };
    struct Choice {
        QString text;
        std::function<void()> run;
    };

    explicit MessageBar(QWidget* parent = nullptr);

    /// Replaces what is shown. `details` becomes the tool tip.
    void show(Level level, const QString& text, const QString& details = {},
              std::vector<Choice> choices = {});
    /// Shows a running job: 0 to 1, negative while unknown.
    void showProgress(const QString& text, double fraction, std::vector<Choice> choices = {});
    void dismiss();
    [[nodiscard]] QString text() const;

  signals:
    /// A message came up (progress does not count).
    void shown(glint::MessageBar::Level level, const QString& text, const QString& details);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void retranslate();
    void setChoices(std::vector<Choice> choices);

    QLabel* icon_;
    QToolButton* close_;
    QLabel* label_;
    QProgressBar* progress_;
    QHBoxLayout* choices_;
};

}  // namespace glint
