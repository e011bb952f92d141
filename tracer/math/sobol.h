// Sample numbers: Owen-scrambled Sobol points in padded blocks of four dimensions, all computed from
// (seed, pixel, sample, block) alone. The order of work therefore never changes a picture.
//
// Sources: Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020; direction numbers of Joe and Kuo (2008); the
// scrambling hash is Vegdahl's improvement of Laine and Karras's (psychopath.io, "Building a Better LK Hash", 2022).
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "tracer/math/types.h"

namespace glint {

/// Four numbers in [0, 1 - 2^-24].
using SampleBlock = glm::vec4;

namespace sobol {

using Lanes = std::uint32_t __attribute__((vector_size(16)));

/// Direction numbers of the first four dimensions with their bits reversed, as the scrambling hash wants them.
constexpr std::array<std::array<std::uint32_t, 32>, 4> reversedDirections() {
    struct Start {
        unsigned degree, coefficients;
        std::array<std::uint32_t, 3> m;
    };
    constexpr Start kStarts[3] = {{1, 0, {1, 0, 0}}, {2, 1, {1, 3, 0}}, {3, 1, {1, 3, 1}}};
    std::array<std::array<std::uint32_t, 32>, 4> v{};
    for (unsigned i = 0; i < 32; ++i) v[0][i] = 1u << (31 - i);
    for (unsigned d = 1; d < 4; ++d) {
        const Start& start = kStarts[d - 1];
        for (unsigned i = 0; i < 32; ++i) {
            if (i < start.degree) {
                v[d][i] = start.m[i] << (31 - i);
                continue;
            }
            std::uint32_t x = v[d][i - start.degree] ^ (v[d][i - start.degree] >> start.degree);
            for (unsigned k = 1; k < start.degree; ++k)
                if ((start.coefficients >> (start.degree - 1 - k)) & 1) x ^= v[d][i - k];
            v[d][i] = x;
        }
    }
    for (auto& dimension : v)
        for (auto& x : dimension) {
            std::uint32_t r = 0;
            for (unsigned b = 0; b < 32; ++b) r |= ((x >> b) & 1) << (31 - b);
            x = r;
        }
    return v;
}

/// XOR of direction numbers for every value of each byte of the bit-reversed index; four dimensions side by side.
struct ByteTables {
    alignas(16) std::uint32_t entry[4][256][4];
};
constexpr ByteTables makeByteTables() {
    const auto v = reversedDirections();
    ByteTables tables{};
    for (unsigned byte = 0; byte < 4; ++byte)
        for (unsigned value = 0; value < 256; ++value)
            for (unsigned bit = 0; bit < 8; ++bit)
                if ((value >> bit) & 1)
                    for (unsigned d = 0; d < 4; ++d) tables.entry[byte][value][d] ^= v[d][31 - (8 * byte + bit)];
    return tables;
}
inline constexpr ByteTables kTables = makeByteTables();

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

/// A well-mixed 32-bit hash (lowbias32, Wellons 2018).
[[nodiscard]] inline std::uint32_t mix(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x21f0aaadu;
    x ^= x >> 15;
    x *= 0xd35a2d97u;
    return x ^ (x >> 15);
}

}  // namespace sobol

/// The numbers of one sample of one pixel. Even samples belong to half A of the film and odd ones to half B; the halves are
/// scrambled independently, so that their difference is an honest measure of the error.
class Sampler {
  public:
    Sampler(std::uint32_t seed, std::uint32_t pixel, std::uint32_t sample)
        : key_(sobol::mix(sobol::mix(seed * 2 + (sample & 1) + 0x68bc21ebu) ^ sobol::mix(pixel + 0x02e5be93u))),
          reversedIndex_(sobol::reverseBits(sample >> 1)) {}

    /// The block number `block`: well stratified over the samples within itself, independent of all other blocks.
    [[nodiscard]] SampleBlock block(std::uint32_t block) const {
        const std::uint32_t key = sobol::mix(key_ ^ (block * 0x9e3779b9u));
        const std::uint32_t index = sobol::scramble(reversedIndex_, key);
        const auto at = [&](unsigned byte) {
            sobol::Lanes lanes;
            std::memcpy(&lanes, sobol::kTables.entry[byte][(index >> (8 * byte)) & 255], sizeof lanes);
            return lanes;
        };
        const sobol::Lanes point = at(0) ^ at(1) ^ at(2) ^ at(3);
        const sobol::Lanes seeds = {sobol::mix(key + 1), sobol::mix(key + 2), sobol::mix(key + 3), sobol::mix(key + 4)};
        const sobol::Lanes bits = sobol::reverseBits(sobol::scramble(point, seeds)) >> 8;
        const auto number = [&](int i) { return static_cast<float>(static_cast<std::int32_t>(bits[i])) * 0x1p-24f; };
        return {number(0), number(1), number(2), number(3)};
    }

  private:
    std::uint32_t key_, reversedIndex_;
};

}  // namespace glint
