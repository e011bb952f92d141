// Selection: which items of the document are chosen, shared by all views of a window. The last one
// chosen is the active one. What an edit, undo or redo brings into the document is chosen, what it
// takes out no longer. In a new document nothing is.
#pragma once

#include <QObject>
#include <vector>

#include "gui/app/item.h"

namespace glint {

class Document;
struct Scene;

class Selection : public QObject {
    Q_OBJECT

  public:
    explicit Selection(const Document& document, QObject* parent = nullptr);

    /// In the order they were chosen.
    [[nodiscard]] const std::vector<Item>& items() const { return items_; }
    [[nodiscard]] bool isEmpty() const { return items_.empty(); }
    [[nodiscard]] bool contains(Item item) const;
    [[nodiscard]] std::vector<ObjectId> objects() const;

    void set(std::vector<Item> items);
    /// Adds the item as the active one, or takes it out if it is in.
    void toggle(Item item);
    void clear() { set({}); }

  signals:
    void changed();

  private:
    void follow(const Scene& before);

    const Document& document_;
    std::vector<Item> items_;
};

}  // namespace glint
