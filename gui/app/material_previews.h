// MaterialPreviews: the preview balls of a document's materials, kept up to date behind an edit.
#pragma once

#include <QImage>
#include <QObject>
#include <QSize>
#include <map>

#include "gui/app/preview_renderer.h"

namespace glint {

class Document;

class MaterialPreviews : public QObject {
    Q_OBJECT

  public:
    MaterialPreviews(const Document& document, PreviewRenderer& renderer,
                     QObject* parent = nullptr);

    /// Side of the pictures, in device pixels.
    static constexpr int kSide = 128;

    /// The newest picture of the material; null, or that of an older state of it, while the right
    /// one is made.
    [[nodiscard]] QImage of(MaterialId material);
    /// Makes the material's first picture before those of others: somebody looks at it.
    void hurry(MaterialId material);
    /// A picture of a material that is not the document's, such as a preset.
    [[nodiscard]] QImage of(const Scene& scene, MaterialId material, const QString& slot);

  signals:
    /// of(material) has a better picture now.
    void changed(glint::MaterialId material);
    /// The same for pictures by slot.
    void slotChanged(const QString& slot);

  private:
    struct Shown {
        QString key;
        QImage picture;
    };
    void onDocumentChanged(const Scene& before);
    void onReady(const QString& key, const QImage& picture);
    void onReleased();
    void ask(Shown& shown, const Scene& scene, MaterialId material, const QString& slot);

    const Document& document_;
    PreviewRenderer& renderer_;
    std::map<MaterialId, Shown> shown_;  ///< those somebody asked for
    std::map<QString, Shown> slots_;
};

}  // namespace glint
