#pragma once
#include <string>

namespace stromar::test {

/// A file of this checkout, "presets/apple.tree": absolute, as tests start programs in other folders. Functions, for a compiler's
/// cache finds the objects of the tests again in another checkout only if no path of this one is in them.
std::string inSource(const std::string& path = "");
/// A program that was built, "stromar-cli"; without a name the folder of all.
std::string inBin(const std::string& program = "");

} // namespace stromar::test
