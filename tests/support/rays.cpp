#include "tests/support/rays.h"

#include <algorithm>
#include <thread>
#include <vector>

#include "tracer/render/worker_pool.h"

namespace glint::test {

Tally tallyInParallel(std::uint64_t total, std::uint64_t seed,
                      const std::function<Tally(Random&, std::uint64_t)>& piece) {
    const std::uint64_t pieces = std::clamp<std::uint64_t>(total / 4096, 1, 1024);
    std::vector<Tally> tallies(pieces);
    WorkerPool pool(static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
    pool.run(static_cast<int>(pieces), [&](int, int index) {
        const auto i = static_cast<std::uint64_t>(index);
        Random random(seed, i + 1);
        tallies[i] = piece(random, total * (i + 1) / pieces - total * i / pieces);
    });
    Tally sum;
    for (const Tally& tally : tallies) sum.add(tally);
    return sum;
}

}  // namespace glint::test
