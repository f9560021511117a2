#include "params/Support.h"
#include "stromar/util/FileSet.h"
#include <array>
#include <gtest/gtest.h>
#include <random>

namespace stromar {
namespace {

using test::otherValue;

class CMutator {
public:
    explicit CMutator(std::uint32_t seed) : m_random(seed) {}

    /// 1 to 6 changes: bytes, pieces that mean something to the reader, lost and doubled parts.
    std::string mutated(std::string text) {
        for (std::size_t changes = below(6) + 1; changes > 0; --changes) {
            const std::size_t at = below(text.size() + 1);
            switch (below(5)) {
            case 0: text.insert(at, 1, static_cast<char>(below(256))); break;
            case 1: text.insert(at, kPieces[below(kPieces.size())]); break;
            case 2: text.erase(at, below(40)); break;
            case 3: text.insert(at, text.substr(below(text.size() + 1), below(40))); break;
            default:
                if (at < text.size()) text[at] = static_cast<char>(32 + below(95));
            }
        }
        return text;
    }
    std::size_t below(std::size_t bound) { return std::uniform_int_distribution<std::size_t>(0, bound - 1)(m_random); }

private:
    static constexpr std::array<const char*, 16> kPieces{
        "\"",          "\"\"",  "#",    " # ",          "=",
        "\n",          "\r",    "\r\n", "\xEF\xBB\xBF", "\xC5\x99",
        "\nScale = ",  "1e999", "-",    "\t",           "\nSpecies = \"",
        "\nBend = 1\n"};
    std::mt19937 m_random;
};

void expectSane(const CTreeFile& file, const std::string& text) {
    ASSERT_TRUE(file.text(file.params()) == text) << "an unchanged document changed:\n" << text;
    for (const ParamRef& ref : numberParams(file.params().block())) ASSERT_TRUE(ref.info->range.contains(ref.get(file.params()))) << ref.key();
}

/// Changes one number and one text of what was read, saves and reads again.
void expectSavable(const CTreeFile& file, CMutator& mutator, const std::string& text) {
    const auto numbers = numberParams(file.params().block());
    const ParamRef ref = numbers[mutator.below(numbers.size())];
    CParams params = file.params();
    ref.set(params, otherValue(*ref.info, ref.get(params)));
    params.text.species = mutator.below(2) ? "Elm # 8" : "";
    params.text.leafTexture = "leaf.png";
    const std::string saved = file.text(params);
    try {
        ASSERT_TRUE(CTreeFile::parse(saved, "saved").params() == params) << ref.key() << " set in\n"
                                                                         << text << "\n---\n"
                                                                         << saved;
    } catch (const CInputError& error) {
        FAIL() << error.what() << "\nafter " << ref.key() << " was set in\n" << text << "\n---\n" << saved;
    }
}

TEST(TreeFileFuzz, BrokenFilesAreReadOrRefused) {
    int read = 0, refused = 0;
    for (const auto& path : test::presetFiles()) {
        const std::string preset = readFile(path);
        CMutator mutator(static_cast<std::uint32_t>(preset.size()));
        for (int i = 0; i < 1500 && !testing::Test::HasFatalFailure(); ++i) {
            const std::string text = mutator.mutated(preset);
            try {
                const CTreeFile file = CTreeFile::parse(text, "fuzz");
                ++read;
                expectSane(file, text);
                if (!HasFatalFailure()) expectSavable(file, mutator, text);
            } catch (const CInputError& error) {
                ++refused;
                ASSERT_FALSE(error.messages().empty());
                for (const Message& message : error.messages()) ASSERT_FALSE(message.text.empty());
            }
        }
    }
    EXPECT_GT(read, 500);
    EXPECT_GT(refused, 500);
}

TEST(TreeFileFuzz, NoiseIsReadOrRefused) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> byte(0, 255), size(0, 300);
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        std::string text(static_cast<std::size_t>(size(random)), ' ');
        for (char& c : text) c = static_cast<char>(i % 2 ? byte(random) : 9 + byte(random) % 118);
        try {
            expectSane(CTreeFile::parse(text, "noise"), text);
        } catch (const CInputError&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 2000);
}

} // namespace
} // namespace stromar
