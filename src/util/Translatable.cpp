#include "stromar/util/Translatable.h"
#include "stromar/util/Text.h"
#include <atomic>

namespace stromar {

namespace {
std::atomic<Translator> theTranslator = nullptr;
}

void setTranslator(Translator translator) { theTranslator = translator; }

std::string argumentText(std::string_view text) { return std::string(text); }
std::string argumentText(double number) { return numberText(number); }

std::string translatedWith(std::string_view marked, std::initializer_list<std::string> arguments) {
    const Translator translator = theTranslator;
    const std::string pattern = translator ? translator(marked) : std::string(marked);
    std::string text;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const std::size_t number = pattern[i] == '%' && i + 1 < pattern.size() ? static_cast<std::size_t>(pattern[i + 1] - '1') : 9;
        if (number < arguments.size())
            text += arguments.begin()[number], ++i;
        else
            text += pattern[i];
    }
    return text;
}

} // namespace stromar
