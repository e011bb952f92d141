// Sample numbers: Owen-scrambled Sobol points in padded blocks of four dimensions, all computed
// from (seed, pixel, sample, block) alone. The order of work therefore never changes a picture.
//
// Sources: Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020; direction numbers of
// Joe and Kuo (2008); the scrambling hash is Vegdahl's improvement of Laine and Karras's
// (psychopath.io, "Building a Better LK Hash", 2022).
#pragma once

#include <array>
#include <cstdint>

#include "tracer/math/types.h"

namespace glint {

/// Four numbers in [0, 1 - 2^-24].
using SampleBlock = glm::vec4;

namespace sobol {

/// Owen scrambling of a bit-reversed number (or four).
template <class T>
[[nodiscard]] inline T scramble(T x, T seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

template <class T>
[[nodiscard]] inline T reverseBits(T x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
    return (x >> 16) | (x << 16);
}

/// A well-mixed 32-bit hash (lowbias32, Wellons 2018) of a number (or four).
template <class T>
[[nodiscard]] inline T mix(T x) {
    x ^= x >> 16;
    x *= 0x21f0aaadu;
    x ^= x >> 15;
    x *= 0xd35a2d97u;
    return x ^ (x >> 15);
}

}  // namespace sobol

/// The numbers of one sample of one pixel. Even samples belong to half A of the film and odd ones
/// to half B; the halves are scrambled independently, so that their difference is an honest measure
/// of the error.
class Sampler {
  public:
    Sampler(std::uint32_t seed, std::uint32_t pixel, std::uint32_t sample)
        : key_(sobol::mix(sobol::mix(seed * 2 + (sample & 1) + 0x68bc21ebu) ^
                          sobol::mix(pixel + 0x02e5be93u))),
          reversedIndex_(sobol::reverseBits(sample >> 1)) {}

    /// The block number `block`: well stratified over the samples within itself, independent of all
    /// other blocks.
    [[nodiscard]] SampleBlock block(std::uint32_t block) const;
    /// Two blocks at once, for little more than the price of one.
    [[nodiscard]] std::array<SampleBlock, 2> blocks(std::uint32_t first,
                                                    std::uint32_t second) const;

  private:
    [[nodiscard]] std::uint32_t keyOf(std::uint32_t block) const {
        return sobol::mix(key_ ^ (block * 0x9e3779b9u));
    }

    std::uint32_t key_, reversedIndex_;
};

}  // namespace glint
