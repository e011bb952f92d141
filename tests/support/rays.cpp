#include "tests/support/rays.h"

#include <algorithm>
#include <cstdlib>
#include <thread>
#include <utility>
#include <vector>

#include "tracer/render/worker_pool.h"

namespace glint::test {

namespace {

/// Of the running test: all that it has printed, and the share of its counts that was asked for.
Tally printed;
double share = 1;

}  // namespace

void Tally::print(const std::string& what) const {
    std::printf("    %-34s %12" PRIu64 " checks, %" PRIu64 " failures, worst %.3g\n", what.c_str(),
                checks, failures, worst);
    std::fflush(stdout);  // A full test takes minutes.
    printed.add(*this);
}

void FullRun::SetUp() {
    if (!fullRun()) GTEST_SKIP() << "a long test; set GLINT_FULL=1";
    printed = {};
    const double asked = std::atof(std::getenv("GLINT_FULL"));
    share = asked > 0 && asked < 1 ? asked : 1;
    start_ = std::chrono::steady_clock::now();
}

void FullRun::TearDown() {
    const double counts = std::exchange(share, 1);
    if (IsSkipped()) return;
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    const std::string name = std::string(test->test_suite_name()) + "." + test->name();
    std::printf("    %s: %" PRIu64 " checks, %" PRIu64 " failures in %.0f s\n", name.c_str(),
                printed.checks, printed.failures, seconds);
    const char* path = std::getenv("GLINT_RECORD");
    std::FILE* record = path ? std::fopen(path, "a") : nullptr;
    if (!record) return;
    std::fprintf(record, "%s\t%" PRIu64 "\t%" PRIu64 "\t%.3g\t%s\t%.1f\t%g\n", name.c_str(),
                 printed.checks, printed.failures, printed.worst,
                 HasFailure() ? "FAILED" : "passed", seconds, counts);
    std::fclose(record);
}

std::uint64_t askedOf(std::uint64_t count) {
    return std::max<std::uint64_t>(1,
                                   static_cast<std::uint64_t>(share * static_cast<double>(count)));
}

Tally tallyInParallel(std::uint64_t total, std::uint64_t seed,
                      const std::function<Tally(Random&, std::uint64_t)>& piece) {
    total = askedOf(total);
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
