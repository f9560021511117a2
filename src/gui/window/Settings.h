#pragma once
#include "stromar/params/ParamTable.h"
#include <QObject>
#include <QVariant>
#include <span>
#include <string_view>
#include <vector>

namespace stromar {

/// A word of a choice, as stored, and its text.
struct SettingWord {
    QString word, text;
};

/// One row of the table of preferences: the dialog, the stored values and their defaults are loops over it.
struct Setting {
    enum class Kind { Choice, Number };

    const char* key;
    const char* label; ///< marked for translation, as the next two
    const char* help;
    Kind kind;
    const char* unit;                    ///< of a number
    int min, max, step;                  ///< of a number
    const char* standard;                ///< default, as text
    std::vector<SettingWord> (*words)(); ///< of a choice
    const char* whenZero = "";           ///< what a number says instead of 0; marked for translation
};

std::span<const Setting> settingTable();
const Setting& settingOf(std::string_view key);

/// The preferences of the user, kept by the system between runs.
class CSettings : public QObject {
    Q_OBJECT
public:
    static CSettings& instance();

    QString text(const char* key) const;
    int number(const char* key) const;
    /// Tells only when it changes something.
    void set(const char* key, const QString& value);

signals:
    void changed(const QString& key);
};

/// Metres as the user wants to read them.
struct LengthUnit {
    double perMetre;
    QString name;
};
LengthUnit lengthUnit();
/// A number of a row as people read it: a word, or in the unit that is shown, with no more decimals than its editor.
QString captionOf(const ParamInfo& info, double value);
/// "12.3 m" or "40.4 ft".
QString lengthText(double metres);

} // namespace stromar
