// One subcommand of glint-bench: a file of its own that adds itself to the command line (see
// main.cpp).
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace glint::bench {

/// Exit codes: 0, or what went wrong.
enum ExitCode { kOk = 0, kBadArguments = 1, kBadScene = 2, kCannotWrite = 3, kFailed = 4 };

struct Command {
    CLI::App* app = nullptr;
    std::function<int()> run;  ///< after parsing; answers with the exit code
};

}  // namespace glint::bench
