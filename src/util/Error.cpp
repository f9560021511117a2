#include "stromar/util/Error.h"
#include "stromar/util/Translatable.h"

namespace stromar {

namespace {
std::string join(const Messages& messages) {
    std::string all;
    for (const Message& m : messages) all += (all.empty() ? "" : "\n") + m.toString();
    return all;
}
} // namespace

std::string Message::toString() const {
    std::string place = file;
    if (line > 0) place += ":" + std::to_string(line) + ":" + std::to_string(column);
    return place + (place.empty() ? "" : ": ") + translated(severity == Severity::Error ? NC_("stromar", "error") : NC_("stromar", "warning")) + ": " + text;
}

CInputError::CInputError(Messages messages) : CError(join(messages)), m_messages(std::move(messages)) {}

} // namespace stromar
