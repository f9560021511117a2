#pragma once
#include <cstdlib>
#include <gtest/gtest.h>

namespace stromar::test {

/// For SetUp(): without a foreign program its tests are skipped, where CI is set they fail.
inline void needTool(bool installed, const char* name) {
    if (installed) return;
    const char* ci = std::getenv("CI");
    if (ci && *ci) FAIL() << name << " is not installed";
    GTEST_SKIP() << name << " is not installed";
}

} // namespace stromar::test
