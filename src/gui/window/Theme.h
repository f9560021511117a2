#pragma once
#include <QString>

namespace stromar {

/// Gives the application Fusion and the palette of a theme of the preferences: "system", "light", "dark".
void applyTheme(const QString& theme);

} // namespace stromar
