// T0: double -> float -> double keeps the rounding to float in every lane. g++ 12 drops it when the
// SLP vectoriser is on.
#include <gtest/gtest.h>

#include <glm/gtc/type_precision.hpp>

#include "tracer/math/types.h"

namespace glint {
namespace {

/// What volatile storage, which the compiler cannot see through, makes of a double.
double rounded(double x) {
    volatile float f = static_cast<float>(x);
    return static_cast<double>(f);
}

const double kValues[4] = {1.0 / 3, 0.1, 1e10 / 7, -2.0 / 11};

/// Kept out of line, so that the loop is optimised as it would be in a kernel.
template <int N>
[[gnu::noinline]] void roundArray(const double* in, double* out) {
    float narrow[N];
    for (int i = 0; i < N; ++i) narrow[i] = static_cast<float>(in[i]);
    for (int i = 0; i < N; ++i) out[i] = static_cast<double>(narrow[i]);
}
template <class DVec, class FVec>
[[gnu::noinline]] void roundVector(const DVec& in, DVec& out) {
    out = DVec(FVec(in));
}
[[gnu::noinline]] void roundByHelpers(const DVec3& in, DVec3& out) { out = toDouble(toFloat(in)); }

template <int N>
void expectArrayRounds() {
    double out[N];
    roundArray<N>(kValues, out);
    for (int i = 0; i < N; ++i)
        EXPECT_EQ(out[i], rounded(kValues[i])) << "lane " << i << " of " << N;
}
template <class DVec, class FVec>
void expectVectorRounds() {
    DVec in, out;
    for (int i = 0; i < DVec::length(); ++i) in[i] = kValues[i];
    roundVector<DVec, FVec>(in, out);
    for (int i = 0; i < DVec::length(); ++i) EXPECT_EQ(out[i], rounded(kValues[i])) << "lane " << i;
}

TEST(Rounding, ArraysKeepIt) {
    expectArrayRounds<2>();
    expectArrayRounds<3>();
    expectArrayRounds<4>();
}

TEST(Rounding, GlmVectorsKeepIt) {
    expectVectorRounds<glm::dvec2, glm::vec2>();
    expectVectorRounds<glm::dvec3, glm::vec3>();
    expectVectorRounds<glm::dvec4, glm::vec4>();
}

TEST(Rounding, HelpersKeepIt) {
    const DVec3 in(kValues[0], kValues[1], kValues[2]);
    DVec3 out;
    roundByHelpers(in, out);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(out[i], rounded(in[i]));
}

}  // namespace
}  // namespace glint
