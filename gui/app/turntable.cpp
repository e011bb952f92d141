#include "gui/app/turntable.h"

#include <cmath>

namespace glint {

Camera cameraOf(const Turntable& turntable, Camera camera, int frame) {
    const double angle = degreesToRadians(turntable.degrees * frame / turntable.frames);
    DVec3 axis(0.0);
    axis[turntable.axis] = 1;
    const auto turned = [&](const DVec3& v) {
        return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
               axis * glm::dot(axis, v) * (1 - std::cos(angle));
    };
    if (frame == 0) return camera;
    camera.position = camera.target + turned(camera.position - camera.target);
    camera.up = turned(camera.up);
    return camera;
}

std::filesystem::path numbered(const std::filesystem::path& file, int frame) {
    std::string digits = std::to_string(frame + 1);
    constexpr std::size_t kDigits = 4;
    digits.insert(0, kDigits - std::min(kDigits, digits.size()), '0');
    return file.parent_path() / (file.stem().string() + "_" + digits + file.extension().string());
}

}  // namespace glint
