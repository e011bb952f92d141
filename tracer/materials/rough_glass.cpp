#include "tracer/materials/rough_glass.h"

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

struct RoughGlassBsdf::Multiple {
    DielectricLoss here, there;
    double across;  ///< share that leaves on the other side

    Multiple(double alpha, double eta)
        : here(dielectricLoss(alpha, eta)), there(dielectricLoss(alpha, 1 / eta)) {
        across = (1 - averageFresnel(eta)) * std::min(1.0, there.average() / here.average());
    }
    [[nodiscard]] double back(const DVec3& o, const DVec3& i) const {
        return (1 - across) * here(o.z) * here(i.z) / (kPi * here.average());
    }
    [[nodiscard]] double through(const DVec3& o, const DVec3& i) const {
        return across * here(o.z) * there(-i.z) / (kPi * there.average());
    }
};

RoughGlassBsdf::RoughGlassBsdf(float alpha) : alpha_(alpha), ggx_(alpha), multipleLobe_(alpha) {
    (void)Multiple(alpha, 1.5);
}

RoughGlassBsdf::Value RoughGlassBsdf::valueOf(const Vec3& wo, const Vec3& wi, double eta) const {
    if (isSmooth(eta)) return {};
    const DVec3 o = unitOnSide(wo, wo.z), i = unitOnSide(wi, wo.z);
    if (o.z < kMinCosine || std::abs(i.z) < kMinCosine) return {};
    return i.z > 0 ? reflected(o, i, eta) : transmitted(o, i, eta);
}

RoughGlassBsdf::Value RoughGlassBsdf::reflected(const DVec3& o, const DVec3& i, double eta) const {
    const Multiple multiple(alpha_, eta);
    const DVec3 sum = o + i, h = sum / std::sqrt(glm::dot(sum, sum));
    const double cosine = glm::dot(o, h), reflectance = fresnelTerm(cosine, eta).reflectance;
    const double single = reflectance * ggx_.d(h) * ggx_.visibility(o, i);
    const double lost = multiple.here(o.z);
    const double pdf = (1 - lost) * reflectance * ggx_.visibleNormalPdf(o, h) / (4 * cosine) +
                       lost * (1 - multiple.across) * multipleLobe_.pdf(i.z);
    return {static_cast<float>(single + multiple.back(o, i)), static_cast<float>(pdf)};
}

RoughGlassBsdf::Value RoughGlassBsdf::transmitted(const DVec3& o, const DVec3& i,
                                                  double eta) const {
    const Multiple multiple(alpha_, eta);
    const double lost = multiple.here(o.z);
    double single = 0, pdf = lost * multiple.across * multipleLobe_.pdf(-i.z);
    DVec3 h = eta * o + i;
    h /= std::sqrt(glm::dot(h, h));
    if (h.z < 0) h = -h;
    const double co = glm::dot(o, h), ci = glm::dot(i, h);
    // Facets seen from behind on either side do not refract.
    if (co > 0 && ci < 0) {
        const double passes = 1 - fresnelTerm(co, eta).reflectance, q = ci + eta * co;
        const double jacobian = -ci / (q * q);
        single = passes * 4 * co * jacobian * ggx_.d(h) * ggx_.visibility(o, i);
        pdf += (1 - lost) * passes * jacobian * ggx_.visibleNormalPdf(o, h);
    }
    return {static_cast<float>(eta * eta * (single + multiple.through(o, i))),
            static_cast<float>(pdf)};
}

BsdfSample RoughGlassBsdf::sample(const Vec3& wo, const Vec3& u, float eta) const {
    const DVec3 o = unitOnSide(wo, wo.z);
    if (isSmooth(eta) || o.z < kMinCosine) return {};
    const Multiple multiple(alpha_, eta);
    double pick = u.z;
    Vec3 wi;
    if (takes(multiple.here(o.z), pick)) {
        wi = toFloat(multipleLobe_.sample(DVec2(u.x, u.y)));
        if (pick < multiple.across) wi.z = -wi.z;
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
    const Value value = valueOf(wo, wi, eta);
    return {wi, Rgb(value.f), value.pdf};
}

int RoughGlassBsdf::branches(const Vec3& wo, float eta, DeltaBranch* out) const {
    return isSmooth(eta) ? smoothDielectricBranches(wo, eta, out) : 0;
}

RoughThinGlassBsdf::RoughThinGlassBsdf(float ior, float alpha)
    : eta_(1 / static_cast<double>(ior)),
      ggx_(alpha),
      multipleLobe_(alpha),
      loss_(metalLoss(alpha)) {
    for (const QuadratureNode& node : gaussLegendre(48))
        averageReflectance_ += 2 * node.weight * node.x * reflectance(node.x);
}

Rgb RoughThinGlassBsdf::eval(const Vec3& wo, const Vec3& wi, float) const {
    const bool back = sameSide(wo, wi);
    const ReflectionPair p(wo, back ? wi : Vec3(wi.x, wi.y, -wi.z));
    if (!p.valid) return Rgb(0.0f);
    const double share = reflectance(p.cosHalf), averageShare = averageReflectance_;
    const double single = ggx_.d(p.h) * ggx_.visibility(p.o, p.i);
    const double multiple =
        lossAt(p.o.z) * lossAt(p.i.z) / (kPi * (std::max(0.0, loss_.average()) + kLossNoise));
    return Rgb(static_cast<float>(back ? share * single + averageShare * multiple
                                       : (1 - share) * single + (1 - averageShare) * multiple));
}

float RoughThinGlassBsdf::pdf(const Vec3& wo, const Vec3& wi, float) const {
    const bool back = sameSide(wo, wi);
    const ReflectionPair p(wo, back ? wi : Vec3(wi.x, wi.y, -wi.z));
    if (!p.valid) return 0;
    const double share = reflectance(p.cosHalf), lost = lossAt(p.o.z);
    const double single = (1 - lost) * ggx_.reflectionPdf(p.o, p.h),
                 multiple = lost * multipleLobe_.pdf(p.i.z);
    return static_cast<float>(back ? share * single + averageReflectance_ * multiple
                                   : (1 - share) * single + (1 - averageReflectance_) * multiple);
}

BsdfSample RoughThinGlassBsdf::sample(const Vec3& wo, const Vec3& u, float eta) const {
    const DVec3 o = unitOnSide(wo, wo.z);
    if (o.z < kMinCosine) return {};
    double pick = u.z, share = averageReflectance_;
    Vec3 wi;
    if (takes(lossAt(o.z), pick)) {
        wi = toFloat(multipleLobe_.sample(DVec2(u.x, u.y)));
    } else {
        const DVec3 h = ggx_.reflectingNormal(o, DVec2(u.x, u.y));
        wi = toFloat(reflectAbout(o, h));
        share = reflectance(glm::dot(o, h));
    }
    if (wi.z <= 0) return {};
    if ((pick < share) != (wo.z > 0)) wi.z = -wi.z;
    return {wi, eval(wo, wi, eta), pdf(wo, wi, eta)};
}

}  // namespace glint
