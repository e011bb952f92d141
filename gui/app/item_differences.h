// What a change of the document did to its items. Its cost is that of the change.
#pragma once

#include "gui/app/item.h"

namespace glint {

struct ItemDifference {
    Item item;
    bool was, is;  ///< in the scene before, and after
    bool moved;    ///< to another group
};

/// Calls visit(ItemDifference) for each group, object, light and named camera that differs.
template <class Visit>
void forEachItemDifference(const Scene& before, const Scene& after, Visit&& visit) {
    const auto inTable = [&]<class T, class IdType>(const Table<T, IdType>& from,
                                                    const Table<T, IdType>& to) {
        Table<T, IdType>::forEachDifference(from, to, [&](IdType id, const T* old, const T* now) {
            bool moved = false;
            if constexpr (requires { old->parent; })
                moved = old && now && old->parent != now->parent;
            visit(ItemDifference{Item::of(id), old != nullptr, now != nullptr, moved});
        });
    };
    inTable(before.groups, after.groups);
    inTable(before.objects, after.objects);
    inTable(before.lights, after.lights);
    inTable(before.cameras, after.cameras);
}

}  // namespace glint
