// The language of L-systems, its derivations, and what the turtle draws of them.
#include "stromar/tree/lsystem/TurtleStems.h"
#include "tree/LSystemFigures.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace stromar {
namespace {

std::string derived(std::string_view grammar, int times, std::uint64_t seed = 1, int threads = 2) {
    const Grammar read = parseGrammar(grammar);
    const CWord word = CRewriter(read, seed).derive(times, CProgress(threads));
    return word.text(0, word.size());
}

/// The first message of a grammar that cannot be read: "line:column: text".
std::string faultOf(std::string_view grammar) {
    try {
        parseGrammar(grammar);
    } catch (const CInputError& e) {
        const Message& m = e.messages().front();
        return std::to_string(m.line) + ":" + std::to_string(m.column) + ": " + m.text;
    }
    return "none";
}

double valueOf(const std::string& expression) {
    return parseGrammar("#define a 3\naxiom: F(" + expression + ")").axiom[0].numbers[0].constant().value();
}

TurtlePath drawn(const Figure& figure) {
    const Grammar grammar = parseGrammar(figure.defines + std::string(figure.rules));
    TurtleParams params;
    params.tropism = zUp(figure.tropism);
    params.tropismBend = figure.bend;
    return interpret(CRewriter(grammar, 1).derive(figure.steps, CProgress(2)), params, CProgress());
}
} // namespace

TEST(LSystem, DrawsTheFiguresOfTheBook) {
    for (const Figure& figure : kFigures) {
        SCOPED_TRACE(figure.name);
        const TurtlePath path = drawn(figure);
        ASSERT_EQ(path.segments.size(), figure.segments);
        double length = 0, maxWidth = 0, minWidth = 1e9;
        glm::dvec3 low(0), high(0);
        for (const TurtleSegment& s : path.segments) {
            length += s.length;
            maxWidth = std::max(maxWidth, s.width);
            minWidth = std::min(minWidth, s.width);
            for (const glm::dvec3& end : {s.position, s.position + s.length * s.frame[2]}) {
                low = glm::min(low, yUp(end));
                high = glm::max(high, yUp(end));
            }
            ASSERT_NEAR(glm::determinant(s.frame), 1, 1e-9);
        }
        const double size = figure.high.y, near = 1e-4 * size + 6e-4; // as they are printed
        EXPECT_NEAR(length, figure.length, 1e-4 * figure.length);
        EXPECT_NEAR(maxWidth, figure.maxWidth, 1e-4 * figure.maxWidth);
        EXPECT_NEAR(minWidth, figure.minWidth, 1e-4 * figure.minWidth);
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(low[k], figure.low[k], near) << k;
            EXPECT_NEAR(high[k], figure.high[k], near) << k;
        }
    }
}

TEST(LSystem, CountsOfTheBook) {
    const auto counts = [](const Figure& figure) {
        const Grammar grammar = parseGrammar(figure.defines + std::string(figure.rules));
        const CWord word = CRewriter(grammar, 1).derive(figure.steps, CProgress(2));
        std::map<Symbol, int> all;
        for (std::size_t i = 0; i < word.size(); ++i) ++all[word.symbol(i)];
        return all;
    };
    const auto honda = counts(kFigures[0]), aono = counts(kFigures[4]), ternary6 = counts(kFigures[8]);
    EXPECT_EQ(honda.at('A'), 1);
    EXPECT_EQ(honda.at('B'), 341);
    EXPECT_EQ(honda.at('C'), 682);
    EXPECT_EQ(aono.at('B'), 1024);
    EXPECT_EQ(ternary6.at('A'), 729);
    EXPECT_EQ(ternary6.at('!'), 365);
    EXPECT_EQ(honda.at('['), honda.at(']'));
}

TEST(LSystem, ExpressionsBindAsUsual) {
    EXPECT_EQ(valueOf("1+2*3"), 7);
    EXPECT_EQ(valueOf("(1+2)*3"), 9);
    EXPECT_EQ(valueOf("-2^2"), -4);
    EXPECT_EQ(valueOf("2^3^2"), 512);
    EXPECT_EQ(valueOf("2^-1"), 0.5);
    EXPECT_EQ(valueOf("10-4-3"), 3);
    EXPECT_EQ(valueOf("8/4/2"), 1);
    EXPECT_EQ(valueOf("a*2"), 6);
    EXPECT_EQ(valueOf("\u22122"), -2);
    EXPECT_EQ(valueOf("1.5e1"), 15);
    EXPECT_EQ(valueOf("1<2 && !(3<=2) || 0"), 1);
    EXPECT_EQ(valueOf("3==3 && 3!=4 && 4>=4 && 5>4"), 1);
    EXPECT_NEAR(valueOf("sin(30)+cos(60)+tan(45)"), 2, 1e-12);
    EXPECT_NEAR(valueOf("atan2(1,1)"), 45, 1e-12);
    EXPECT_EQ(valueOf("min(2,max(1,5))+floor(2.7)+abs(-3)+sqrt(16)+pow(2,5)"), 2 + 2 + 3 + 4 + 32);
    EXPECT_NEAR(valueOf("log(exp(2))"), 2, 1e-12);
}

TEST(LSystem, RewritesAllModulesAtOnce) {
    EXPECT_EQ(derived("axiom: A\nA -> AB\nB -> A", 5), "ABAABABAABAAB");
    EXPECT_EQ(derived("axiom: A(3)\nA(n) : n > 0 -> F(n)A(n-1)", 5), "F(3)F(2)F(1)A(0)") << "copied without a match";
    EXPECT_EQ(derived("axiom: A(1)A(1,2)\nA(x) -> B(x)\nA(x,y) -> C(x+y)", 1), "B(1)C(3)") << "by their numbers";
    EXPECT_EQ(derived("axiom: A\nA : * -> F\nA -> f", 1), "F") << "the first that matches";
    EXPECT_EQ(derived("axiom: FA\nA ->", 1), "F");
    EXPECT_EQ(derived("axiom: !(1)A\n!(w) -> !(w*2)", 3), "!(8)A") << "turtle letters have productions too";
    EXPECT_EQ(derived("axiom: ~L(1)\n~L(s) -> ~L(s+1)[~B]", 1), "~L(2)[~B]");
}

TEST(LSystem, NotationsOfTheArticle) {
    for (const char* arrow : {"->", "-->", "\u2192", "\u27f6"})
        for (const char* condition : {" : *", " : * ", "", " :"})
            EXPECT_EQ(derived(std::string("\u03c9 : A\np1: A") + condition + arrow + " F A", 2), "FFA") << condition << arrow;
    EXPECT_EQ(derived("axiom: A /* a comment\n over lines */ B\nA -> F // the rest\n", 1), "FB");
    EXPECT_EQ(derived("axiom: A\nA -> F\n  [+A]\n\t-A", 1), "F[+A]-A") << "lines that start with a blank go on";
    EXPECT_EQ(derived("axiom: A\nA -> F/////A", 1), "F/////A") << "rolls, no comment";
    EXPECT_EQ(derived("// a comment\naxiom: A\nA -> + \u2212 A", 1), "+-A");
}

TEST(LSystem, ContextSkipsBranches) {
    EXPECT_EQ(derived("axiom: BAAAA\nB < A -> B\nB -> A", 3), "AAABA") << "a signal moves on";
    EXPECT_EQ(derived("axiom: B[+A]A\n#ignore +\nB < A -> C", 1), "B[+C]C");
    EXPECT_EQ(derived("axiom: B[+A]A\nB < A -> C", 1), "B[+A]C") << "a letter that is not ignored counts";
    EXPECT_EQ(derived("axiom: B[AA]A\nA > A -> C", 1), "B[CA]A") << "not out of the branch";
    EXPECT_EQ(derived("axiom: A[B]A\nA > A -> C", 1), "C[B]A");
    EXPECT_EQ(derived("axiom: A+A-A\n#ignore +-\nA > A -> C", 1), "C+C-A");
    EXPECT_EQ(derived("axiom: A(1)B(2)C(4)\nA(x) < B(y) > C(z) : z > x -> B(x+y+z)", 1), "A(1)B(7)C(4)");
    EXPECT_EQ(derived("axiom: XYA\nX Y < A -> B", 1), "XYB");
    EXPECT_EQ(derived("axiom: XA\nA -> C\nX < A -> B", 1), "XB") << "with context first";
}

TEST(LSystem, CutsTheRestOfItsBranch) {
    EXPECT_EQ(derived("axiom: F[+A[B]C]D\nA -> %", 1), "F[+]D");
    EXPECT_EQ(derived("axiom: FAD\nA -> %", 1), "F");
}

TEST(LSystem, ChanceIsAPureFunctionOfSeedAndModule) {
    constexpr std::string_view kGrammar = "axiom: AAAAAAAAAA\nA -> (0.25) F[A]A\nA -> (0.75) A";
    EXPECT_EQ(derived(kGrammar, 9, 1, 1), derived(kGrammar, 9, 1, 4));
    EXPECT_NE(derived(kGrammar, 9, 1), derived(kGrammar, 9, 2));
    std::string many = "axiom: ";
    for (int i = 0; i < 4000; ++i) many += "A";
    const std::string once = derived(many + "\nA : * : 1 -> B\nA : * : 3 -> C", 1);
    EXPECT_NEAR(double(std::ranges::count(once, 'B')), 1000, 120) << "probabilities are made to be 1 together";
    const std::string one = derived("axiom: A[B]\nA -> (0.5) FA\nA -> (0.5) fA", 12),
                      two = derived("axiom: A[BBBB]\nA -> (0.5) FA\nA -> (0.5) fA\nB -> BB", 12);
    EXPECT_EQ(one.substr(0, one.find('[')), two.substr(0, two.find('['))) << "what else happens re-rolls nothing";
}

TEST(LSystem, RandDrawsFromSeedAndPlace) {
    const Grammar grammar = parseGrammar("axiom: AAAA\nA -> F(rand(2,3))f(rand(2,3))");
    const CWord word = CRewriter(grammar, 7).derive(1, CProgress());
    std::vector<double> all;
    for (std::size_t i = 0; i < word.size(); ++i) {
        all.push_back(word.numbers(i)[0]);
        EXPECT_GE(all.back(), 2);
        EXPECT_LT(all.back(), 3);
    }
    std::ranges::sort(all);
    EXPECT_EQ(std::ranges::adjacent_find(all), all.end()) << "each rand() of each module is another";
}

TEST(LSystem, TheSameForEveryNumberOfThreads) {
    const std::string grammar = kFigures[9].defines + std::string(kFigures[9].rules);
    EXPECT_EQ(derived(grammar, 7, 1, 1), derived(grammar, 7, 1, 7));
}

TEST(LSystem, DefinesAreSliders) {
    const std::string text = "#define r1 0.9        // 0.5 .. 1    contraction of the trunk\n#define a -45\n#define b a*2\naxiom: F(r1)";
    const Grammar grammar = parseGrammar(text);
    ASSERT_EQ(grammar.defines.size(), 3u);
    const GrammarDefine& r1 = grammar.defines[0];
    EXPECT_EQ(r1.name, "r1");
    EXPECT_EQ(text.substr(r1.offset, r1.length), "0.9");
    EXPECT_EQ(r1.low, 0.5);
    EXPECT_EQ(r1.high, 1);
    EXPECT_EQ(r1.words, "contraction of the trunk");
    EXPECT_EQ(text.substr(grammar.defines[1].offset, grammar.defines[1].length), "-45");
    EXPECT_TRUE(grammar.defines[1].isNumber);
    EXPECT_EQ(grammar.defines[1].low, -90);
    EXPECT_FALSE(grammar.defines[2].isNumber);
    EXPECT_EQ(grammar.defines[2].value, -90);
    const NamedValue other{"r1", 0.5};
    EXPECT_EQ(parseGrammar(text, {&other, 1}).axiom[0].numbers[0].constant(), 0.5);
}

TEST(LSystem, FaultsHaveTheirPlace) {
    EXPECT_EQ(faultOf("A -> F"), "1:1: the axiom is missing: axiom: …");
    EXPECT_EQ(faultOf("axiom: F(x)"), "1:10: 'x' is not defined here");
    EXPECT_EQ(faultOf("axiom: A(1)\nA(len) -> F(lem)"), "2:13: 'lem' is not defined here, did you mean 'len'?");
    EXPECT_EQ(faultOf("#define a b\n#define b 1\naxiom: F(a)"), "1:11: 'b' is not defined here");
    EXPECT_EQ(faultOf("axiom: F[+F"), "1:9: there is no ] for this [");
    EXPECT_EQ(faultOf("axiom: F]F"), "1:9: there is no [ for this ]");
    EXPECT_EQ(faultOf("axiom: F(1"), "1:8: the bracket of this module's numbers is not closed");
    EXPECT_EQ(faultOf("axiom: F((1+2)"), "1:8: the bracket of this module's numbers is not closed");
    EXPECT_EQ(faultOf("axiom: F(min(1))"), "1:10: min() takes 2 numbers, not 1");
    EXPECT_EQ(faultOf("axiom: F(sine(1))"), "1:10: there is no function 'sine', did you mean 'sin'?");
    EXPECT_EQ(faultOf("axiom: F(1/0)"), "1:11: this is no finite number");
    EXPECT_EQ(faultOf("axiom: F\nn = 10"), "2:1: the number of derivations is the value Derivations, not a line of the grammar");
    EXPECT_EQ(faultOf("axiom: {F.F.}"), "1:8: polygons { . } are not supported; use ~L for a leaf");
    EXPECT_EQ(faultOf("axiom: F ?"), "1:10: '?' is no letter of a word");
    EXPECT_EQ(faultOf("axiom: ~X"), "1:8: after ~ stands L (leaf), B (blossom) or K (fruit)");
    EXPECT_EQ(faultOf("axiom: F\nA B -> F"), "2:1: a production rewrites one module: A(x) : condition -> successor");
    EXPECT_EQ(faultOf("axiom: F\nF(l) : l > 1 F"), "2:14: expected '->'");
    EXPECT_EQ(faultOf("axiom: F /* no end"), "1:10: this comment has no end");
    EXPECT_EQ(faultOf("#include x"), "1:1: only #define and #ignore are known");
}

TEST(LSystem, ADeadProductionIsAWarning) {
    const Grammar grammar = parseGrammar("axiom: A(1)\nA(x) -> F\nA(x,y) -> f");
    ASSERT_EQ(grammar.warnings.size(), 1u);
    EXPECT_EQ(grammar.warnings[0].line, 3);
    EXPECT_NE(grammar.warnings[0].text.find("A with 2 numbers"), std::string::npos);
}

TEST(LSystem, NumbersThatAreNotFiniteNameTheirModule) {
    const Grammar grammar = parseGrammar("axiom: A(2)\nA(x) -> F(1/(x-1)) A(x-1)");
    try {
        CRewriter(grammar, 1).derive(3, CProgress());
        FAIL() << "divided by zero";
    } catch (const CInputError& e) {
        EXPECT_EQ(e.messages()[0].line, 2);
        EXPECT_EQ(e.messages()[0].column, 9);
        EXPECT_NE(e.messages()[0].text.find("A(1)"), std::string::npos) << e.messages()[0].text;
    }
}

TEST(LSystem, GrowsNoFurtherThanAllowed) {
    const Grammar grammar = parseGrammar("axiom: A\nA -> AA");
    EXPECT_THROW(CRewriter(grammar, 1, true, 1000).derive(20, CProgress()), CError);
    const CProgress cancelled(2);
    cancelled.cancel();
    EXPECT_THROW(CRewriter(grammar, 1).derive(3, cancelled), CCancelled);
}

TEST(LSystem, AModuleTakesLittleRoom) {
    const Grammar grammar = parseGrammar("axiom: A(1,2)\nA(x,y) -> A(x,y)A(y,x)");
    const CWord word = CRewriter(grammar, 1).derive(16, CProgress(2));
    EXPECT_LE(2 * word.bytes(), 64 * word.size()) << "with the word it is made of";
}

TEST(Turtle, LettersTurnAsTheirWordsSay) {
    const auto end = [](const std::string& word) {
        const TurtlePath path = interpret(CRewriter(parseGrammar("axiom: " + word), 1).axiom(), {}, CProgress());
        const TurtleSegment& last = path.segments.back();
        return last.frame[2];
    };
    const auto near = [](const glm::dvec3& a, const glm::dvec3& b) { return glm::distance(a, b) < 1e-12; };
    EXPECT_TRUE(near(end("F"), {0, 0, 1})) << "up";
    EXPECT_TRUE(near(end("+(90)F"), {-1, 0, 0})) << "left";
    EXPECT_TRUE(near(end("-(90)F"), {1, 0, 0})) << "right";
    EXPECT_TRUE(near(end("&(90)F"), {0, 1, 0})) << "down, away from U";
    EXPECT_TRUE(near(end("^(90)F"), {0, -1, 0}));
    EXPECT_TRUE(near(end("/(90)+(90)F"), {0, -1, 0})) << "left was rolled to U";
    EXPECT_TRUE(near(end("\\(90)+(90)F"), {0, 1, 0}));
    EXPECT_TRUE(near(end("|F"), {0, 0, -1}));
    EXPECT_TRUE(near(end("+(30)[-(90)F]F"), {-0.5, 0, std::sqrt(0.75)})) << "brackets bring all back";
    EXPECT_TRUE(near(end("+(90)&(30)$/(0)+(90)F"), {0, -1, 0}) || near(end("+(90)&(30)$+(90)F"), {0, 1, 0}) ||
                std::abs(end("+(90)&(30)$+(90)F").z) < 1e-12)
        << "$ makes left level";
}

TEST(Turtle, SegmentsKnowWhatIsBelow) {
    const TurtlePath path = interpret(CRewriter(parseGrammar("axiom: !(4)F(2)[+F~L(3)]f(1)F[F]F(0.5)"), 1).axiom(),
                                      {.lengthUnit = 0.5, .widthUnit = 0.1}, CProgress());
    std::vector<std::int32_t> below;
    for (const TurtleSegment& s : path.segments) below.push_back(s.below);
    EXPECT_EQ(below, (std::vector<std::int32_t>{-1, 0, -1, 2, 2}));
    EXPECT_EQ(path.segments[0].length, 1);
    EXPECT_EQ(path.segments[0].width, 0.4);
    EXPECT_EQ(path.segments[1].depth, 1u);
    ASSERT_EQ(path.organs.size(), 1u);
    EXPECT_EQ(path.organs[0].below, 1);
    EXPECT_EQ(path.organs[0].size, 1.5);
    EXPECT_EQ(path.organs[0].organ, Organ::Leaf);
}

namespace {
struct Drawn {
    CWord word;
    TurtlePath path;
    std::vector<std::shared_ptr<const CTurtleGeneration>> stems;
};

Drawn stemsOfWord(const std::string& grammar, int steps, const TurtleParams& params = {}) {
    Drawn made;
    made.word = CRewriter(parseGrammar(grammar), 1).derive(steps, CProgress(2));
    made.path = interpret(made.word, params, CProgress());
    made.stems = stemsOf(made.word, made.path, CProgress());
    return made;
}

std::vector<std::size_t> stemCounts(const std::vector<std::shared_ptr<const CTurtleGeneration>>& stems) {
    std::vector<std::size_t> counts;
    for (const auto& generation : stems) counts.push_back(generation->stems.size());
    return counts;
}
} // namespace

TEST(TurtleStems, GoOnOutsideBracketsElseStraightOn) {
    EXPECT_EQ(stemCounts(stemsOfWord("axiom: F[+F]F[-FF]F", 0).stems), (std::vector<std::size_t>{1, 2}));
    const Drawn fork = stemsOfWord("axiom: F[+(40)F(2)][-(20)F(3)][-(20)F(4)]", 0);
    ASSERT_EQ(stemCounts(fork.stems), (std::vector<std::size_t>{1, 2}));
    EXPECT_EQ(fork.stems[0]->stems[0].length, 4) << "the one that turns least, the first of two";
    EXPECT_EQ(fork.stems[1]->stems[0].length, 2);
    EXPECT_EQ(fork.stems[1]->stems[1].length, 4);
    EXPECT_EQ(stemCounts(stemsOfWord("axiom: FfF", 0).stems), (std::vector<std::size_t>{2})) << "f starts anew";
    EXPECT_EQ(stemCounts(stemsOfWord("axiom: A", 0).stems), std::vector<std::size_t>());
    EXPECT_EQ(stemCounts(stemsOfWord("axiom: F(0)F[+F(0)]", 0).stems), (std::vector<std::size_t>{1}));
}

TEST(TurtleStems, HoldEverySegmentOnceAndInOrder) {
    for (const Figure& figure : kFigures) {
        SCOPED_TRACE(figure.name);
        TurtleParams params;
        params.tropism = zUp(figure.tropism);
        params.tropismBend = figure.bend;
        const Drawn made = stemsOfWord(figure.defines + std::string(figure.rules), figure.steps, params);
        std::size_t segments = 0;
        double length = 0;
        for (std::size_t g = 0; g < made.stems.size(); ++g) {
            const CGeneration& own = *made.stems[g];
            for (const CStem& stem : own.stems) {
                double along = 0;
                const auto path = own.segmentsOf(own.paths[stem.firstPath]);
                ASSERT_EQ(path.size(), stem.segmentCount);
                for (std::size_t k = 0; k < path.size(); ++k) {
                    ASSERT_NEAR(path[k].start, along, 1e-9 * (1 + along));
                    along += path[k].length;
                    if (k > 0) {
                        ASSERT_LT(glm::distance(path[k].position, path[k - 1].axisPoint(1)), 1e-9 * (1 + along));
                    }
                }
                ASSERT_NEAR(stem.length, along, 1e-9 * along);
                segments += path.size();
                length += along;
                ASSERT_EQ(stem.parent < 0, g == 0);
                if (g == 0) continue;
                const CGeneration& below = *made.stems[g - 1];
                const CStem& parent = below.stems[static_cast<std::size_t>(stem.parent)];
                const CSegment& wood = below.segmentAt(parent, 0, stem.position);
                ASSERT_LT(glm::distance(path.front().position, wood.axisPoint(1)), 1e-9 * (1 + figure.high.y));
                ASSERT_EQ(stem.offset, wood.end());
            }
        }
        EXPECT_EQ(segments, figure.segments);
        EXPECT_NEAR(length, figure.length, 1e-4 * figure.length);
    }
}

} // namespace stromar
