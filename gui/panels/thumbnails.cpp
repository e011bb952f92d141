#include "gui/panels/thumbnails.h"

#include <QtConcurrent>
#include <algorithm>
#include <cmath>
#include <set>

#include "tracer/color/display.h"
#include "tracer/io/image_file.h"

namespace glint {

namespace {

/// Mean of the pixels of `image` that fall on one pixel of a picture of `size`.
Rgb boxMean(const Image& image, const QSize& size, int x, int y) {
    const auto range = [](int i, int count, int all) {
        return std::pair(i * all / count, std::max(i * all / count + 1, (i + 1) * all / count));
    };
    const auto [x0, x1] = range(x, size.width(), image.width);
    const auto [y0, y1] = range(y, size.height(), image.height);
    Rgb sum(0.0f);
    for (int v = y0; v < y1; ++v)
        for (int u = x0; u < x1; ++u) {
            const float* pixel =
                &image.rgb[(static_cast<std::size_t>(v) * static_cast<std::size_t>(image.width) +
                            static_cast<std::size_t>(u)) *
                           3];
            sum += Rgb(pixel[0], pixel[1], pixel[2]);
        }
    return sum / static_cast<float>((x1 - x0) * (y1 - y0));
}

/// Exposure that brings the geometric mean of the brightness to a middle grey.
double autoExposure(const std::vector<Rgb>& pixels) {
    constexpr double kMiddleGrey = 0.25, kBlack = 1e-4;
    double sum = 0;
    for (const Rgb& pixel : pixels) sum += std::log(std::max<double>(kBlack, luminance(pixel)));
    return std::log2(kMiddleGrey /
                     std::exp(sum / static_cast<double>(std::max<std::size_t>(1, pixels.size()))));
}

}  // namespace

QImage makeThumbnail(const std::filesystem::path& path, const QSize& size) {
    const auto image = loadImage(path);
    if (!image.ok() || image.value()->width < 1 || image.value()->height < 1) return {};
    const QSize fitted = QSize(image.value()->width, image.value()->height)
                             .scaled(size, Qt::KeepAspectRatio)
                             .expandedTo({1, 1});
    std::vector<Rgb> pixels;
    for (int y = 0; y < fitted.height(); ++y)
        for (int x = 0; x < fitted.width(); ++x)
            pixels.push_back(boxMean(*image.value(), fitted, x, y));
    const DisplayTransform display({autoExposure(pixels), View::Standard});
    QImage out(fitted, QImage::Format_RGB32);
    std::size_t i = 0;
    for (int y = 0; y < fitted.height(); ++y)
        for (int x = 0; x < fitted.width(); ++x) out.setPixel(x, y, display.apply(pixels[i++]));
    return out;
}

void requestThumbnail(const std::filesystem::path& path, const QSize& size, QObject* receiver,
                      std::function<void(const QImage&)> done) {
    QtConcurrent::run([path, size] {
        return makeThumbnail(path, size);
    }).then(receiver, [done = std::move(done)](const QImage& image) { done(image); });
}

bool isPicture(const std::filesystem::path& path) {
    static const std::set<std::string> endings = {".exr",  ".hdr", ".png", ".jpg",
                                                  ".jpeg", ".tif", ".tiff"};
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return endings.contains(ending);
}

std::vector<std::filesystem::path> environmentFiles(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> out;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
        if (entry.is_regular_file(error) && isPicture(entry.path())) out.push_back(entry.path());
    std::sort(out.begin(), out.end());
    return out;
}

}  // namespace glint
