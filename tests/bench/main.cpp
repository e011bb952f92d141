// glint-bench: measurements, one subcommand each. Never a test: a busy machine must not fail a build.
#include <CLI/CLI.hpp>

#include "rays.h"
#include "scenes.h"

int main(int argc, char** argv) {
    CLI::App app("Measures Glint on this machine. Compare ratios within one run, never times of two.", "glint-bench");
    app.require_subcommand(1);
    std::string json;
    glint::bench::SceneBenchOptions scenes;

    CLI::App* rays = app.add_subcommand("rays", "Rays a second on one thread against Embree's sphere points");
    CLI::App* scene = app.add_subcommand("scenes", "Speed, error and efficiency of the path integrator on scenes");
    scene->add_option("FILES", scenes.files, "Scene files")->required()->check(CLI::ExistingFile);
    scene->add_option("--spp", scenes.spp, "Samples a pixel, a power of two")->check(CLI::Range(2, 65536));
    scene->add_option("--threads", scenes.threads, "Threads; 0 is one a processor")->check(CLI::Range(0, 4096));
    scene->add_option("--runs", scenes.runs, "Runs of each scene, in turn; the median counts")->check(CLI::Range(1, 100));
    for (CLI::App* sub : {rays, scene}) sub->add_option("--json", json, "Write the figures to this file as JSON");
    CLI11_PARSE(app, argc, argv);

    return *rays ? glint::bench::runRays(json) : glint::bench::runScenes(scenes, json);
}
