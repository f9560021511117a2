#pragma once
#include <QString>
#include <span>

class QCoreApplication;

namespace stromar {

/// A language the window speaks, in translations/stromar_<code>.ts; English has only its plurals there.
struct Language {
    const char* code;
    const char* name; ///< in itself, UTF-8
};

std::span<const Language> languageTable();
/// The code of the language to use for a wish of the preferences ("system" or a code).
QString chosenLanguage(const QString& wish);
/// Makes tr() speak the language from now on; texts that exist already stay. False when its file is missing.
bool speak(const QString& code);

} // namespace stromar
