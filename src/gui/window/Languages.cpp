#include "window/Languages.h"
#include "stromar/util/Translatable.h"
#include "window/QtText.h"
#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <algorithm>
#include <memory>

namespace stromar {

namespace {
constexpr Language kLanguages[] = {{"en", "English"}, {"cs", "Čeština"}, {"sl", "Slovenščina"}, {"ru", "Русский"}};

bool known(const QString& code) {
    return std::ranges::any_of(kLanguages, [&](const Language& l) { return code == QLatin1String(l.code); });
}

std::unique_ptr<QTranslator> install(const QString& file, const QString& folder) {
    auto translator = std::make_unique<QTranslator>();
    if (!translator->load(file, folder)) return nullptr;
    QCoreApplication::installTranslator(translator.get());
    return translator;
}
} // namespace

std::span<const Language> languageTable() { return kLanguages; }

QString chosenLanguage(const QString& wish) {
    if (known(wish)) return wish;
    for (const QString& name : QLocale::system().uiLanguages())
        if (const QString code = name.section(QLatin1Char('-'), 0, 0); known(code)) return code;
    return QStringLiteral("en");
}

bool speak(const QString& code) {
    static std::unique_ptr<QTranslator> own, buttons; // ours, and Qt's own for its dialogs
    own.reset();
    buttons.reset();
    QLocale::setDefault(QLocale(code));
    if (code != QLatin1String("en"))
        buttons = install(QStringLiteral("qtbase_") + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    own = install(QStringLiteral("stromar_") + code, QStringLiteral(":/translations"));
    setTranslator([](std::string_view marked) { return trText(marked).toStdString(); });
    return own != nullptr;
}

} // namespace stromar
