// PixelInspector: explains a pixel: the paths of one of its samples, what each surface did to them,
// and what light each found.
#pragma once

#include <QPoint>
#include <QWidget>

class QLabel;
class QSpinBox;
class QTreeWidget;
class QTreeWidgetItem;

namespace glint {

class Document;
class Renderer;
struct PathRecord;
class Selection;

class PixelInspector : public QWidget {
    Q_OBJECT

  public:
    PixelInspector(Document& document, Renderer& renderer, Selection& selection,
                   QWidget* parent = nullptr);

    /// Traces sample 0 of this pixel of the picture that is shown, and shows it.
    void inspect(const QPoint& pixel);

  private:
    void trace();
    void show(const PathRecord& record);
    void select(QTreeWidgetItem* item);

    Document& document_;
    Renderer& renderer_;
    Selection& selection_;
    QPoint pixel_{-1, -1};
    int asked_ = 0;  ///< number of the newest trace; older ones that end later are dropped
    QLabel* title_;
    QSpinBox* sample_;
    QTreeWidget* tree_;
};

}  // namespace glint
