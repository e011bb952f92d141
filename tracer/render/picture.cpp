#include "tracer/render/picture.h"

namespace glint {

EditPlan planFor(const Picture& picture, const Scene& next,
                 const std::filesystem::path& assetFolder) {
    if (!picture.scene || picture.assetFolder != assetFolder) return {};
    EditPlan plan = planEdit(picture.traced, next, picture.groups);
    if (!plan.mix.isUnit() && picture.film.groups() != picture.scene->lightGroups) return {};
    return plan;
}

void PictureCache::store(const Picture& picture) {
    if (!picture.scene || picture.spp == 0 || picture.seconds < kWorthSeconds) return;
    std::erase_if(pictures_, [&](const Picture& other) {
        return planFor(other, picture.traced, picture.assetFolder).kind == EditPlan::Kind::Keep &&
               other.spp <= picture.spp;
    });
    pictures_.push_front(picture);
    while (pictures_.size() > 1 && bytes() > limit_) pictures_.pop_back();
    if (bytes() > limit_) pictures_.clear();
}

std::optional<Picture> PictureCache::take(const Scene& next,
                                          const std::filesystem::path& assetFolder) {
    for (auto at = pictures_.begin(); at != pictures_.end(); ++at) {
        const EditPlan plan = planFor(*at, next, assetFolder);
        if (plan.kind != EditPlan::Kind::Keep) continue;
        Picture out = std::move(*at);
        pictures_.erase(at);
        out.film.setMix(plan.mix);
        return out;
    }
    return std::nullopt;
}

std::size_t PictureCache::bytes() const {
    std::size_t sum = 0;
    for (const Picture& picture : pictures_) sum += picture.film.bytes();
    return sum;
}

}  // namespace glint
