#include "tracer/math/sobol.h"

#include <cstring>

namespace glint {

namespace {

using namespace sobol;

using Lanes = std::uint32_t __attribute__((vector_size(16)));

/// Direction numbers of the first four dimensions with their bits reversed, as the scrambling hash
/// wants them.
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

/// XOR of direction numbers for every value of each byte of the bit-reversed index; four dimensions
/// side by side.
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
                    for (unsigned d = 0; d < 4; ++d)
                        tables.entry[byte][value][d] ^= v[d][31 - (8 * byte + bit)];
    return tables;
}
inline constexpr ByteTables kTables = makeByteTables();

/// The point with a bit-reversed index, its coordinates bit-reversed too.
inline Lanes pointAt(std::uint32_t index) {
    const auto at = [&](unsigned byte) {
        Lanes lanes;
        std::memcpy(&lanes, kTables.entry[byte][(index >> (8 * byte)) & 255], sizeof lanes);
        return lanes;
    };
    return at(0) ^ at(1) ^ at(2) ^ at(3);
}

/// 24 bits to [0, 1).
inline float numberOf(std::uint32_t bits) {
    return static_cast<float>(static_cast<std::int32_t>(bits)) * 0x1p-24f;
}

[[gnu::always_inline]] inline SampleBlock makeBlock(std::uint32_t key,
                                                    std::uint32_t reversedIndex) {
    const Lanes point = pointAt(scramble(reversedIndex, key)), seeds = mix(key + Lanes{1, 2, 3, 4});
    const Lanes bits = reverseBits(scramble(point, seeds)) >> 8;
    return {numberOf(bits[0]), numberOf(bits[1]), numberOf(bits[2]), numberOf(bits[3])};
}

[[gnu::always_inline]] inline std::array<SampleBlock, 2> makeBlocks(std::uint32_t first,
                                                                    std::uint32_t second,
                                                                    std::uint32_t reversedIndex) {
    return {makeBlock(first, reversedIndex), makeBlock(second, reversedIndex)};
}

/// The same integers on every processor; AVX2 multiplies them in fewer steps (42 against 30 ns a
/// block).
struct Makers {
    SampleBlock (*one)(std::uint32_t, std::uint32_t);
    std::array<SampleBlock, 2> (*two)(std::uint32_t, std::uint32_t, std::uint32_t);
};
SampleBlock makeBlockAnywhere(std::uint32_t key, std::uint32_t index) {
    return makeBlock(key, index);
}
std::array<SampleBlock, 2> makeBlocksAnywhere(std::uint32_t a, std::uint32_t b,
                                              std::uint32_t index) {
    return makeBlocks(a, b, index);
}
#if defined(__x86_64__)
__attribute__((target("avx2"))) SampleBlock makeBlockAvx2(std::uint32_t key, std::uint32_t index) {
    return makeBlock(key, index);
}
__attribute__((target("avx2"))) std::array<SampleBlock, 2> makeBlocksAvx2(std::uint32_t a,
                                                                          std::uint32_t b,
                                                                          std::uint32_t index) {
    return makeBlocks(a, b, index);
}
const Makers kMakers = __builtin_cpu_supports("avx2")
                           ? Makers{makeBlockAvx2, makeBlocksAvx2}
                           : Makers{makeBlockAnywhere, makeBlocksAnywhere};
#else
const Makers kMakers{makeBlockAnywhere, makeBlocksAnywhere};
#endif

}  // namespace

SampleBlock Sampler::block(std::uint32_t block) const {
    return kMakers.one(keyOf(block), reversedIndex_);
}

std::array<SampleBlock, 2> Sampler::blocks(std::uint32_t first, std::uint32_t second) const {
    return kMakers.two(keyOf(first), keyOf(second), reversedIndex_);
}

}  // namespace glint
