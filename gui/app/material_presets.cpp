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

// Names and categories of presets.json, for lupdate; gui_language_test finds one that is missing.
[[maybe_unused]] constexpr const char* kNames[] = {
    QT_TRANSLATE_NOOP("MaterialPreset", "Gold"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Metals"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Silver"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Copper"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Aluminium"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Brushed aluminium"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Chromium"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Iron"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Nickel"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Titanium"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Mirror"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Glass"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Glass and gems"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Window pane"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Frosted glass"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Fused silica"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Acrylic"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Diamond"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Sapphire"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Bottle glass"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Water"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Liquids"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Milk"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Skimmed milk"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Cream"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Marble"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Stone and earth"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Chalk"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Terracotta"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Jade"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Wax"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Car paint red"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Paint and plastic"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Car paint blue"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Plastic yellow"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Plastic green"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Porcelain"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Rubber"),
    QT_TRANSLATE_NOOP("MaterialPreset", "Matt grey paint"),
};

/// A preset's entry is a material of a scene file: the reader of those checks it.
MaterialPreset presetOf(const QJsonObject& entry) {
    QJsonObject material = entry["material"].toObject();
    material["name"] = entry["name"];
    const QJsonObject file{{"glint", 1}, {"materials", QJsonArray{material}}};
    auto scene = parseScene(QJsonDocument(file).toJson().toStdString(), "presets.json");
    GLINT_CHECK(scene.ok());
    MaterialPreset preset{entry["name"].toString(),
                          entry["category"].toString(),
                          entry["source"].toString(),
                          std::move(scene).value(),
                          {}};
    preset.material = preset.scene.materials.ids().front();
    return preset;
}

std::vector<MaterialPreset> readPresets() {
    initMaterialResources();
    QFile file(":/materials/presets.json");
    GLINT_CHECK(file.open(QIODevice::ReadOnly));
    std::vector<MaterialPreset> out;
    for (const auto& entry : QJsonDocument::fromJson(file.readAll())["presets"].toArray())
        out.push_back(presetOf(entry.toObject()));
    return out;
}

}  // namespace

const std::vector<MaterialPreset>& materialPresets() {
    static const std::vector<MaterialPreset> presets = readPresets();
    return presets;
}

QString presetText(const QString& english) {
    return QCoreApplication::translate("MaterialPreset", english.toUtf8().constData());
}

}  // namespace glint
