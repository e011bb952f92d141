#include "tracer/cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace glint {

ProgressBar::ProgressBar(Mode mode)
    : active_(mode == Mode::Automatic && isatty(STDERR_FILENO) == 1) {}

void ProgressBar::show(const RenderProgress& progress) {
    if (!active_) return;
    // Return to the line's beginning, and erase what a longer line left behind.
    std::fprintf(stderr, "\r%s\033[K", progressLine(progress).c_str());
    std::fflush(stderr);
    drawn_ = true;
}

void ProgressBar::clear() {
    if (!drawn_) return;
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
    drawn_ = false;
}

std::string progressLine(const RenderProgress& progress) {
    constexpr int kWidth = 30;
    const double fraction = std::clamp(progress.fraction, 0.0, 1.0);
    const int filled = static_cast<int>(fraction * kWidth);
    std::string out = "[" + std::string(static_cast<std::size_t>(filled), '#') +
                      std::string(static_cast<std::size_t>(kWidth - filled), '-') + "] ";
    out += std::to_string(static_cast<int>(fraction * 100)) + " %  " +
           std::to_string(progress.spp) + "/" + std::to_string(progress.sppTarget) + " spp  ";
    return out + (fraction > 0 ? clockText(progress.remainingSeconds) + " left" : "");
}

std::string clockText(double seconds) {
    constexpr double kLongest = 1e6 * 3600;
    const auto whole = static_cast<long long>(std::ceil(std::clamp(seconds, 0.0, kLongest)));
    std::array<char, 48> text{};
    if (whole >= 3600)
        std::snprintf(text.data(), text.size(), "%lld:%02lld:%02lld", whole / 3600, whole / 60 % 60,
                      whole % 60);
    else
        std::snprintf(text.data(), text.size(), "%lld:%02lld", whole / 60, whole % 60);
    return text.data();
}

}  // namespace glint
