#include "tracer/render/picture_error.h"

#include <algorithm>
#include <cmath>

#include "tracer/base/check.h"

namespace glint {

namespace {

/// What is added to R^2.
double floorOf(const Image& image) {
    double sum = 0;
    for (const float value : image.rgb) sum += value;
    const double mean = sum / static_cast<double>(image.rgb.size());
    return std::max(1e-2 * mean * mean, 1e-30);
}

float quantile(std::vector<float>& values, double share) {
    const auto place = values.begin() +
                       static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

}  // namespace

void ReferenceSum::add(const Image& image) {
    if (count_ == 0) {
        width_ = image.width;
        height_ = image.height;
        mean_.assign(image.rgb.size(), 0);
        squares_.assign(image.rgb.size(), 0);
    }
    GLINT_CHECK(image.rgb.size() == mean_.size());
    ++count_;
    for (std::size_t i = 0; i < mean_.size(); ++i) {
        const double difference = image.rgb[i] - mean_[i];
        mean_[i] += difference / count_;
        squares_[i] += difference * (image.rgb[i] - mean_[i]);
    }
}

Reference ReferenceSum::reference() const {
    Reference out{{width_, height_, std::vector<float>(mean_.begin(), mean_.end())},
                  std::vector<float>(mean_.size())};
    const double n = count_;
    for (std::size_t i = 0; i < mean_.size() && count_ > 1; ++i)
        out.variance[i] = static_cast<float>(squares_[i] / (n * (n - 1)));
    return out;
}

PictureErrors pictureErrors(const Image& image, const Reference& reference) {
    const std::size_t count = image.rgb.size();
    GLINT_CHECK(count > 0 && count == reference.mean.rgb.size());
    const double floor = floorOf(reference.mean);
    std::vector<float> relative(count);
    PictureErrors out;
    for (std::size_t i = 0; i < count; ++i) {
        const double r = reference.mean.rgb[i], e = image.rgb[i] - r, size = r * r + floor;
        relative[i] = static_cast<float>(std::abs(e) / std::sqrt(size));
        out.relMse += (e * e - reference.variance[i]) / size;
        out.mape += relative[i];
    }
    const auto n = static_cast<double>(count);
    out.relMse /= n;
    out.mape /= n;
    const float limit = 50 * quantile(relative, 0.5);
    out.percentile99 = quantile(relative, 0.99);
    const auto outliers =
        std::count_if(relative.begin(), relative.end(), [&](float e) { return e > limit; });
    out.outlierShare = limit > 0 ? static_cast<double>(outliers) / n : 0;
    return out;
}

PictureDifference pictureDifference(const Reference& a, const Reference& b) {
    const std::size_t count = a.mean.rgb.size();
    GLINT_CHECK(count > 0 && count == b.mean.rgb.size());
    const double floor = floorOf(a.mean);
    double sumA = 0, sumB = 0, squares = 0, noise = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = a.mean.rgb[i], y = b.mean.rgb[i], size = x * x + floor;
        sumA += x;
        sumB += y;
        squares += (y - x) * (y - x) / size;
        noise += (static_cast<double>(a.variance[i]) + b.variance[i]) / size;
    }
    const auto n = static_cast<double>(count);
    return {sumB / sumA, std::sqrt(std::max(0.0, (squares - noise) / n)), std::sqrt(noise / n)};
}

}  // namespace glint
