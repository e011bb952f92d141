// MaterialModel: the document's materials as a list with pictures; renaming is an edit, dragging
// carries the material's id.
#pragma once

#include <QAbstractListModel>
#include <vector>

#include "tracer/scene/scene.h"

namespace glint {

class Document;
class MaterialPreviews;

class MaterialModel : public QAbstractListModel {
    Q_OBJECT

  public:
    MaterialModel(Document& document, MaterialPreviews& previews, QObject* parent = nullptr);

    [[nodiscard]] MaterialId materialAt(const QModelIndex& index) const;
    [[nodiscard]] QModelIndex indexOf(MaterialId material) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] QStringList mimeTypes() const override;
    [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;
    [[nodiscard]] Qt::DropActions supportedDragActions() const override {
        return Qt::CopyAction | Qt::MoveAction;
    }

  signals:
    /// A name was refused.
    void refused(const QString& reason);

  private:
    void onChanged(const Scene& before);
    [[nodiscard]] QString toolTipOf(MaterialId material) const;

    Document& document_;
    MaterialPreviews& previews_;
    std::vector<MaterialId> rows_;
};

}  // namespace glint
