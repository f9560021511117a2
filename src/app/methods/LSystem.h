#pragma once
#include "stromar/app/TextLanguage.h"

namespace stromar {

/// The language of grammars.
const TextLanguage& lsystemLanguage();

} // namespace stromar
