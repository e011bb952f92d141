#include "gui/app/selection.h"

#include <algorithm>

#include "gui/app/document.h"
#include "gui/app/item_differences.h"

namespace glint {

Selection::Selection(const Document& document, QObject* parent)
    : QObject(parent), document_(document) {
    connect(&document, &Document::changed, this, &Selection::follow);
}

bool Selection::contains(Item item) const {
    return std::find(items_.begin(), items_.end(), item) != items_.end();
}

std::vector<ObjectId> Selection::objects() const {
    std::vector<ObjectId> out;
    for (const Item item : items_)
        if (item.kind == ItemKind::Object) out.push_back(ObjectId{item.id});
    return out;
}

void Selection::set(std::vector<Item> items) {
    if (items == items_) return;
    items_ = std::move(items);
    emit changed();
}

void Selection::toggle(Item item) {
    std::vector<Item> items = items_;
    if (const auto found = std::find(items.begin(), items.end(), item); found != items.end())
        items.erase(found);
    else
        items.push_back(item);
    set(std::move(items));
}

void Selection::follow(const Scene& before) {
    if (document_.isReplacing()) return clear();
    const Scene& scene = document_.scene();
    std::vector<Item> come;
    forEachItemDifference(before, scene, [&](const ItemDifference& change) {
        if (!change.was) come.push_back(change.item);
    });
    if (!come.empty()) return set(topmost(scene, come));
    std::vector<Item> items = items_;
    std::erase_if(items, [&](Item item) { return !exists(scene, item); });
    set(std::move(items));
}

}  // namespace glint
