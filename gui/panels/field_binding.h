// FieldBinding<T>: one row of a property panel: a lens, the targets it applies to, and how the
// field is named and explained. Editors read with common() and write with preview() and edit().
#pragma once

#include <QCoreApplication>
#include <memory>
#include <vector>

#include "gui/app/document.h"
#include "gui/app/problems.h"
#include "gui/panels/lens.h"

namespace glint {

using Targets = std::shared_ptr<const std::vector<std::uint32_t>>;

/// What all targets have: the value, if they agree.
template <class T>
struct Common {
    const T* value = nullptr;  ///< the first target's; null if no target has the field
    bool mixed = false;        ///< the targets differ
};

template <class T>
struct FieldBinding {
    Document* document = nullptr;
    Lens<T> lens;
    Targets targets;
    QString path;   ///< "object.shape.radius": object name of the editor, merge key of its steps
    QString label;  ///< as a person reads it
    FieldMeta meta;
    T initial{};  ///< what "reset to default" sets

    [[nodiscard]] Common<T> common(const Scene& scene) const {
        Common<T> out;
        for (const std::uint32_t target : *targets) {
            const T* value = lens.get(scene, target);
            if (!value) continue;
            if (!out.value)
                out.value = value;
            else if (!(*value == *out.value))
                out.mixed = true;
            if (out.mixed) break;
        }
        return out;
    }

    /// Sets `value` for all targets in a copy of the committed scene; the reason if that makes it
    /// unsound.
    [[nodiscard]] QString apply(Scene& scene, const T& value) const {
        for (const std::uint32_t target : *targets) {
            if (!lens.get(scene, target)) continue;
            if (QString reason = lens.set(scene, target, value); !reason.isEmpty()) return reason;
        }
        return newProblem(document->committed(), scene);
    }

    QString edit(const T& value) const {
        Scene scene = document->committed();
        QString reason = apply(scene, value);
        if (reason.isEmpty())
            document->edit(
                std::move(scene),
                QCoreApplication::translate("FieldBinding", "Change %1").arg(label.toLower()));
        else
            document->cancelPreview();
        return reason;
    }

    QString preview(const T& value) const {
        Scene scene = document->committed();
        QString reason = apply(scene, value);
        if (reason.isEmpty()) document->preview(std::move(scene));
        return reason;
    }

    /// The same row for a part of the value.
    template <class Part>
    [[nodiscard]] FieldBinding<Part> part(Lens<Part> partLens, const QString& suffix,
                                          Part partInitial) const {
        return {document, std::move(partLens),   targets, path + suffix, label,
                meta,     std::move(partInitial)};
    }
};

}  // namespace glint
