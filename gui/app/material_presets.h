// Materials that come with the program: resources/materials/presets.json, each with the source of
// its numbers.
#pragma once

#include <QString>
#include <vector>

#include "tracer/scene/scene.h"

namespace glint {

struct MaterialPreset {
    QString name, category;  ///< in English: translate with presetText()
    QString source;          ///< where the numbers come from
    Scene scene;             ///< holds the material
    MaterialId material;
};

/// Read at the first call; in the order of the file.
[[nodiscard]] const std::vector<MaterialPreset>& materialPresets();
/// A preset's name or category in the person's language.
[[nodiscard]] QString presetText(const QString& english);

}  // namespace glint
