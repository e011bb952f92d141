// How many samples a pass is to bring the pixels of a film to.
#pragma once

#include <cstdint>
#include <vector>

namespace glint {

/// Samples by cell of `cell` x `cell` pixels of a film, row-major.
struct CellGoals {
    int cell = 1, columns = 0;
    std::vector<std::uint32_t> samples;

    [[nodiscard]] bool empty() const { return samples.empty(); }
    [[nodiscard]] std::uint32_t at(int x, int y) const {
        return samples[static_cast<std::size_t>(y / cell) * static_cast<std::size_t>(columns) +
                       static_cast<std::size_t>(x / cell)];
    }
};

struct SampleGoal {
    std::uint32_t samples = 1;  ///< that every pixel is to have, unless `cells` says it by cell
    const CellGoals* cells = nullptr;
    std::uint32_t most = ~0u;  ///< new samples that a pixel gets in this pass
};

}  // namespace glint
