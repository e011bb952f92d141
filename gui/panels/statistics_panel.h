// StatisticsPanel: figures of the scene and of the running render, as rows of name and value.
#pragma once

#include <QWidget>
#include <vector>

class QFormLayout;
class QLabel;

namespace glint {

class Document;
class Renderer;

class StatisticsPanel : public QWidget {
    Q_OBJECT

  public:
    StatisticsPanel(const Document& document, const Renderer& renderer, QWidget* parent = nullptr);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    QLabel* addRow(QFormLayout* form, const QString& name);
    void showScene();
    void showFrame();

    const Document& document_;
    const Renderer& renderer_;
    QLabel *objects_, *groups_, *lights_, *materials_, *cameras_;
    QLabel *size_, *samples_, *time_, *error_, *rays_, *kernel_, *features_, *faulty_;
};

}  // namespace glint
