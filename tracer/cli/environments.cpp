#include "tracer/cli/environments.h"

#include <array>

namespace glint {

std::span<const EnvironmentRecipe> environmentRecipes() {
    static constexpr std::array recipes = {
        EnvironmentRecipe{"studio", "dark studio with softboxes", makeStudio},
        EnvironmentRecipe{"sky", "clear afternoon, sun at 42 degrees", makeSky},
        EnvironmentRecipe{"sunset", "sun at 4 degrees, clouds lit from behind", makeSunset},
        EnvironmentRecipe{"overcast", "even clouds, no sun", makeOvercast},
        EnvironmentRecipe{"room", "living room with windows", makeRoom}};
    return recipes;
}

}  // namespace glint
