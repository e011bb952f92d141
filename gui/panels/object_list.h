// ObjectList: the panel with everything in the scene: search, tree, and the document's selection in
// it.
#pragma once

#include <QWidget>
#include <vector>

#include "gui/app/item.h"

class QLineEdit;
class QMenu;
class QSortFilterProxyModel;
class QToolButton;
class QTreeView;

namespace glint {

class Document;
class ObjectModel;
class Selection;

class ObjectList : public QWidget {
    Q_OBJECT

  public:
    ObjectList(Document& document, Selection& selection, QWidget* parent = nullptr);

    /// What its + button opens.
    void setAddMenu(QMenu* menu);
    [[nodiscard]] QTreeView* tree() const { return tree_; }
    [[nodiscard]] ObjectModel* model() const { return model_; }
    /// Starts to rename the active item in place.
    void renameActive();

  signals:
    void menuRequested(const QPoint& globalAt);
    void refused(const QString& reason);

  private:
    void buildTree();
    void showSelection();
    void takeSelection();
    /// Remembers which groups are closed while the tree is made anew.
    void noteCollapsed();

    Document& document_;
    Selection& selection_;
    ObjectModel* model_;
    QSortFilterProxyModel* filter_;
    QLineEdit* search_;
    QToolButton* add_;
    QTreeView* tree_;
    bool syncing_ = false;
    std::vector<Item> collapsed_;
};

}  // namespace glint
