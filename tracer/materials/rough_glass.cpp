#include "tracer/materials/rough_glass.h"

#include <algorithm>

#include "tracer/math/quadrature.h"

namespace glint {
namespace {

/// Which part of a mixture a uniform number falls in, with the number stretched over that part
/// again.
bool takes(double share, double& u) {
    if (u < share) {
        u /= share;
        return true;
    }
    u = (u - share) / (1 - share);
    return false;
}

}  // namespace

RoughGlassBsdf::Multiple::Multiple(double alpha, double eta)
    : here_(alpha, eta), there_(alpha, 1 / eta) {
    across_ = (1 - averageFresnel(eta)) * std::min(1.0, there_.average() / here_.average());
}

namespace {

/// The ratios and their inverses, each once.
std::vector<float> bothWays(std::span<const float> ratios) {
    std::vector<float> all;
    for (const float ratio : ratios)
        for (const float way : {ratio, 1 / ratio})
            if (std::find(all.begin(), all.end(), way) == all.end()) all.push_back(way);
    return all;
}

}  // namespace

RoughGlassBsdf::RoughGlassBsdf(float alpha, std::span<const float> etas)
    : alpha_(alpha),
      ggx_(alpha),
      multipleLobe_(alpha),
      multiple_(bothWays(etas), [alpha](float eta) { return Multiple(alpha, eta); }) {}

BsdfValue RoughGlassBsdf::value(const Vec3& wo, const Vec3& wi, float eta) const {
    if (isSmooth(eta)) return {};
    const DVec3 o = unitOnSide(wo, wo.z), i = unitOnSide(wi, wo.z);
    if (o.z < kMinCosine || std::abs(i.z) < kMinCosine) return {};
    return i.z > 0 ? reflected(o, i, eta) : transmitted(o, i, eta);
}

BsdfValue RoughGlassBsdf::reflected(const DVec3& o, const DVec3& i, double eta) const {
    const Multiple* multiple = multiple_.find(static_cast<float>(eta));
    const DVec3 sum = o + i, h = sum / std::sqrt(glm::dot(sum, sum));
    const double cosine = glm::dot(o, h), reflectance = fresnelTerm(cosine, eta).reflectance;
    const double single = reflectance * ggx_.d(h) * ggx_.visibility(o, i);
    const double pdf = reflectance * ggx_.visibleNormalPdf(o, h) / (4 * cosine);
    if (!multiple) return {Rgb(static_cast<float>(single)), static_cast<float>(pdf)};
    const double lost = multiple->lost(o.z);
    return {Rgb(static_cast<float>(single + multiple->back(o, i))),
            static_cast<float>((1 - lost) * pdf +
                               lost * (1 - multiple->across()) * multipleLobe_.pdf(i.z))};
}

BsdfValue RoughGlassBsdf::transmitted(const DVec3& o, const DVec3& i, double eta) const {
    double single = 0, pdf = 0;
    DVec3 h = eta * o + i;
    h /= std::sqrt(glm::dot(h, h));
    if (h.z < 0) h = -h;
    const double co = glm::dot(o, h), ci = glm::dot(i, h);
    // Facets seen from behind on either side do not refract.
    if (co > 0 && ci < 0) {
        const double passes = 1 - fresnelTerm(co, eta).reflectance, q = ci + eta * co;
        const double jacobian = -ci / (q * q);
        single = passes * 4 * co * jacobian * ggx_.d(h) * ggx_.visibility(o, i);
        pdf = passes * jacobian * ggx_.visibleNormalPdf(o, h);
    }
    if (const Multiple* multiple = multiple_.find(static_cast<float>(eta))) {
        const double lost = multiple->lost(o.z);
        single += multiple->through(o, i);
        pdf = (1 - lost) * pdf + lost * multiple->across() * multipleLobe_.pdf(-i.z);
    }
    return {Rgb(static_cast<float>(eta * eta * single)), static_cast<float>(pdf)};
}

BsdfSample RoughGlassBsdf::sample(const Vec3& wo, const Vec3& u, float eta) const {
    const DVec3 o = unitOnSide(wo, wo.z);
    if (isSmooth(eta) || o.z < kMinCosine) return {};
    const Multiple* multiple = multiple_.find(eta);
    double pick = u.z;
    Vec3 wi;
    if (multiple && takes(multiple->lost(o.z), pick)) {
        wi = toFloat(multipleLobe_.sample(DVec2(u.x, u.y)));
        if (pick < multiple->across()) wi.z = -wi.z;
    } else {
        const DVec3 h = ggx_.visibleNormal(o, DVec2(u.x, u.y));
        const double cosine = glm::dot(o, h);
        if (cosine <= 0) return {};
        const FresnelTerm fresnel = fresnelTerm(cosine, eta);
        const bool reflects = pick < fresnel.reflectance;
        wi = toFloat(reflects ? reflectAbout(o, h)
                              : (eta * cosine - fresnel.cosTransmitted) * h -
                                    static_cast<double>(eta) * o);
        if (reflects != (wi.z > 0)) return {};
    }
    if (wo.z < 0) wi.z = -wi.z;
    return {wi, value(wo, wi, eta)};
}

RoughThinGlassBsdf::Reflectance::Reflectance(double ratio) : eta(ratio) {
    for (const QuadratureNode& node : gaussLegendre(48))
        average += 2 * node.weight * node.x * (*this)(node.x);
}

RoughThinGlassBsdf::RoughThinGlassBsdf(float ior, float alpha, std::span<const float> around)
    : ior_(ior),
      ggx_(alpha),
      multipleLobe_(alpha),
      loss_(alpha),
      reflectance_(around, [ior](float index) { return Reflectance(index / ior); }) {}

BsdfValue RoughThinGlassBsdf::value(const Vec3& wo, const Vec3& wi, float around) const {
    const bool back = sameSide(wo, wi);
    const ReflectionPair p(wo, back ? wi : Vec3(wi.x, wi.y, -wi.z));
    if (!p.valid) return {};
    const Reflectance& reflectance = reflectance_.nearest(around);
    const double share = back ? reflectance(p.cosHalf) : 1 - reflectance(p.cosHalf);
    const double averageShare = back ? reflectance.average : 1 - reflectance.average;
    const double lost = loss_(p.o.z);
    const double single = ggx_.d(p.h) * ggx_.visibility(p.o, p.i);
    const double multiple = lost * loss_(p.i.z) / (kPi * loss_.average());
    return {Rgb(static_cast<float>(share * single + averageShare * multiple)),
            static_cast<float>(share * (1 - lost) * ggx_.reflectionPdf(p.o, p.h) +
                               averageShare * lost * multipleLobe_.pdf(p.i.z))};
}

BsdfSample RoughThinGlassBsdf::sample(const Vec3& wo, const Vec3& u, float around) const {
    const DVec3 o = unitOnSide(wo, wo.z);
    if (o.z < kMinCosine) return {};
    const Reflectance& reflectance = reflectance_.nearest(around);
    double pick = u.z, share = reflectance.average;
    Vec3 wi;
    if (takes(loss_(o.z), pick)) {
        wi = toFloat(multipleLobe_.sample(DVec2(u.x, u.y)));
    } else {
        const DVec3 h = ggx_.reflectingNormal(o, DVec2(u.x, u.y));
        wi = toFloat(reflectAbout(o, h));
        share = reflectance(glm::dot(o, h));
    }
    if (wi.z <= 0) return {};
    if ((pick < share) != (wo.z > 0)) wi.z = -wi.z;
    return {wi, value(wo, wi, around)};
}

}  // namespace glint
