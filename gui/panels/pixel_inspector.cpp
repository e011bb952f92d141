#include "gui/panels/pixel_inspector.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPointer>
#include <QSpinBox>
#include <QThreadPool>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "gui/app/document.h"
#include "gui/app/renderer.h"
#include "gui/app/selection.h"
#include "gui/app/text.h"
#include "tracer/compile/render_scene.h"
#include "tracer/render/path_record.h"

namespace glint {

namespace {

constexpr int kObjectRole = Qt::UserRole;

QString numbers(const Rgb& c) {
    const auto one = [](float v) { return QString::number(static_cast<double>(v), 'g', 3); };
    return c.x == c.y && c.y == c.z
               ? one(c.x)
               : QStringLiteral("%1  %2  %3").arg(one(c.x), one(c.y), one(c.z));
}

}  // namespace

PixelInspector::PixelInspector(Document& document, Renderer& renderer, Selection& selection,
                               QWidget* parent)
    : QWidget(parent), document_(document), renderer_(renderer), selection_(selection) {
    title_ = new QLabel(
        tr("Alt+click a pixel of the picture, or choose “Inspect pixel” in its menu."), this);
    title_->setWordWrap(true);
    sample_ = new QSpinBox(this);
    sample_->setPrefix(tr("Sample "));
    sample_->setAccessibleName(tr("Sample"));
    sample_->setMaximum(1 << 24);
    sample_->setToolTip(tr("Which of the pixel's samples is explained"));
    sample_->setEnabled(false);
    tree_ = new QTreeWidget(this);
    tree_->setHeaderLabels({tr("Path"), tr("Adds"), tr("How")});
    tree_->headerItem()->setToolTip(
        1, tr("Light that this and all below it add to the sample: red, green, blue"));
    tree_->setUniformRowHeights(true);
    tree_->setAccessibleName(tr("Paths of the sample"));
    tree_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    tree_->header()->setStretchLastSection(false);
    auto* top = new QHBoxLayout;
    top->addWidget(title_, 1);
    top->addWidget(sample_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addLayout(top);
    layout->addWidget(tree_, 1);
    connect(sample_, &QSpinBox::valueChanged, this, &PixelInspector::trace);
    connect(tree_, &QTreeWidget::itemClicked, this, &PixelInspector::select);
}

void PixelInspector::inspect(const QPoint& pixel) {
    pixel_ = pixel;
    sample_->setEnabled(true);
    if (sample_->value() == 0)
        trace();
    else
        sample_->setValue(0);
}

void PixelInspector::trace() {
    tree_->clear();
    const SessionFrame* frame = renderer_.frame();
    if (!frame || !frame->scene || pixel_.x() < 0 || pixel_.y() < 0 || pixel_.x() >= frame->width ||
        pixel_.y() >= frame->height) {
        title_->setText(tr("There is no picture at this pixel."));
        return;
    }
    title_->setText(tr("Pixel %1, %2").arg(pixel_.x()).arg(pixel_.y()));
    // Off this thread: a path of thousands of surfaces takes longer than a frame.
    QThreadPool::globalInstance()->start(
        [guard = QPointer(this), number = ++asked_, scene = frame->scene,
         place = SamplePlace{pixel_.x(), pixel_.y(), sample_->value()}] {
            auto record = std::make_shared<const PathRecord>(recordSample(*scene, place));
            QMetaObject::invokeMethod(qApp, [guard, number, record] {
                if (guard && guard->asked_ == number) guard->show(*record);
            });
        });
}

void PixelInspector::show(const PathRecord& record) {
    tree_->clear();
    title_->setText(
        tr("Pixel %1, %2: radiance %3").arg(pixel_.x()).arg(pixel_.y()).arg(numbers(record.value)));
    std::vector<QTreeWidgetItem*> above;
    for (const PathRow& row : pathRows(record, document_.scene())) {
        const auto depth = static_cast<std::size_t>(row.depth);
        above.resize(depth);
        auto* item = depth == 0 ? new QTreeWidgetItem(tree_) : new QTreeWidgetItem(above.back());
        item->setText(0, toQString(row.what));
        item->setText(1, numbers(row.total));
        item->setText(2, toQString(row.how));
        item->setToolTip(2, toQString(row.how));
        item->setData(0, kObjectRole, row.object.value);
        above.push_back(item);
    }
    tree_->expandAll();
}

void PixelInspector::select(QTreeWidgetItem* item) {
    const ObjectId id{item->data(0, kObjectRole).toUInt()};
    if (document_.scene().objects.find(id)) selection_.set({Item::of(id)});
}

}  // namespace glint
