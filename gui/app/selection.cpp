#include "gui/app/selection.h"

#include <algorithm>

#include "gui/app/document.h"

namespace glint {

Selection::Selection(const Document& document, QObject* parent) : QObject(parent), document_(document) {
    connect(&document, &Document::changed, this, &Selection::follow);
    connect(&document, &Document::replaced, this, &Selection::clear);
}

bool Selection::contains(Item item) const { return std::find(items_.begin(), items_.end(), item) != items_.end(); }

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
    const Scene& scene = document_.scene();
    std::vector<Item> come;
    const auto collect = [&]<class T, class IdType>(const Table<T, IdType>& from, const Table<T, IdType>& to) {
        Table<T, IdType>::forEachDifference(from, to, [&](IdType id, const T* was, const T* is) {
            if (is && !was) come.push_back(Item::of(id));
        });
    };
    collect(before.groups, scene.groups);
    collect(before.objects, scene.objects);
    collect(before.lights, scene.lights);
    collect(before.cameras, scene.cameras);
    if (!come.empty()) return set(topmost(scene, come));
    std::vector<Item> items = items_;
    std::erase_if(items, [&](Item item) { return !exists(scene, item); });
    set(std::move(items));
}

}  // namespace glint
