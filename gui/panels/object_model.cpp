#include "gui/panels/object_model.h"

#include <QApplication>
#include <QDataStream>
#include <QIODevice>
#include <QMimeData>
#include <QPalette>
#include <algorithm>

#include "gui/app/document.h"
#include "gui/app/item_differences.h"
#include "gui/app/material_edits.h"
#include "gui/app/text.h"
#include "gui/widgets/icons.h"

namespace glint {

namespace {

const QString kMimeType = QStringLiteral("application/x-glint-items");
/// Above so many changed entries the tree is made anew: quicker than row by row.
constexpr std::size_t kRebuildAbove = 200;

}  // namespace

ObjectModel::ObjectModel(Document& document, QObject* parent)
    : QAbstractItemModel(parent), document_(document) {
    connect(&document, &Document::changed, this, &ObjectModel::onChanged);
    rebuild();
}

void ObjectModel::rebuild() {
    beginResetModel();
    nodes_.clear();
    root_ = {};
    const Scene& scene = document_.scene();
    std::vector<Item> items{{ItemKind::Camera, 0}};
    const auto collect = [&](auto id, const auto&) { items.push_back(Item::of(id)); };
    scene.groups.forEach(collect);
    scene.objects.forEach(collect);
    scene.lights.forEach(collect);
    scene.cameras.forEach(collect);
    for (const Item item : items) nodes_[item] = std::make_unique<Node>(Node{item, nullptr, {}});
    for (const auto& [item, node] : nodes_) {
        node->parent = parentNodeOf(item);
        node->parent->children.push_back(node.get());  // The map is sorted, hence the children too.
    }
    endResetModel();
}

void ObjectModel::onChanged(const Scene& before) {
    std::vector<ItemDifference> changes;
    const Scene& after = document_.scene();
    forEachItemDifference(before, after,
                          [&](const ItemDifference& change) { changes.push_back(change); });
    if (before.activeCamera != after.activeCamera)
        for (const CameraId id : {before.activeCamera, after.activeCamera}) refresh(Item::of(id));
    const auto restructures = [](const ItemDifference& c) { return !c.was || !c.is || c.moved; };
    const auto restructured =
        static_cast<std::size_t>(std::count_if(changes.begin(), changes.end(), restructures));
    // A group that comes, goes or moves takes its rows along: rare, and simplest from scratch.
    const bool groups = std::any_of(changes.begin(), changes.end(), [&](const ItemDifference& c) {
        return c.item.kind == ItemKind::Group && restructures(c);
    });
    if (groups || restructured > kRebuildAbove) return rebuild();
    for (const ItemDifference& change : changes) {
        if (!restructures(change))
            refresh(change.item);
        else if (change.moved)
            move(change.item);
        else if (change.is)
            insert(change.item);
        else
            remove(change.item);
    }
}

void ObjectModel::insert(Item item) {
    auto node = std::make_unique<Node>(Node{item, parentNodeOf(item), {}});
    const int row = rowFor(*node->parent, item);
    beginInsertRows(indexOfNode(node->parent), row, row);
    node->parent->children.insert(node->parent->children.begin() + row, node.get());
    nodes_[item] = std::move(node);
    endInsertRows();
}

void ObjectModel::remove(Item item) {
    Node* parent = nodes_.at(item)->parent;
    const int row = rowFor(*parent, item);
    beginRemoveRows(indexOfNode(parent), row, row);
    parent->children.erase(parent->children.begin() + row);
    nodes_.erase(item);
    endRemoveRows();
}

void ObjectModel::move(Item item) {
    Node* node = nodes_.at(item).get();
    Node *from = node->parent, *to = parentNodeOf(item);
    const int row = rowFor(*from, item), newRow = rowFor(*to, item);
    beginMoveRows(indexOfNode(from), row, row, indexOfNode(to), newRow);
    from->children.erase(from->children.begin() + row);
    to->children.insert(to->children.begin() + newRow, node);
    node->parent = to;
    endMoveRows();
}

void ObjectModel::refresh(Item item) {
    const QModelIndex first = indexOf(item);
    if (first.isValid()) emit dataChanged(first, first.siblingAtColumn(ColumnCount - 1));
}

ObjectModel::Node* ObjectModel::parentNodeOf(Item item) {
    const GroupId parent = parentOf(document_.scene(), item);
    return parent ? nodes_.at(Item::of(parent)).get() : &root_;
}

int ObjectModel::rowFor(const Node& parent, Item item) {
    const auto& children = parent.children;
    return static_cast<int>(std::lower_bound(children.begin(), children.end(), item,
                                             [](const Node* n, Item i) { return n->item < i; }) -
                            children.begin());
}

ObjectModel::Node* ObjectModel::nodeOf(const QModelIndex& index) const {
    return static_cast<Node*>(index.internalPointer());
}

QModelIndex ObjectModel::indexOfNode(const Node* node, int column) const {
    if (node == &root_) return {};
    return createIndex(rowFor(*node->parent, node->item), column, node);
}

Item ObjectModel::itemAt(const QModelIndex& index) const { return nodeOf(index)->item; }

QModelIndex ObjectModel::indexOf(Item item) const {
    const auto found = nodes_.find(item);
    return found == nodes_.end() ? QModelIndex() : indexOfNode(found->second.get());
}

QModelIndex ObjectModel::index(int row, int column, const QModelIndex& parent) const {
    const Node* node = parent.isValid() ? nodeOf(parent) : &root_;
    if (row < 0 || static_cast<std::size_t>(row) >= node->children.size() || column < 0 ||
        column >= ColumnCount)
        return {};
    return createIndex(row, column, node->children[static_cast<std::size_t>(row)]);
}

QModelIndex ObjectModel::parent(const QModelIndex& index) const {
    return index.isValid() ? indexOfNode(nodeOf(index)->parent) : QModelIndex();
}

int ObjectModel::rowCount(const QModelIndex& parent) const {
    if (parent.column() > 0) return 0;
    return static_cast<int>((parent.isValid() ? nodeOf(parent) : &root_)->children.size());
}

int ObjectModel::columnCount(const QModelIndex&) const { return ColumnCount; }

QString ObjectModel::iconName(Item item) const {
    const Scene& scene = document_.scene();
    switch (item.kind) {
        case ItemKind::Group:
            return QStringLiteral("group");
        case ItemKind::Camera:
            return QStringLiteral("camera");
        case ItemKind::Object:
            return "shape-" + toQString(kindOf(scene.objects.at(ObjectId{item.id}).shape));
        case ItemKind::Light:
            return "light-" + toQString(kindOf(scene.lights.at(LightId{item.id}).value));
    }
    return {};
}

QString ObjectModel::displayName(Item item) const {
    const std::string name = nameOf(document_.scene(), item);
    return name.empty() ? tr("Camera") : toQString(name);
}

QVariant ObjectModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const Item item = itemAt(index);
    const Scene& scene = document_.scene();
    if (!exists(scene, item)) return {};  // Asked while its row is on the way out.
    const int column = index.column();
    if (column == NameColumn) {
        if (role == Qt::DisplayRole || role == Qt::EditRole) return displayName(item);
        if (role == Qt::DecorationRole) return icon(iconName(item));
        if (role == Qt::ForegroundRole && !isVisible(scene, item))
            return QApplication::palette().brush(QPalette::Disabled, QPalette::Text);
        return {};
    }
    const bool lockable = item.kind == ItemKind::Object || item.kind == ItemKind::Group;
    if (column == VisibleColumn && item.kind != ItemKind::Camera) {
        const bool on = isVisible(scene, item);
        if (role == Qt::DecorationRole) return icon(on ? "eye" : "eye-off");
        if (role == Qt::ToolTipRole)
            return on ? tr("Visible: click to hide") : tr("Hidden: click to show");
    }
    if (column == LockedColumn && lockable) {
        const bool on = isLocked(scene, item);
        if (role == Qt::DecorationRole) return icon(on ? "lock" : "unlock");
        if (role == Qt::ToolTipRole)
            return on ? tr("Locked: click to unlock")
                      : tr("Click to lock: it cannot be picked then");
    }
    return {};
}

bool ObjectModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || index.column() != NameColumn) return false;
    const Item item = itemAt(index);
    const std::string name = value.toString().trimmed().toStdString();
    const NameFault fault = nameFault(document_.committed(), item, name);
    if (fault != NameFault::None) {
        emit refused(fault == NameFault::Empty
                         ? tr("A name must not be empty")
                         : tr("Another one has the name \"%1\"").arg(value.toString()));
        return false;
    }
    document_.edit(renamed(document_.committed(), item, name), tr("Rename"));
    return true;
}

void ObjectModel::toggle(const QModelIndex& index) {
    const Item item = itemAt(index);
    const Scene& scene = document_.committed();
    if (index.column() == VisibleColumn && item.kind != ItemKind::Camera) {
        const bool on = isVisible(scene, item);
        document_.edit(withVisible(scene, item, !on), on ? tr("Hide") : tr("Show"));
    }
    if (index.column() == LockedColumn &&
        (item.kind == ItemKind::Object || item.kind == ItemKind::Group)) {
        const bool on = isLocked(scene, item);
        document_.edit(withLocked(scene, item, !on), on ? tr("Unlock") : tr("Lock"));
    }
}

Qt::ItemFlags ObjectModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return Qt::ItemIsDropEnabled;
    const Item item = itemAt(index);
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    const bool named = item.kind != ItemKind::Camera || item.id != 0;
    if (index.column() == NameColumn && named) flags |= Qt::ItemIsEditable;
    if (item.kind == ItemKind::Object || item.kind == ItemKind::Group)
        flags |= Qt::ItemIsDragEnabled;
    // Groups take objects, and both take a material.
    if (item.kind == ItemKind::Group || item.kind == ItemKind::Object)
        flags |= Qt::ItemIsDropEnabled;
    return flags;
}

QStringList ObjectModel::mimeTypes() const { return {kMimeType, kMaterialMimeType}; }

QMimeData* ObjectModel::mimeData(const QModelIndexList& indexes) const {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    for (const QModelIndex& index : indexes) {
        if (index.column() != NameColumn) continue;
        const Item item = itemAt(index);
        stream << static_cast<quint8>(item.kind) << static_cast<quint32>(item.id);
    }
    auto* data = new QMimeData;
    data->setData(kMimeType, bytes);
    return data;
}

bool ObjectModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int, int,
                               const QModelIndex& parent) {
    if (const auto material = draggedMaterial(data, document_.committed())) {
        if (parent.isValid())
            document_.edit(
                withAssigned(document_.committed(),
                             objectsWithin(document_.committed(), {itemAt(parent)}), *material),
                tr("Assign material"));
        return false;
    }
    if (action != Qt::MoveAction || !data->hasFormat(kMimeType)) return false;
    GroupId group;
    if (parent.isValid()) {
        const Item onto = itemAt(parent);
        group = onto.kind == ItemKind::Group ? GroupId{onto.id} : parentOf(document_.scene(), onto);
    }
    QByteArray bytes = data->data(kMimeType);
    QDataStream stream(&bytes, QIODevice::ReadOnly);
    std::vector<Item> items;
    while (!stream.atEnd()) {
        quint8 kind = 0;
        quint32 id = 0;
        stream >> kind >> id;
        const Item item{static_cast<ItemKind>(kind), id};
        // The text may come from another window.
        if (kind <= static_cast<quint8>(ItemKind::Camera) && exists(document_.scene(), item))
            items.push_back(item);
    }
    Scene scene = document_.committed();
    for (const Item item : topmost(scene, items)) scene = movedInto(std::move(scene), item, group);
    document_.edit(std::move(scene), group ? tr("Move into group") : tr("Move out of group"));
    // The rows have moved already: the view must not remove them.
    return false;
}

}  // namespace glint
