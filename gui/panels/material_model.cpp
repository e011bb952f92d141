#include "gui/panels/material_model.h"

#include <QIcon>
#include <QPixmap>
#include <algorithm>

#include "gui/app/document.h"
#include "gui/app/material_edits.h"
#include "gui/app/material_previews.h"
#include "gui/app/text.h"
#include "gui/widgets/icons.h"
#include "tracer/scene/edit.h"

namespace glint {

MaterialModel::MaterialModel(Document& document, MaterialPreviews& previews, QObject* parent)
    : QAbstractListModel(parent),
      document_(document),
      previews_(previews),
      rows_(document.scene().materials.ids()) {
    connect(&document, &Document::changed, this, &MaterialModel::onChanged);
    connect(&previews, &MaterialPreviews::changed, this, [this](MaterialId material) {
        if (const QModelIndex index = indexOf(material); index.isValid())
            emit dataChanged(index, index, {Qt::DecorationRole});
    });
}

MaterialId MaterialModel::materialAt(const QModelIndex& index) const {
    const auto row = static_cast<std::size_t>(index.row());
    return index.isValid() && row < rows_.size() ? rows_[row] : MaterialId{};
}

QModelIndex MaterialModel::indexOf(MaterialId material) const {
    const auto found = std::lower_bound(rows_.begin(), rows_.end(), material);
    return found != rows_.end() && *found == material
               ? index(static_cast<int>(found - rows_.begin()))
               : QModelIndex();
}

void MaterialModel::onChanged(const Scene& before) {
    const Scene& after = document_.scene();
    if (before.materials == after.materials) return;
    std::vector<MaterialId> ids = after.materials.ids();
    if (ids != rows_) {
        beginResetModel();
        rows_ = std::move(ids);
        endResetModel();
        return;
    }
    if (!rows_.empty())
        emit dataChanged(index(0), index(static_cast<int>(rows_.size()) - 1),
                         {Qt::DisplayRole, Qt::ToolTipRole});
}

int MaterialModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QString MaterialModel::toolTipOf(MaterialId material) const {
    const Scene& scene = document_.scene();
    int users = 0;
    scene.objects.forEach(
        [&](ObjectId, const Object& object) { users += object.material == material; });
    const Material& value = scene.materials.at(material);
    return tr("%1: %2, %n object(s)\nDrag it onto an object", nullptr, users)
        .arg(toQString(value.name), labelOf(kindOf(value.value)).toLower());
}

QVariant MaterialModel::data(const QModelIndex& index, int role) const {
    const MaterialId id = materialAt(index);
    const Material* material = document_.scene().materials.find(id);
    if (!material) return {};
    switch (role) {
        case Qt::DisplayRole:
        case Qt::EditRole:
            return toQString(material->name);
        case Qt::ToolTipRole:
            return toolTipOf(id);
        case Qt::DecorationRole: {
            const QImage ball = previews_.of(id);
            return ball.isNull() ? icon("material") : QIcon(QPixmap::fromImage(ball));
        }
        default:
            return {};
    }
}

bool MaterialModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    const MaterialId id = materialAt(index);
    if (role != Qt::EditRole || !document_.committed().materials.find(id)) return false;
    const std::string name = value.toString().trimmed().toStdString();
    Scene scene = document_.committed();
    Material material = scene.materials.at(id);
    if (name == material.name) return false;
    if (name.empty() || freeMaterialName(scene, name) != name) {
        emit refused(name.empty() ? tr("A name must not be empty")
                                  : tr("Another one has the name \"%1\"").arg(value.toString()));
        return false;
    }
    material.name = name;
    scene.materials.set(id, std::move(material));
    document_.edit(std::move(scene), tr("Rename material"));
    return true;
}

Qt::ItemFlags MaterialModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return {};
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemIsDragEnabled |
           Qt::ItemNeverHasChildren;
}

QStringList MaterialModel::mimeTypes() const { return {kMaterialMimeType}; }

QMimeData* MaterialModel::mimeData(const QModelIndexList& indexes) const {
    return indexes.isEmpty() ? nullptr : materialMime(materialAt(indexes.front()));
}

}  // namespace glint
