#include "gui/panels/preset_picker.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QScreen>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/app/material_presets.h"
#include "gui/app/material_previews.h"
#include "gui/widgets/icons.h"

namespace glint {

namespace {

constexpr int kBall = 72;  ///< logical pixels

QString slotOf(const MaterialPreset& preset) { return "preset " + preset.name; }

}  // namespace

PresetPicker::PresetPicker(MaterialPreviews& previews, QWidget* parent)
    : QFrame(parent, Qt::Popup), previews_(previews) {
    setFrameShape(QFrame::StyledPanel);
    setAccessibleName(tr("Material presets"));
    search_ = new QLineEdit(this);
    search_->setPlaceholderText(tr("Search presets"));
    search_->setAccessibleName(search_->placeholderText());
    search_->addAction(icon("search"), QLineEdit::LeadingPosition);
    search_->installEventFilter(this);
    list_ = new QListWidget(this);
    list_->setAccessibleName(tr("Material presets"));
    list_->setViewMode(QListView::IconMode);
    list_->setIconSize({kBall, kBall});
    list_->setGridSize({kBall + 26, kBall + fontMetrics().height() + 14});
    list_->setMovement(QListView::Static);
    list_->setResizeMode(QListView::Adjust);
    list_->setTextElideMode(Qt::ElideRight);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->setSpacing(6);
    layout->addWidget(search_);
    layout->addWidget(list_);
    connect(search_, &QLineEdit::textChanged, this, &PresetPicker::filter);
    connect(search_, &QLineEdit::returnPressed, this, [this] { choose(list_->currentItem()); });
    connect(list_, &QListWidget::itemClicked, this, &PresetPicker::choose);
    connect(list_, &QListWidget::itemActivated, this, &PresetPicker::choose);
    connect(&previews, &MaterialPreviews::slotChanged, this, &PresetPicker::showPicture);
}

void PresetPicker::fill() {
    const auto& presets = materialPresets();
    for (std::size_t i = 0; i < presets.size(); ++i) {
        const MaterialPreset& preset = presets[i];
        auto* item = new QListWidgetItem(icon("material"), presetText(preset.name), list_);
        item->setData(Qt::UserRole, QVariant::fromValue(i));
        item->setToolTip(QStringLiteral("<b>%1</b> · %2<br>%3")
                             .arg(presetText(preset.name), presetText(preset.category),
                                  preset.source.toHtmlEscaped()));
    }
    // The last request is traced first: ask from the end, so that pictures appear in reading order.
    for (std::size_t i = presets.size(); i-- > 0;)
        if (const QImage ball =
                previews_.of(presets[i].scene, presets[i].material, slotOf(presets[i]));
            !ball.isNull())
            list_->item(static_cast<int>(i))->setIcon(QIcon(QPixmap::fromImage(ball)));
}

void PresetPicker::showPicture(const QString& slot) {
    const auto& presets = materialPresets();
    for (int row = 0; row < list_->count(); ++row) {
        const MaterialPreset& preset = presets[static_cast<std::size_t>(row)];
        if (slotOf(preset) == slot)
            list_->item(row)->setIcon(
                QIcon(QPixmap::fromImage(previews_.of(preset.scene, preset.material, slot))));
    }
}

void PresetPicker::filter(const QString& text) {
    int first = -1;
    for (int row = 0; row < list_->count(); ++row) {
        QListWidgetItem* item = list_->item(row);
        const MaterialPreset& preset = materialPresets()[static_cast<std::size_t>(row)];
        const QString words = item->text() + ' ' + presetText(preset.category) + ' ' + preset.name;
        item->setHidden(!words.contains(text.trimmed(), Qt::CaseInsensitive));
        if (first < 0 && !item->isHidden()) first = row;
    }
    list_->setCurrentRow(first);
}

void PresetPicker::openAt(const QPoint& global) {
    if (list_->count() == 0) fill();
    search_->clear();
    filter({});
    const QSize grid = list_->gridSize();
    resize(grid.width() * 5 + 40, grid.height() * 4 + search_->sizeHint().height() + 36);
    const QRect space = screen()->availableGeometry();
    move(std::clamp(global.x(), space.left(), std::max(space.left(), space.right() - width())),
         std::clamp(global.y(), space.top(), std::max(space.top(), space.bottom() - height())));
    show();
    search_->setFocus();
}

void PresetPicker::choose(QListWidgetItem* item) {
    if (!item || !isVisible()) return;
    hide();
    emit chosen(materialPresets()[item->data(Qt::UserRole).value<std::size_t>()]);
}

bool PresetPicker::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Down || key == Qt::Key_Up) {
            list_->setFocus();
            return true;
        }
    }
    return QFrame::eventFilter(watched, event);
}

}  // namespace glint
