#include "gui/panels/object_list.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QScopedValueRollback>
#include <QSortFilterProxyModel>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/app/document.h"
#include "gui/app/selection.h"
#include "gui/panels/object_model.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/search_field.h"

namespace glint {

ObjectList::ObjectList(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent), document_(document), selection_(selection) {
    model_ = new ObjectModel(document, this);
    filter_ = new QSortFilterProxyModel(this);
    filter_->setSourceModel(model_);
    filter_->setRecursiveFilteringEnabled(true);
    filter_->setFilterCaseSensitivity(Qt::CaseInsensitive);

    search_ = new SearchField(this);
    search_->setPlaceholderText(tr("Search"));
    search_->addAction(icon("search"), QLineEdit::LeadingPosition);
    search_->setAccessibleName(tr("Search objects"));
    connect(search_, &QLineEdit::textChanged, this, [this](const QString& text) {
        // Without the rows while the filter changes: thousands of them coming and going one by one
        // would take long.
        {
            const QScopedValueRollback guard(syncing_, true);
            filter_->setSourceModel(nullptr);
            filter_->setFilterFixedString(text);
            filter_->setSourceModel(model_);
        }
        tree_->expandAll();
        showSelection();
    });
    add_ = new QToolButton(this);
    add_->setIcon(icon("add"));
    add_->setToolTip(tr("Add (Shift+A)"));
    add_->setAccessibleName(tr("Add"));
    add_->setAutoRaise(true);
    add_->setPopupMode(QToolButton::InstantPopup);

    buildTree();
    auto* top = new QHBoxLayout;
    top->setSpacing(2);
    top->addWidget(search_, 1);
    top->addWidget(add_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addLayout(top);
    layout->addWidget(tree_);

    connect(&selection, &Selection::changed, this, &ObjectList::showSelection);
    connect(&document, &Document::replaced, tree_, &QTreeView::expandAll);
    connect(model_, &ObjectModel::refused, this, &ObjectList::refused);
    connect(model_, &QAbstractItemModel::modelAboutToBeReset, this, &ObjectList::noteCollapsed);
    connect(model_, &QAbstractItemModel::modelReset, this, [this] {
        tree_->expandAll();
        for (const Item group : collapsed_)
            tree_->setExpanded(filter_->mapFromSource(model_->indexOf(group)), false);
        showSelection();
    });
}

void ObjectList::buildTree() {
    tree_ = new QTreeView(this);
    tree_->setModel(filter_);
    tree_->setAccessibleName(tr("Objects"));
    tree_->setHeaderHidden(true);
    tree_->setUniformRowHeights(true);
    tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    tree_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    tree_->setDragDropMode(QAbstractItemView::DragDrop);
    tree_->setDefaultDropAction(Qt::MoveAction);
    tree_->setContextMenuPolicy(Qt::CustomContextMenu);
    tree_->setIndentation(fontMetrics().averageCharWidth() * 2);
    tree_->header()->setStretchLastSection(false);
    tree_->header()->setMinimumSectionSize(16);
    tree_->header()->setSectionResizeMode(ObjectModel::NameColumn, QHeaderView::Stretch);
    for (const int column : {ObjectModel::VisibleColumn, ObjectModel::LockedColumn}) {
        tree_->header()->setSectionResizeMode(column, QHeaderView::Fixed);
        tree_->setColumnWidth(column, fontMetrics().height() + 8);
    }
    // Before rows are laid out: the height that the style sheet gives them is not known earlier.
    tree_->ensurePolished();
    tree_->expandAll();
    connect(tree_, &QTreeView::clicked, this, [this](const QModelIndex& index) {
        if (index.column() != ObjectModel::NameColumn) model_->toggle(filter_->mapToSource(index));
    });
    connect(tree_, &QWidget::customContextMenuRequested, this,
            [this](const QPoint& at) { emit menuRequested(tree_->viewport()->mapToGlobal(at)); });
    connect(tree_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &ObjectList::takeSelection);
}

void ObjectList::setAddMenu(QMenu* menu) { add_->setMenu(menu); }

void ObjectList::renameActive() {
    if (selection_.isEmpty()) return;
    const QModelIndex index = filter_->mapFromSource(model_->indexOf(selection_.items().back()));
    if (!index.isValid()) return;
    tree_->setFocus();
    tree_->setCurrentIndex(index);
    tree_->edit(index);
}

void ObjectList::noteCollapsed() {
    collapsed_.clear();
    const auto visit = [&](const auto& self, const QModelIndex& parent) -> void {
        for (int row = 0; row < filter_->rowCount(parent); ++row) {
            const QModelIndex index = filter_->index(row, 0, parent);
            if (!filter_->hasChildren(index)) continue;
            if (!tree_->isExpanded(index))
                collapsed_.push_back(model_->itemAt(filter_->mapToSource(index)));
            self(self, index);
        }
    };
    visit(visit, {});
}

void ObjectList::takeSelection() {
    if (syncing_) return;
    std::vector<Item> items;
    for (const QModelIndex& index : tree_->selectionModel()->selectedRows())
        items.push_back(model_->itemAt(filter_->mapToSource(index)));
    // The row that was clicked last is the active item.
    const QModelIndex current = tree_->currentIndex();
    if (current.isValid()) {
        const auto active =
            std::find(items.begin(), items.end(), model_->itemAt(filter_->mapToSource(current)));
        if (active != items.end()) std::rotate(active, active + 1, items.end());
    }
    const QScopedValueRollback guard(syncing_, true);
    selection_.set(std::move(items));
}

void ObjectList::showSelection() {
    if (syncing_) return;
    const QScopedValueRollback guard(syncing_, true);
    std::vector<QModelIndex> rows;
    for (const Item item : selection_.items()) {
        const QModelIndex index = filter_->mapFromSource(model_->indexOf(item));
        if (index.isValid()) rows.push_back(index);
    }
    // One range for each run of siblings: thousands of single rows would make every paint slow.
    const auto place = [](const QModelIndex& index) {
        return std::pair(index.parent(), index.row());
    };
    std::sort(rows.begin(), rows.end(),
              [&](const QModelIndex& a, const QModelIndex& b) { return place(a) < place(b); });
    QItemSelection ranges;
    for (std::size_t i = 0; i < rows.size();) {
        std::size_t end = i + 1;
        while (end < rows.size() &&
               place(rows[end]) == std::pair(rows[i].parent(), rows[end - 1].row() + 1))
            ++end;
        ranges.append(QItemSelectionRange(
            rows[i], rows[end - 1].siblingAtColumn(ObjectModel::ColumnCount - 1)));
        i = end;
    }
    // Without updates the tree does not look for the rectangle of every row: it is painted as a
    // whole.
    tree_->setUpdatesEnabled(false);
    tree_->selectionModel()->select(ranges, QItemSelectionModel::ClearAndSelect);
    tree_->setUpdatesEnabled(true);
    if (selection_.isEmpty()) return;
    const QModelIndex active = filter_->mapFromSource(model_->indexOf(selection_.items().back()));
    if (!active.isValid()) return;
    tree_->selectionModel()->setCurrentIndex(active, QItemSelectionModel::NoUpdate);
    tree_->scrollTo(active);
}

}  // namespace glint
