#include "Checkout.h"

namespace stromar::test {

namespace {
std::string inFolder(const char* folder, const std::string& path) { return path.empty() ? folder : std::string(folder) + '/' + path; }
} // namespace

std::string inSource(const std::string& path) { return inFolder(STROMAR_SOURCE, path); }
std::string inBin(const std::string& program) { return inFolder(STROMAR_BIN, program); }

} // namespace stromar::test
