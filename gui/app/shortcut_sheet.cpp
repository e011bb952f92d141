#include "gui/app/shortcut_sheet.h"

#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <map>

#include "gui/app/actions.h"

namespace glint {

namespace {

using Rows = std::vector<std::pair<QString, QString>>;

QString table(const QString& title, const Rows& rows) {
    QString out = QStringLiteral("<h3>%1</h3><table cellspacing='0' cellpadding='2'>")
                      .arg(title.toHtmlEscaped());
    for (const auto& [what, keys] : rows)
        out += QStringLiteral("<tr><td width='300'>%1</td><td><b>%2</b></td></tr>")
                   .arg(what.toHtmlEscaped(), keys.toHtmlEscaped());
    return out + QStringLiteral("</table>");
}

}  // namespace

ShortcutSheet::ShortcutSheet(const Actions& actions, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Shortcuts"));
    setAttribute(Qt::WA_DeleteOnClose);
    const Rows hands = {
        {tr("Select, extend"), tr("Left click, Shift + left click")},
        {tr("Select in a box"), tr("Left drag on empty ground")},
        {tr("Orbit about the point under the pointer"), tr("Middle drag, Alt + left drag")},
        {tr("Pan"), tr("Shift + middle drag, Alt + middle drag")},
        {tr("Dolly towards the pointer"), tr("Wheel, Alt + right drag")},
        {tr("Fly"), tr("Right button held: W A S D, Q E; wheel speed; Shift fast")},
        {tr("Turn the environment"), tr("Shift, then right drag")},
        {tr("Focus here"), tr("Ctrl + left click")},
        {tr("While a handle is dragged"),
         tr("X Y Z lock, Ctrl snap, Shift fine, type a number, Esc cancels")},
        {tr("Saved views"), tr("Ctrl+1…9 go, Ctrl+Shift+1…9 store")},
    };
    std::vector<QString> order;
    std::map<QString, Rows> groups;
    for (const QAction* action : actions.all()) {
        QStringList keys;
        for (const QKeySequence& key : action->shortcuts())
            keys << key.toString(QKeySequence::NativeText);
        if (keys.isEmpty()) continue;
        const QString group = Actions::groupOf(action);
        if (!groups.contains(group)) order.push_back(group);
        groups[group].push_back({Actions::plainText(action), keys.join(", ")});
    }
    QString html = table(tr("Mouse"), hands);
    for (const QString& group : order) html += table(group, groups[group]);

    auto* label = new QLabel(html, this);
    label->setTextFormat(Qt::RichText);
    label->setContentsMargins(12, 4, 12, 12);
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(label);
    scroll->setWidgetResizable(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);
    resize(fontMetrics().averageCharWidth() * 125, fontMetrics().height() * 40);
}

}  // namespace glint
