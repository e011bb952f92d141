// MessageLog: everything the message bar has said since the start, newest last, for the log panel.
#pragma once

#include <QStandardItemModel>

#include "gui/widgets/message_bar.h"

namespace glint {

class MessageLog : public QStandardItemModel {
    Q_OBJECT

  public:
    explicit MessageLog(MessageBar& messages, QObject* parent = nullptr);

    /// All lines as text.
    [[nodiscard]] QString text() const;

  private:
    void add(MessageBar::Level level, const QString& text, const QString& details);
};

}  // namespace glint
