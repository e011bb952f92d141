#include "gui/panels/material_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QShortcut>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/app/document.h"
#include "gui/app/material_edits.h"
#include "gui/app/material_presets.h"
#include "gui/app/selection.h"
#include "gui/app/text.h"
#include "gui/panels/material_model.h"
#include "gui/panels/preset_picker.h"
#include "gui/widgets/icons.h"
#include "tracer/scene/edit.h"

namespace glint {

namespace {

constexpr int kBall = 56;  ///< logical pixels

}  // namespace

MaterialPanel::MaterialPanel(Document& document, const Selection& selection,
                             MaterialPreviews& previews, QWidget* parent)
    : QWidget(parent), document_(document), selection_(selection) {
    model_ = new MaterialModel(document, previews, this);
    presets_ = new PresetPicker(previews, this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    buildButtons();
    buildList(previews);
    layout->addWidget(list_);
    connect(model_, &MaterialModel::refused, this, &MaterialPanel::refused);
    connect(presets_, &PresetPicker::chosen, this, &MaterialPanel::addPreset);
    connect(&selection, &Selection::changed, this, &MaterialPanel::followSelection);
    connect(model_, &QAbstractItemModel::modelReset, this, &MaterialPanel::followSelection);
    followSelection();
}

void MaterialPanel::buildList(MaterialPreviews&) {
    list_ = new QListView(this);
    list_->setModel(model_);
    list_->setAccessibleName(tr("Materials"));
    list_->setViewMode(QListView::IconMode);
    list_->setIconSize({kBall, kBall});
    list_->setGridSize({kBall + 22, kBall + fontMetrics().height() + 14});
    list_->setMovement(QListView::Static);
    list_->setResizeMode(QListView::Adjust);
    list_->setTextElideMode(Qt::ElideRight);
    list_->setUniformItemSizes(true);
    list_->setDragEnabled(true);
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(list_, &QWidget::customContextMenuRequested, this, &MaterialPanel::openMenu);
    connect(list_, &QListView::clicked, this, [this] { emit chosen(current()); });
    connect(list_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &MaterialPanel::updateButtons);
    auto* rename =
        new QShortcut(QKeySequence(Qt::Key_F2), list_, nullptr, nullptr, Qt::WidgetShortcut);
    connect(rename, &QShortcut::activated, this, [this] { list_->edit(list_->currentIndex()); });
    auto* remove =
        new QShortcut(QKeySequence(Qt::Key_Delete), list_, nullptr, nullptr, Qt::WidgetShortcut);
    connect(remove, &QShortcut::activated, this, &MaterialPanel::removeCurrent);
}

QToolButton* MaterialPanel::addButton(const QString& iconName, const QString& name,
                                      const QString& tip) {
    auto* button = new QToolButton(this);
    button->setIcon(icon(iconName));
    button->setAutoRaise(true);
    button->setAccessibleName(name);
    button->setToolTip(tip);
    return button;
}

void MaterialPanel::buildButtons() {
    add_ = addButton("add", tr("New material"),
                     tr("New material, from presets with measured constants"));
    add_->setObjectName("materials.add");
    add_->setText(tr("New"));
    add_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    assign_ = addButton("material", tr("Assign"), tr("Give it to the selected objects"));
    assign_->setObjectName("materials.assign");
    assign_->setText(tr("Assign"));
    assign_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    duplicate_ = addButton("duplicate", tr("Duplicate"), tr("Duplicate the material"));
    duplicate_->setObjectName("materials.duplicate");
    remove_ = addButton("delete", tr("Delete"),
                        tr("Delete the material (Del); objects that have it become black"));
    remove_->setObjectName("materials.remove");
    connect(add_, &QToolButton::clicked, this, &MaterialPanel::openPresets);
    connect(assign_, &QToolButton::clicked, this, &MaterialPanel::assignCurrent);
    connect(duplicate_, &QToolButton::clicked, this, &MaterialPanel::duplicateCurrent);
    connect(remove_, &QToolButton::clicked, this, &MaterialPanel::removeCurrent);
    auto* row = new QHBoxLayout;
    row->setSpacing(2);
    row->addWidget(add_);
    row->addWidget(assign_);
    row->addStretch();
    row->addWidget(duplicate_);
    row->addWidget(remove_);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

MaterialId MaterialPanel::current() const {
    const QModelIndexList chosen = list_->selectionModel()->selectedIndexes();
    return chosen.isEmpty() ? MaterialId{} : model_->materialAt(chosen.front());
}

void MaterialPanel::select(MaterialId material) {
    const QModelIndex index = model_->indexOf(material);
    if (!index.isValid()) return;
    list_->setCurrentIndex(index);
    list_->scrollTo(index);
}

void MaterialPanel::followSelection() {
    const auto& items = selection_.items();
    if (!items.empty() && items.back().kind == ItemKind::Object)
        if (const Object* object = document_.scene().objects.find(ObjectId{items.back().id}))
            select(object->material);
    updateButtons();
}

void MaterialPanel::updateButtons() {
    const bool one = static_cast<bool>(current());
    assign_->setEnabled(one && !selection_.objects().empty());
    duplicate_->setEnabled(one);
    remove_->setEnabled(one);
}

void MaterialPanel::openPresets() {
    presets_->openAt(add_->mapToGlobal(QPoint(0, add_->height() + 2)));
}

void MaterialPanel::addPreset(const MaterialPreset& preset) {
    Material material = preset.scene.materials.at(preset.material);
    material.name = presetText(preset.name).toStdString();
    auto [scene, id] = withMaterial(document_.committed(), std::move(material));
    document_.edit(withAssigned(std::move(scene), selection_.objects(), id),
                   tr("Add %1").arg(presetText(preset.name)));
    select(id);
    emit chosen(id);
}

void MaterialPanel::assignCurrent() {
    if (!current()) return;
    document_.edit(withAssigned(document_.committed(), selection_.objects(), current()),
                   tr("Assign material"));
}

void MaterialPanel::duplicateCurrent() {
    if (!current()) return;
    auto [scene, id] = withDuplicateMaterial(document_.committed(), current());
    document_.edit(std::move(scene), tr("Duplicate material"));
    select(id);
}

void MaterialPanel::removeCurrent() {
    if (!current()) return;
    document_.edit(withoutMaterial(document_.committed(), current(), {}), tr("Delete material"));
}

void MaterialPanel::removeUnused() {
    document_.edit(withoutUnusedMaterials(document_.committed()), tr("Delete unused materials"));
}

void MaterialPanel::openMenu(const QPoint& at) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const bool one = static_cast<bool>(current());
    const auto add = [&](const QString& iconName, const QString& text, bool enabled, auto run) {
        QAction* action = menu->addAction(icon(iconName), text);
        action->setEnabled(enabled);
        connect(action, &QAction::triggered, this, run);
    };
    add("material", tr("Assign to selection"), assign_->isEnabled(), &MaterialPanel::assignCurrent);
    add("duplicate", tr("Duplicate"), one, &MaterialPanel::duplicateCurrent);
    add("reset", tr("Rename"), one, [this] { list_->edit(list_->currentIndex()); });
    add("delete", tr("Delete"), one, &MaterialPanel::removeCurrent);
    menu->addSeparator();
    add("remove", tr("Delete unused"), true, &MaterialPanel::removeUnused);
    menu->popup(list_->viewport()->mapToGlobal(at));
}

}  // namespace glint
