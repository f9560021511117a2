#include "tree/Support.h"
#include <gtest/gtest.h>
#include <set>

namespace stromar {
namespace {

using namespace test;

std::shared_ptr<const COrgans> leavesOf(const CParams& params, const OrganDemand& demand, int threads = 2) {
    const CWeberPennBuilder builder;
    const CProgress progress(threads);
    const auto tree = builder.build(params, nullptr, 0, progress);
    return builder.growOrgans(params, *tree, Organ::Leaf, demand, progress);
}

using Names = std::set<std::pair<std::uint32_t, std::uint32_t>>; // stem, number

Names namesOf(const COrgans& organs) {
    Names names;
    for (const CLeaf& leaf : organs.grown) names.insert({leaf.stem, leaf.number});
    return names;
}

/// Along stems, in whorls, in fans.
std::vector<CParams> bearers() { return {preset("quaking_aspen"), preset("ash"), preset("fan_palm"), preset("norway_spruce")}; }
} // namespace

TEST(OrganDemand, ALargerOneKeepsWhatASmallerHas) {
    for (const CParams& params : bearers()) {
        Names smaller;
        for (const double share : {0.05, 0.3, 0.31, 0.8, 1.0}) {
            const auto some = leavesOf(params, {.share = share});
            const Names names = namesOf(*some);
            EXPECT_TRUE(std::ranges::includes(names, smaller));
            EXPECT_NEAR(double(names.size()), share * double(some->total), 5 * std::sqrt(double(some->total)) + 1);
            smaller = names;
        }
    }
}

TEST(OrganDemand, WhatIsKeptIsAsInTheWholeTree) {
    for (const CParams& params : bearers()) {
        const auto all = leavesOf(params, {}), some = leavesOf(params, {.share = 0.3});
        EXPECT_EQ(all->grown.size(), all->total);
        EXPECT_EQ(some->counts, all->counts) << "all are counted";
        std::size_t at = 0;
        for (const CLeaf& leaf : some->grown) {
            while (at < all->grown.size() && (all->grown[at].stem != leaf.stem || all->grown[at].number != leaf.number)) ++at;
            ASSERT_LT(at, all->grown.size());
            EXPECT_EQ(all->grown[at].position, leaf.position);
            EXPECT_EQ(all->grown[at].axis, leaf.axis);
            EXPECT_EQ(all->grown[at].normal, leaf.normal);
        }
    }
}

TEST(OrganDemand, NumbersCountOnEachStem) {
    for (const CParams& params : bearers()) {
        const auto all = leavesOf(params, {});
        std::uint32_t number = 0;
        for (std::size_t i = 0; i < all->grown.size(); ++i) {
            number = i > 0 && all->grown[i].stem == all->grown[i - 1].stem ? number + 1 : 0;
            EXPECT_EQ(all->grown[i].number, number);
            EXPECT_LT(number, all->countOn(all->grown[i].generation, all->grown[i].stem));
        }
    }
}

TEST(OrganDemand, OnlyChosenStemsBear) {
    const CParams params = preset("quaking_aspen");
    const auto all = leavesOf(params, {});
    const std::size_t last = all->counts.size() - 1;
    std::vector<bool> every7th(all->counts[last].size(), false);
    std::size_t there = 0;
    for (std::size_t s = 0; s < every7th.size(); s += 7) {
        every7th[s] = true;
        there += all->counts[last][s];
    }
    OrganDemand demand{.share = 0.05, .stems = StemSet{}};
    demand.stems->stems.resize(last + 1);
    demand.stems->stems[last] = every7th;
    const auto some = leavesOf(params, demand);
    for (const CLeaf& leaf : some->grown) EXPECT_EQ(leaf.stem % 7, 0u);
    const double wanted = 0.05 * double(all->total);
    ASSERT_LT(wanted, double(there));
    EXPECT_NEAR(double(some->grown.size()), wanted, 5 * std::sqrt(wanted)) << "a share of all, on the chosen ones";
    demand.share = 1;
    EXPECT_EQ(leavesOf(params, demand)->grown.size(), there);
}

TEST(OrganDemand, IsNotExceeded) {
    for (const CParams& params : bearers())
        for (const double max : {1.0, 40.0, 500.0, 12000.0}) {
            const OrganDemand demand{.max = max, .few = 60};
            const auto some = leavesOf(params, demand);
            EXPECT_LE(double(some->grown.size()), demand.bound(double(some->total)));
        }
    EXPECT_EQ(OrganDemand::none().bound(1e9), OrganDemand::none().bound(2e9));
    EXPECT_TRUE(leavesOf(preset("quaking_aspen"), OrganDemand::none())->grown.empty());
}

TEST(OrganDemand, GivesTheSameForEveryNumberOfThreads) {
    for (const CParams& params : bearers())
        EXPECT_TRUE(sameArrays(leavesOf(params, {.share = 0.4}, 1)->grown, leavesOf(params, {.share = 0.4}, 5)->grown));
}

} // namespace stromar
