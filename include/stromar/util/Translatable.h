#pragma once
#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>

/// Marks a text of a table for translation. It stays as it is here; the window translates it when it shows it.
/// `script/translate` tells lupdate to look for this name.
#define N_(text) text
/// The same inside of a class or of a function of one, where lupdate would take the class for the context: NC_("stromar", "…").
#define NC_(context, text) text

namespace stromar {

/// Gives a text that is marked N_() or NC_() in the user's language.
using Translator = std::string (*)(std::string_view marked);

/// For the whole program, from any thread; without one everything is said in English. nullptr takes it away.
void setTranslator(Translator translator);

/// An argument as it is said: whole numbers whole, others as in a file.
std::string argumentText(std::string_view text);
std::string argumentText(double number);
template <std::integral Number> std::string argumentText(Number number) { return std::to_string(number); }

/// The translation of `marked` with %1 … %9 replaced by `arguments`.
std::string translatedWith(std::string_view marked, std::initializer_list<std::string> arguments);

/// What is said to the user of a fault, in the user's language: translated(NC_("stromar", "no file %1"), name).
template <class... Arguments> std::string translated(std::string_view marked, const Arguments&... arguments) {
    return translatedWith(marked, {argumentText(arguments)...});
}

} // namespace stromar
