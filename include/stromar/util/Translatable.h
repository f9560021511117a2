#pragma once

/// Marks a text of a table for translation. It stays as it is here; the window translates it when it shows it.
/// `script/translate` tells lupdate to look for this name.
#define N_(text) text
