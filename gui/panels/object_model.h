// ObjectModel: the tree of the object list. It keeps the shape of the tree (who is under whom) to
// answer the view quickly, and reads everything else from the document. After a change it touches
// only the rows that differ.
#pragma once

#include <QAbstractItemModel>
#include <map>
#include <memory>
#include <vector>

#include "gui/app/item.h"

namespace glint {

class Document;

class ObjectModel : public QAbstractItemModel {
    Q_OBJECT

  public:
    enum Column { NameColumn, VisibleColumn, LockedColumn, ColumnCount };

    explicit ObjectModel(Document& document, QObject* parent = nullptr);

    [[nodiscard]] Item itemAt(const QModelIndex& index) const;
    [[nodiscard]] QModelIndex indexOf(Item item) const;
    /// Switches visibility or lock of the item in that column.
    void toggle(const QModelIndex& index);

    [[nodiscard]] QModelIndex index(int row, int column,
                                    const QModelIndex& parent = {}) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex& index) const override;
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] QStringList mimeTypes() const override;
    [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;
    [[nodiscard]] Qt::DropActions supportedDropActions() const override {
        return Qt::MoveAction | Qt::CopyAction;
    }
    bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                      const QModelIndex& parent) override;

  signals:
    /// A name was refused.
    void refused(const QString& reason);

  private:
    struct Node {
        Item item;
        Node* parent = nullptr;
        std::vector<Node*> children;  ///< sorted by item
    };

    void onChanged(const Scene& before);
    void rebuild();
    void insert(Item item);
    void remove(Item item);
    void move(Item item);
    void refresh(Item item);
    [[nodiscard]] Node* parentNodeOf(Item item);
    /// Where the item is among the children, or would be.
    [[nodiscard]] static int rowFor(const Node& parent, Item item);
    [[nodiscard]] Node* nodeOf(const QModelIndex& index) const;
    [[nodiscard]] QModelIndex indexOfNode(const Node* node, int column = 0) const;
    [[nodiscard]] QString iconName(Item item) const;
    [[nodiscard]] QString displayName(Item item) const;

    Document& document_;
    Node root_;
    std::map<Item, std::unique_ptr<Node>> nodes_;
};

}  // namespace glint
