// glint-make-env FOLDER [WIDTH]: writes the environment pictures of resources/env.
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <string>

#include "tracer/cli/environments.h"
#include "tracer/io/film_exr.h"

namespace {

using namespace glint;

ExrFile toExr(const Image& image, std::string_view description) {
    ExrFile file{image.width, image.height, {}, {{"comments", std::string(description)}}};
    const char* names[3] = {"R", "G", "B"};
    for (std::size_t k = 0; k < 3; ++k) {
        ExrChannel channel{names[k], {}};
        for (std::size_t i = k; i < image.rgb.size(); i += 3)
            channel.values.push_back(image.rgb[i]);
        file.channels.push_back(std::move(channel));
    }
    return file;
}

}  // namespace

int main(int argc, char** argv) {
    int width = kEnvironmentWidth;
    if (argc == 3) {
        const std::string_view text = argv[2];
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), width);
        if (error != std::errc() || end != text.data() + text.size() || width < 2 ||
            width > 16384 || width % 2)
            argc = 0;
    }
    if (argc != 2 && argc != 3) {
        std::fputs("usage: glint-make-env FOLDER [WIDTH]   (an even number; 1024 if not given)\n",
                   stderr);
        return 1;
    }
    for (const EnvironmentRecipe& recipe : environmentRecipes()) {
        const std::filesystem::path path =
            std::filesystem::path(argv[1]) / (std::string(recipe.name) + ".exr");
        if (const Status saved = saveExr(path, toExr(recipe.make(width), recipe.description));
            !saved) {
            std::fprintf(stderr, "%s\n", saved.error().text().c_str());
            return 3;
        }
        std::printf("%s: %s\n", path.c_str(), std::string(recipe.description).c_str());
    }
    return 0;
}
