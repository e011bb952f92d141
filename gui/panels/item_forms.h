// The forms of the property panel: which sections an object, group, light, camera, material or the
// scene's settings have.
#pragma once

#include "gui/panels/form_builder.h"

namespace glint {

void buildObjectForm(FormBuilder& form);
void buildGroupForm(FormBuilder& form);
void buildLightForm(FormBuilder& form);
void buildCameraForm(FormBuilder& form);
void buildMaterialForm(FormBuilder& form);
void buildTextureForm(FormBuilder& form);

/// The materials of these objects, each once.
[[nodiscard]] std::vector<std::uint32_t> materialsOf(const Scene& scene,
                                                     const std::vector<std::uint32_t>& objects);
/// The textures that these materials use, each once.
[[nodiscard]] std::vector<std::uint32_t> texturesOf(const Scene& scene,
                                                    const std::vector<std::uint32_t>& materials);

}  // namespace glint
