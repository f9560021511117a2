// The method row of L-systems: growth, organs, bounds, the language of its text.
#include "app/SameModel.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/Methods.h"
#include "stromar/app/Prediction.h"
#include "stromar/params/methods/lsystem/LSystemParams.h"
#include "stromar/tree/lsystem/LSystemBuilder.h"
#include <gtest/gtest.h>
#include <random>

namespace stromar::test {
namespace {

CParams withGrammar(const std::string& grammar, int derivations = 5) {
    CParams params(lsystemBlock());
    lsystem(params).grammar = grammar;
    lsystem(params).derivations = derivations;
    return params;
}

std::vector<Sample> lsystemPresets() {
    std::vector<Sample> found;
    for (const Sample& sample : presets())
        if (&sample.params.block() == &lsystemBlock()) found.push_back(sample);
    return found;
}
} // namespace

TEST(LSystemMethod, TheDefaultIsATree) {
    const auto model = created(CParams(lsystemBlock()));
    EXPECT_GT(model->tree->stemCount(), 100u);
    EXPECT_GT(model->tree->height(), 2);
}

TEST(LSystemMethod, ThePresetsAreTheFiguresAndMore) {
    EXPECT_GE(lsystemPresets().size(), 18u);
}

TEST(LSystemMethod, GrowsTheSameForAnyNumberOfThreads) {
    for (const char* name : {"rowan", "flowering_dogwood", "weeping_beech"})
        EXPECT_EQ(modelDifference(*created(preset(name), detailOf(Model::Full), 1), *created(preset(name), detailOf(Model::Full), 4)), "") << name;
}

TEST(LSystemMethod, WritesTheOrgansOfItsWord) {
    CParams params = withGrammar("axiom: F(2)[+(90)~L(0.5)][&~B(0.25)]F(1)~K(0.125)", 0);
    params.common.season = params.common.fruitMonth;
    const auto tree = growTree(CLSystemBuilder(), params, CProgress());
    ASSERT_EQ(tree->leaves().size(), 1u);
    const CLeaf& leaf = tree->leaves()[0];
    EXPECT_FLOAT_EQ(leaf.length, 0.5f);
    EXPECT_FLOAT_EQ(leaf.width, static_cast<float>(0.5 * params.common.leafScaleX));
    EXPECT_LT(glm::distance(leaf.position, glm::vec3(0, 0, 2)), 1e-6f);
    EXPECT_LT(glm::distance(leaf.axis, glm::vec3(-1, 0, 0)), 1e-6f) << "to the left";
    EXPECT_LT(glm::distance(leaf.normal, glm::vec3(0, -1, 0)), 1e-6f) << "up is its normal";
    EXPECT_EQ(tree->grown(Organ::Blossom).size(), 1u);
    ASSERT_EQ(tree->grown(Organ::Fruit).size(), 1u);
    EXPECT_LT(glm::distance(tree->grown(Organ::Fruit)[0].position, glm::vec3(0, 0, 3)), 1e-6f);
    lsystem(params).grammar = "axiom: F~L";
    params.common.leafScale = 0.3;
    EXPECT_FLOAT_EQ(growTree(CLSystemBuilder(), params, CProgress())->leaves()[0].length, 0.3f) << "without a number";
}

TEST(LSystemMethod, PutsLeavesOnStemsWithoutBranches) {
    CParams params = withGrammar("axiom: F[+F(3)]F[-F]F", 0);
    lsystem(params).stemLeaves = 6;
    lsystem(params).leafDownAngle.value = 90;
    const auto tree = growTree(CLSystemBuilder(), params, CProgress());
    EXPECT_EQ(tree->organs(Organ::Leaf)->countOn(0, 0), 0u) << "the trunk bears branches";
    EXPECT_EQ(tree->organs(Organ::Leaf)->countOn(1, 0), 6u);
    EXPECT_EQ(tree->organs(Organ::Leaf)->countOn(1, 1), 6u);
    ASSERT_EQ(tree->leaves().size(), 12u);
    const CGeneration& branches = tree->generation(1);
    EXPECT_LT(glm::distance(glm::dvec3(tree->leaves()[5].position), branches.segments[0].axisPoint(1)), 1e-6) << "the last at the tip";
    for (const CLeaf& leaf : tree->leaves())
        EXPECT_NEAR(glm::dot(glm::dvec3(leaf.axis), branches.segments[branches.stems[leaf.stem].firstSegment].frame[2]), 0, 1e-6);
}

TEST(LSystemMethod, AChangeOfLeavesKeepsTheStems) {
    CTreeCreator creator;
    CParams params = preset("hazel");
    const auto before = creator.create(params, detailOf(Model::Full), CProgress(2));
    lsystem(params).stemLeaves += 2;
    const auto after = creator.create(params, detailOf(Model::Full), CProgress(2));
    EXPECT_EQ(before->tree->generations(), after->tree->generations());
    EXPECT_GT(after->tree->leaves().size(), before->tree->leaves().size());
    params.common.flare = 1;
    EXPECT_NE(creator.create(params, detailOf(Model::Full), CProgress(2))->tree->base(), after->tree->base());
}

TEST(LSystemMethod, WithoutVariationChanceIsInTheMiddle) {
    CParams params = withGrammar("axiom: F(rand(1,3))", 0);
    for (const int seed : {1, 2}) {
        params.common.seed = seed;
        EXPECT_EQ(growTree(CLSystemBuilder(false), params, CProgress())->generation(0).stems[0].length, 2);
    }
    const double first = growTree(CLSystemBuilder(), params, CProgress())->generation(0).stems[0].length;
    params.common.seed = 3;
    EXPECT_NE(growTree(CLSystemBuilder(), params, CProgress())->generation(0).stems[0].length, first);
}

TEST(LSystemMethod, ModulesAreCountedWithoutBeingDerived) {
    const Grammar plain = parseGrammar("axiom: A(1,10)F\nA(l,w) -> F[A(l,w)]A(l,w)\nF -> FF");
    const auto counts = countModules(plain, 9);
    ASSERT_TRUE(counts);
    const CWord word = CRewriter(plain, 1).derive(9, CProgress());
    std::array<double, 256> derived{};
    for (std::size_t i = 0; i < word.size(); ++i) ++derived[word.symbol(i)];
    EXPECT_EQ(counts->modules, derived);
    EXPECT_EQ(counts->numbers, double(word.numberCount()));
    EXPECT_EQ(counts->bytes(), double(word.bytes()));
    EXPECT_FALSE(countModules(parseGrammar("axiom: A(1)\nA(x) : x < 3 -> A(x+1)A(x)"), 3));
    EXPECT_FALSE(countModules(parseGrammar("axiom: A\nA -> (0.5) AA\nA -> (0.5) F"), 3));
    EXPECT_FALSE(countModules(parseGrammar("axiom: A\nA -> A%A"), 3));
}

TEST(LSystemMethod, ABoundThatTakesLongCanBeCancelled) {
    const CParams params = withGrammar("axiom: A(0)\nA(x) : x < 30 -> F A(x+1) A(x+1)", 22);
    CProgress cancelled;
    cancelled.cancel();
    EXPECT_THROW(predictSize(params, detailOf(Model::Full), cancelled), CCancelled);
    EXPECT_THROW(growTree(CLSystemBuilder(), params, cancelled), CCancelled);
}

// Words without wood, modules of many numbers, and organs without end: all are held in bounds that are known before.
TEST(LSystemMethod, NoWordTakesTheMachinesMemory) {
    std::string many = "B(0";
    for (int i = 0; i < 300; ++i) many += ",0";
    many += ")";
    const auto refusalOf = [](const CParams& params) -> std::string {
        try {
            CTreeCreator(true, {.bytes = 1e9}).create(params, detailOf(Model::Full, 3), CProgress(2));
        } catch (const CError& e) {
            return e.what();
        }
        return "grown";
    };
    EXPECT_NE(refusalOf(withGrammar("axiom: FA\nA -> A A " + many, 21)).find("more than 80000000 numbers"), std::string::npos);
    const std::string leaves = refusalOf(withGrammar("axiom: FA\nA -> A A ~L", 23));
    EXPECT_NE(leaves.find("of memory"), std::string::npos) << leaves;
    const std::string plain = refusalOf(withGrammar("axiom: FA\nA -> A A", 26));
    EXPECT_NE(plain.find("more than 20000000 modules"), std::string::npos) << plain;
}

// Deletes, doubles and swaps letters of good grammars.
TEST(LSystemMethod, BrokenGrammarsCrashNothing) {
    std::mt19937 random(4);
    const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
    const auto samples = lsystemPresets();
    int refused = 0, grown = 0;
    for (int i = 0; i < 300; ++i) {
        CParams params = samples[below(samples.size())].params;
        std::string& text = lsystem(params).grammar;
        for (std::size_t k = 0; k < 1 + below(4); ++k) {
            const std::size_t at = below(text.size());
            switch (below(4)) {
            case 0: text.erase(at, 1 + below(8)); break;
            case 1: text.insert(at, text.substr(below(text.size()), below(12))); break;
            case 2: std::swap(text[at], text[below(text.size())]); break;
            default: text[at] = "()[]<>:*-+/\\&^$!%~#|,.FA01\n"[below(27)]; break;
            }
        }
        lsystem(params).derivations = std::min(lsystem(params).derivations, 6);
        const auto faults = methodOf(params).language->faults(text);
        const bool isWrong = std::ranges::any_of(faults, [](const auto& f) { return f.severity == Severity::Error; });
        try {
            if (predictSize(params, detailOf(Model::Simple)).vertices < 1e6) created(params, detailOf(Model::Simple));
            EXPECT_FALSE(isWrong) << text;
            ++grown;
        } catch (const CError&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 50);
    EXPECT_GT(grown, 20);
}

TEST(LSystemMethod, CardsStandForTwigsOfAllGenerations) {
    CParams params = withGrammar("axiom: F(1)[+F(0.5)~L(0.1)~L~L~L~L~L]F(1)[&F(0.4)[-F(0.5)~L~L~L~L~L~L]F(0.4)~L]~L[/(90)+F(0.3)]F(0.2)");
    const Detail& detail = detailOf(Model::Full, 2);
    const auto model = created(params, detail);
    ASSERT_TRUE(model->cards);
    const StemSet twigs = twigsOf(*model->tree, *model->tree->organs(Organ::Leaf));
    EXPECT_TRUE(twigs.has(1, 0));
    EXPECT_FALSE(twigs.has(1, 1)) << "it has a branch";
    EXPECT_FALSE(twigs.has(1, 2)) << "it bears nothing";
    EXPECT_TRUE(twigs.has(2, 0));
    EXPECT_EQ(model->cards->positions.size() % 2, 0u);
    EXPECT_EQ(model->organs[0]->count(), 2u) << "on stems that are no twigs";
    EXPECT_GT(model->stems[1]->vertexCount(), 0u) << "the branch, and the bare one";
    EXPECT_EQ(model->stems[2]->vertexCount(), 0u);
    lsystem(params).grammar = "axiom: F(1)[+F(0.5)]F(1)[&F(0.4)[-F(0.5)]~L]~L";
    EXPECT_FALSE(created(params, detail)->cards);
}

TEST(GrammarLanguage, ColoursALine) {
    const TextLanguage& language = *treeMethods()[1].language;
    bool inComment = false;
    const std::string line = "A(l) : l > 0.5 -> F(l*r)[+~L] // leaf";
    using Token = TextLanguage::Token;
    std::vector<std::pair<std::string, Token>> found;
    for (const auto& span : language.spans(line, inComment)) found.emplace_back(line.substr(span.first, span.length), span.token);
    const std::vector<std::pair<std::string, Token>> wanted = {
        {"l", Token::Name}, {"0.5", Token::Number}, {"->", Token::Arrow}, {"F", Token::Turtle}, {"l", Token::Name}, {"r", Token::Name},
        {"[", Token::Bracket}, {"+", Token::Turtle}, {"~L", Token::Organ}, {"]", Token::Bracket}, {"// leaf", Token::Comment}};
    EXPECT_EQ(found, wanted);
    language.spans("F /* a comment", inComment);
    EXPECT_TRUE(inComment);
    EXPECT_EQ(language.spans("of two lines */ F", inComment).front().token, Token::Comment);
    EXPECT_FALSE(inComment);
}

TEST(GrammarLanguage, OffersDefinesAsSliders) {
    const TextLanguage& language = *treeMethods()[1].language;
    const std::string text = "#define a 32.5 // 0 .. 90 of the branches\n#define b a*2\n#define c 4\naxiom: F(a)[+(b)F(c)]";
    const auto sliders = language.sliders(text);
    ASSERT_EQ(sliders.size(), 2u) << "b is an expression";
    EXPECT_EQ(sliders[0].name, "a");
    EXPECT_EQ(text.substr(sliders[0].at, sliders[0].length), "32.5");
    EXPECT_EQ(sliders[0].low, 0);
    EXPECT_EQ(sliders[0].high, 90);
    EXPECT_EQ(sliders[0].words, "of the branches");
    EXPECT_EQ(sliders[1].high, 8) << "twice its value";
    const auto words = language.words(text + "\nA -> (");
    for (const char* word : {"a", "b", "c", "rand", "~L", "#define"}) EXPECT_TRUE(std::ranges::count(words, word)) << word;
}

TEST(GrammarLanguage, TellsTheStepsOfAWord) {
    const CParams params = withGrammar("axiom: A\nA -> F[+A]A\nF -> FF", 12);
    const TextLanguage& language = *methodOf(params).language;
    const TextLanguage::Step second = language.step(params, 2, CProgress());
    EXPECT_EQ(second.shown, "FF[+F[+A]A]F[+A]A");
    EXPECT_EQ(second.more, 0u);
    EXPECT_EQ(second.applied, (std::vector<std::pair<int, std::size_t>>{{2, 4}, {3, 4}}));
    EXPECT_GT(language.step(params, 12, CProgress()).more, 10000u);
    CProgress cancelled;
    cancelled.cancel();
    EXPECT_THROW(language.step(params, 12, cancelled), CCancelled);
}

TEST(GrammarLanguage, KnowsWhichLineWroteWhat) {
    const CParams params = withGrammar("axiom: F A\nA -> F[+B]A\nB -> F(0.5)\nF(l) -> F(l*1.1)", 4);
    const auto tree = growTree(CLSystemBuilder(), params, CProgress());
    const TextLanguage& language = *methodOf(params).language;
    EXPECT_EQ(language.lineOf(params, *tree, 0, 0), 1) << "the trunk starts in the axiom";
    EXPECT_EQ(language.lineOf(params, *tree, 1, 0), 3) << "what grows on is written by what it was";
    const auto trunk = language.writtenBy(params, *tree, 2), twigs = language.writtenBy(params, *tree, 3);
    EXPECT_EQ(trunk[0].size(), 4u);
    EXPECT_TRUE(trunk[1].empty());
    EXPECT_TRUE(twigs[0].empty());
    EXPECT_EQ(twigs[1].size(), 3u);
}

} // namespace stromar::test
