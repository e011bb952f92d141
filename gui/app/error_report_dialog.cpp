#include "gui/app/error_report_dialog.h"

#include <pthread.h>

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSvgRenderer>
#include <QSvgWidget>
#include <QTableWidget>
#include <QVBoxLayout>

#include "gui/app/document.h"
#include "gui/app/text.h"
#include "tracer/compile/compiler.h"
#include "tracer/io/atomic_file.h"

namespace glint {

namespace {

/// The measured picture's longer side [px], and what is measured on it.
constexpr int kSide = 160;
constexpr ErrorReportSettings kSettings{
    .firstPower = 0, .lastPower = 6, .seeds = 8, .threads = 0, .referenceFactor = 16};
/// The reference takes this share of the progress, being so much more work.
constexpr double kReferenceShare = 0.6;

Scene smaller(Scene scene) {
    const double factor =
        static_cast<double>(kSide) / std::max(scene.film.width, scene.film.height);
    if (factor >= 1) return scene;
    scene.film.width = std::max(1, static_cast<int>(scene.film.width * factor));
    scene.film.height = std::max(1, static_cast<int>(scene.film.height * factor));
    return scene;
}

QString percent(const Interval& value) {
    return QString("%1 ± %2").arg(100 * value.mean, 0, 'g', 3).arg(100 * value.half, 0, 'g', 1);
}

}  // namespace

ErrorReportDialog::ErrorReportDialog(const Document& document, QWidget* parent)
    : QDialog(parent), scene_(smaller(document.committed())), assetFolder_(document.assetFolder()) {
    setWindowTitle(tr("Error report"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    connect(this, &ErrorReportDialog::progressed, progress_, &QProgressBar::setValue,
            Qt::QueuedConnection);
    connect(this, &ErrorReportDialog::measured, this, &ErrorReportDialog::onMeasured,
            Qt::QueuedConnection);
    thread_ = std::jthread([this] { measure(); });
}

ErrorReportDialog::~ErrorReportDialog() { stop_.store(true, std::memory_order_relaxed); }

void ErrorReportDialog::build() {
    auto* column = new QVBoxLayout(this);
    state_ = new QLabel(tr("Measuring at %1 × %2 pixels: %3 renders of each number of samples "
                           "against a reference by another estimator.")
                            .arg(scene_.film.width)
                            .arg(scene_.film.height)
                            .arg(kSettings.seeds),
                        this);
    state_->setObjectName("errorReport.state");
    state_->setWordWrap(true);
    column->addWidget(state_);
    progress_ = new QProgressBar(this);
    progress_->setObjectName("errorReport.progress");
    column->addWidget(progress_);
    plot_ = new QSvgWidget(this);
    plot_->setObjectName("errorReport.plot");
    plot_->setMinimumSize(fontMetrics().averageCharWidth() * 95, fontMetrics().height() * 18);
    plot_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    column->addWidget(plot_, 1);
    table_ = new QTableWidget(0, 6, this);
    table_->setObjectName("errorReport.table");
    table_->setAccessibleName(windowTitle());
    table_->setHorizontalHeaderLabels({tr("Samples"), tr("Time"), tr("relMSE"), tr("Mean error %"),
                                       tr("99th percentile %"), tr("Outliers %")});
    table_->verticalHeader()->hide();
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table_->setMinimumHeight(fontMetrics().height() * 11);
    column->addWidget(table_);
    auto* buttons = new QDialogButtonBox(this);
    save_ = buttons->addButton(tr("Save CSV…"), QDialogButtonBox::ActionRole);
    save_->setObjectName("errorReport.save");
    save_->setEnabled(false);
    cancel_ = buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
    cancel_->setObjectName("errorReport.cancel");
    connect(save_, &QPushButton::clicked, this, &ErrorReportDialog::saveCsv);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    column->addWidget(buttons);
}

void ErrorReportDialog::measure() {
    pthread_setname_np(pthread_self(), "glint-error");
    const QString error = measureScene();
    if (!stop_.load(std::memory_order_relaxed)) emit measured(error);
}

QString ErrorReportDialog::measureScene() {
    AssetCache assets;
    const auto compiled = compile(scene_, assetFolder_, assets);
    if (!compiled) return toQString(compiled.error());
    const auto watch = [this](double from, double share) {
        return ErrorReportWatch{
            &stop_, [this, from, share](double fraction) {
                emit progressed(static_cast<int>(100 * (from + share * fraction)));
            }};
    };
    const auto reference =
        makeReference(compiled.value().scene, kSettings, watch(0, kReferenceShare));
    if (!reference) return {};
    const auto report = measureErrors(compiled.value().scene, *reference, kSettings,
                                      watch(kReferenceShare, 1 - kReferenceShare));
    if (report) report_ = *report;
    return {};
}

void ErrorReportDialog::onMeasured(const QString& error) {
    progress_->hide();
    cancel_->setText(tr("Close"));
    if (!error.isEmpty()) return state_->setText(error);
    QString text = tr("%1 × %2 pixels.").arg(scene_.film.width).arg(scene_.film.height) + ' ';
    if (report_.law)
        text += tr("relMSE falls as samples to the power of %1 ± %2 (−1: as chance has it); "
                   "efficiency 1 / (relMSE · time) is %3 per second.")
                    .arg(report_.law->slope, 0, 'f', 2)
                    .arg(report_.law->slopeHalf, 0, 'f', 2)
                    .arg(report_.efficiency, 0, 'g', 3);
    else
        text += tr("This picture has no noise that could be measured.");
    state_->setText(text);
    fillTable();
    const bool dark = palette().color(QPalette::Window).lightness() < 128;
    plot_->load(QByteArray::fromStdString(errorReportSvg(
        {{tr("this scene").toStdString(), report_}}, tr("Error over time").toStdString(), dark)));
    plot_->renderer()->setAspectRatioMode(Qt::KeepAspectRatio);
    save_->setEnabled(true);
}

void ErrorReportDialog::fillTable() {
    table_->setRowCount(static_cast<int>(report_.points.size()));
    int row = 0;
    for (const ErrorPoint& p : report_.points) {
        const QString cells[] = {
            QString::number(p.spp),
            tr("%1 s").arg(p.seconds.mean, 0, 'g', 3),
            QString("%1 ± %2").arg(p.relMse.mean, 0, 'g', 3).arg(p.relMse.half, 0, 'g', 1),
            percent(p.mape),
            percent(p.percentile99),
            percent(p.outlierShare)};
        int column = 0;
        for (const QString& cell : cells) {
            auto* item = new QTableWidgetItem(cell);
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            table_->setItem(row, column++, item);
        }
        ++row;
    }
}

void ErrorReportDialog::saveCsv() {
    auto* dialog = new QFileDialog(this, tr("Save CSV"), "error.csv", tr("Tables (*.csv)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix("csv");
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
        const Status written = writeWhole(toPath(file), errorReportCsv(report_));
        state_->setText(written ? tr("Saved %1").arg(file) : toQString(written.error()));
    });
    dialog->open();
}

}  // namespace glint
