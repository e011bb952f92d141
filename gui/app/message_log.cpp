#include "gui/app/message_log.h"

#include <QTime>

#include "gui/widgets/icons.h"

namespace glint {

namespace {

constexpr int kMostLines = 2000;

}  // namespace

MessageLog::MessageLog(MessageBar& messages, QObject* parent) : QStandardItemModel(parent) {
    connect(&messages, &MessageBar::shown, this, &MessageLog::add);
}

void MessageLog::add(MessageBar::Level level, const QString& text, const QString& details) {
    auto* line =
        new QStandardItem(icon(level == MessageBar::Level::Info ? "info" : "warning"),
                          QTime::currentTime().toString("HH:mm:ss") + QStringLiteral("  ") + text);
    line->setEditable(false);
    line->setToolTip(details.isEmpty() ? text : text + '\n' + details);
    appendRow(line);
    if (rowCount() > kMostLines) removeRow(0);
}

QString MessageLog::text() const {
    QStringList lines;
    for (int row = 0; row < rowCount(); ++row) lines << item(row)->text();
    return lines.join('\n');
}

}  // namespace glint
