#include "window/Settings.h"
#include "window/Languages.h"
#include "view/Navigation.h"
#include "window/QtText.h"
#include "stromar/util/Translatable.h"
#include <QLocale>
#include <QSettings>
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
using Words = std::vector<SettingWord>;

Words themes() {
    return {{QStringLiteral("system"), trText(N_("As the system"))},
            {QStringLiteral("light"), trText(N_("Light"))},
            {QStringLiteral("dark"), trText(N_("Dark"))}};
}
Words languages() {
    Words words{{QStringLiteral("system"), trText(N_("As the system"))}};
    for (const Language& language : languageTable())
        words.push_back({QString::fromLatin1(language.code), QString::fromUtf8(language.name)});
    return words;
}
Words navigations() {
    Words words;
    for (const Navigation& n : navigationTable()) words.push_back({QString::fromLatin1(n.name), trText(n.label)});
    return words;
}
Words units() { return {{QStringLiteral("m"), trText(N_("Metres"))}, {QStringLiteral("ft"), trText(N_("Feet"))}}; }

// clang-format off
constexpr Setting kSettings[] = {
    {"theme", N_("Theme"), N_("Light or dark windows."), Setting::Kind::Choice, "", 0, 0, 0, "system", themes},
    {"language", N_("Language"), N_("The language of menus, parameters and help."), Setting::Kind::Choice, "", 0, 0, 0, "system", languages},
    {"navigation", N_("Mouse in the picture"), N_("Which buttons turn, move and zoom. The wheel always zooms."), Setting::Kind::Choice, "", 0, 0, 0, "stromar", navigations},
    {"units", N_("Lengths in"), N_("The unit of lengths in the window. Files are always in metres."), Setting::Kind::Choice, "", 0, 0, 0, "m", units},
    {"fullModelDelay", N_("Full model after"), N_("How long the hand rests before the full model follows the simple one."), Setting::Kind::Number, N_(" ms"), 0, 10000, 50, "350", nullptr},
    {"threads", N_("Threads"), N_("How many processors grow the tree; 0 takes all."), Setting::Kind::Number, "", 0, 256, 1, "0", nullptr, N_("automatic")},
    {"maxMemory", N_("Memory for a tree"), N_("The most that a tree may take while it is made; 0 is half of what is free."), Setting::Kind::Number, N_(" GB"), 0, 1024, 1, "0", nullptr, N_("automatic")},
    {"pictureCache", N_("Picture cache"), N_("The most that cached textures and thumbnails may take on the disk. The oldest beyond it are removed."), Setting::Kind::Number, N_(" MB"), 16, 65536, 64, "512", nullptr},
    {"autosave", N_("Autosave every"), N_("How often changes are kept aside against a crash; 0 never."), Setting::Kind::Number, N_(" s"), 0, 3600, 5, "30", nullptr, N_("never")},
};
// clang-format on

QString storedKey(const char* key) { return QStringLiteral("preferences/") + QLatin1String(key); }
} // namespace

std::span<const Setting> settingTable() { return kSettings; }

const Setting& settingOf(std::string_view key) {
    return *std::ranges::find_if(kSettings, [&](const Setting& s) { return key == s.key; });
}

CSettings& CSettings::instance() {
    static CSettings settings;
    return settings;
}

QString CSettings::text(const char* key) const {
    return QSettings().value(storedKey(key), QString::fromLatin1(settingOf(key).standard)).toString();
}

int CSettings::number(const char* key) const {
    const Setting& setting = settingOf(key);
    bool fine = false;
    const int stored = text(key).toInt(&fine);
    return fine ? std::clamp(stored, setting.min, setting.max) : QByteArray(setting.standard).toInt();
}

void CSettings::set(const char* key, const QString& value) {
    if (text(key) == value) return;
    QSettings().setValue(storedKey(key), value);
    emit changed(QString::fromLatin1(key));
}

LengthUnit lengthUnit() {
    if (CSettings::instance().text("units") == QLatin1String("ft")) return {1 / 0.3048, QStringLiteral("ft")};
    return {1, QStringLiteral("m")};
}

QString lengthText(double metres) {
    const LengthUnit unit = lengthUnit();
    const double value = metres * unit.perMetre;
    const int decimals = value >= 10 ? 1 : value >= 1 ? 2 : value >= 0.1 ? 3 : 4;
    return QStringLiteral("%1 %2").arg(QLocale().toString(value, 'f', decimals), unit.name);
}

QString captionOf(const ParamInfo& info, double value) {
    if (!info.words.empty())
        return trText(info.words[static_cast<std::size_t>(value)]).replace(QLatin1Char('-'), QLatin1Char(' '));
    const bool metres = info.unit == Unit::Metre;
    const LengthUnit unit = lengthUnit();
    const double fine = std::pow(10, info.decimals), shown = std::round(value * (metres ? unit.perMetre : 1) * fine) / fine;
    return QLocale().toString(shown, 'f', QLocale::FloatingPointShortest) +
           (metres ? QLatin1Char(' ') + unit.name : trText(unitName(info.unit)));
}

} // namespace stromar
