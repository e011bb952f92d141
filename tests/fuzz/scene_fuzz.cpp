// Any bytes as a scene file: an error or a scene, and a scene that was read is written and read
// again as the same.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "tracer/io/scene_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const glint::Result<glint::Scene> scene = glint::parseScene(text, "fuzz.json");
    if (!scene) return 0;
    const glint::Result<glint::Scene> again =
        glint::parseScene(glint::formatScene(scene.value()), "again.json");
    if (!again || !(again.value() == scene.value())) std::abort();
    return 0;
}
