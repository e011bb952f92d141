#include "gui/app/material_presets.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "gui/app/text.h"
#include "tracer/base/check.h"
#include "tracer/io/scene_json.h"

// Resources of a static library must be asked for, outside any namespace.
static void initMaterialResources() { Q_INIT_RESOURCE(materials); }

namespace glint {

namespace {

/// A preset's entry is a material of a scene file: the reader of those checks it.
MaterialPreset presetOf(const QJsonObject& entry) {
    QJsonObject material = entry["material"].toObject();
    material["name"] = entry["name"];
    const QJsonObject file{{"glint", 1}, {"materials", QJsonArray{material}}};
    auto scene = parseScene(QJsonDocument(file).toJson().toStdString(), "presets.json");
    GLINT_CHECK(scene.ok());
    MaterialPreset preset{entry["name"].toString(), entry["category"].toString(), entry["source"].toString(), std::move(scene).value(), {}};
    preset.material = preset.scene.materials.ids().front();
    return preset;
}

std::vector<MaterialPreset> readPresets() {
    initMaterialResources();
    QFile file(":/materials/presets.json");
    GLINT_CHECK(file.open(QIODevice::ReadOnly));
    std::vector<MaterialPreset> out;
    for (const QJsonValue& entry : QJsonDocument::fromJson(file.readAll())["presets"].toArray()) out.push_back(presetOf(entry.toObject()));
    return out;
}

}  // namespace

const std::vector<MaterialPreset>& materialPresets() {
    static const std::vector<MaterialPreset> presets = readPresets();
    return presets;
}

QString presetText(const QString& english) { return QCoreApplication::translate("MaterialPreset", english.toUtf8().constData()); }

}  // namespace glint
