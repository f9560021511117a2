#pragma once
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/Progress.h"
#include <string>
#include <string_view>
#include <vector>

namespace stromar {

/// Whether a text is a recipe, "bark:birch seed=3", and no path.
bool isRecipe(std::string_view text);

/// Draws what a recipe says. Throws CError, which says what is wrong with it.
TextureMaps drawRecipe(std::string_view recipe, int size, const CProgress& progress);
/// Throws CError when the recipe is wrong.
void checkRecipe(std::string_view recipe);

/// All recipes without own values of a book, "bark" or "leaf": "bark:furrowed", …
std::vector<std::string> plainRecipes(std::string_view book);

} // namespace stromar
