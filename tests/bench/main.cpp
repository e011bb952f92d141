// glint-bench: measurements, one subcommand each. Never a test: a busy machine must not fail a
// build.
#include <cstdio>

#include "tests/bench/choices.h"
#include "tests/bench/environment.h"
#include "tests/bench/error.h"
#include "tests/bench/filter.h"
#include "tests/bench/peers/peers.h"
#include "tests/bench/rays.h"
#include "tests/bench/scale.h"
#include "tests/bench/scenes.h"
#include "tests/bench/skip.h"
#include "tests/bench/startup.h"
#include "tests/bench/viewport.h"
#include "tracer/base/heap.h"

int main(int argc, char** argv) {
    glint::keepFreedMemory();
    using namespace glint::bench;
    CLI::App app(
        "Measures Glint on this machine. Compare ratios within one run, never times of two.",
        "glint-bench");
    app.require_subcommand(1);
    const std::vector<Command> commands = {
        errorCommand(app),   raysCommand(app),     skipCommand(app),       scaleCommand(app),
        scenesCommand(app),  peersCommand(app),    filterCommand(app),     choicesCommand(app),
        startupCommand(app), viewportCommand(app), environmentCommand(app)};
    CLI11_PARSE(app, argc, argv);
    std::setvbuf(stdout, nullptr, _IOLBF,
                 0);  // Long measurements are watched, also through a pipe.
    for (const Command& command : commands)
        if (*command.app) return command.run();
    return kBadArguments;
}
