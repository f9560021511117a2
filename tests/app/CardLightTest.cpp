// What cards' pictures are multiplied by, so that they are shown as bright as what they stand for.
#include "CardLight.h"
#include "stromar/texture/Srgb.h"
#include <cmath>
#include <gtest/gtest.h>

namespace stromar::test {
namespace {

const MeanLook kLeaf{glm::dvec3(0.1, 0.25, 0.05), glm::dvec3(0.3, 0.35, 0.3), 0.6, 0.3}, kBark{glm::dvec3(0.02), glm::dvec3(0.02), 0.85, 0},
               kBlossom{glm::dvec3(0.8), glm::dvec3(0.8), 0.6, 0.3};
const LitPlace kFront{.normal = {0, 0, 1}, .toViewer = {0, 1, 0}, .sunVisibility = 1, .skyVisibility = 1, .back = false, .behind = false, .layer = CrownLayer::Leaf};

LitPlace shaded() {
    LitPlace place = kFront;
    place.sunVisibility = 0;
    return place;
}
LitPlace under() {
    LitPlace place = kFront;
    place.back = place.behind = true;
    return place;
}
LitPlace wood(CrownLayer layer = CrownLayer::Wood) {
    LitPlace place = kFront;
    place.layer = layer;
    return place;
}
LitPlace blossom() {
    LitPlace place = shaded();
    place.layer = CrownLayer::Blossom;
    return place;
}

CrownLook crownOf(const std::vector<LitPlace>& places) {
    CrownLook look{glm::vec3(0, std::sqrt(0.5f), std::sqrt(0.5f)), {}};
    for (const LitPlace& place : places) look.pixels.push_back({place});
    look.pixels.emplace_back(); // of a side from which little is seen
    return look;
}

/// Of green in the pictures of cards' fronts and backs.
struct Factors {
    double front, back;
};

Factors factorsOf(const std::vector<LitPlace>& crown, const std::vector<LitPlace>& cards, double sunAndShade = 0) {
    constexpr std::uint8_t kBefore = 128;
    const CardLooks looks{crownOf(crown), crownOf(cards)};
    CCardLight light(looks, kBark, kBlossom, sunAndShade);
    light.add(kLeaf, 1);
    TextureMaps maps;
    maps.albedo = {{kBefore, kBefore, kBefore, 255}};
    maps.back = maps.albedo;
    light.applyTo(maps);
    const auto factor = [](std::uint8_t after) { return double(linearOf(float(after) / 255) / linearOf(float(kBefore) / 255)); };
    return {factor(maps.albedo[0][1]), factor(maps.back[0][1])};
}

TEST(CardLight, CardsThatAreSeenAsTheirTwigsAreKeepTheirColours) {
    for (const std::vector<LitPlace>& places : {std::vector{kFront}, std::vector{shaded()}, std::vector{kFront, shaded(), under()}}) {
        const Factors factors = factorsOf(places, places);
        EXPECT_NEAR(factors.front, 1, 0.03);
        EXPECT_NEAR(factors.back, places.size() > 1 ? 1 : factors.back, 0.03);
    }
}

TEST(CardLight, LeavesInTheShadeMakeCardsDarker) {
    const double all = factorsOf({shaded()}, {kFront}).front, half = factorsOf({shaded(), kFront}, {kFront}).front;
    EXPECT_LT(all, 0.4);
    EXPECT_LT(half, 0.8);
    EXPECT_GT(half, all);
}

TEST(CardLight, WoodMakesThemDarkerToo) { EXPECT_LT(factorsOf({kFront, wood()}, {kFront}).front, 0.75); }

TEST(CardLight, UnderSidesThatAreSeldomSeenShowLessOnCards) {
    const Factors factors = factorsOf({kFront, kFront, kFront, under()}, {kFront, under()});
    EXPECT_GT(factors.front, 0.91) << "it shows upper sides from behind as well";
    EXPECT_LT(factors.back, 0.91) << "they are paler";
}

/// Leaves in the middle of the crown and their cards have the tint of the shade; a picture's wood has it as well, the twigs' own has not.
TEST(CardLight, TheTintOfShadeIsOnBoth) {
    LitPlace inside = shaded(), insideWood = wood();
    inside.skyVisibility = insideWood.skyVisibility = 0.4f;
    EXPECT_NEAR(factorsOf({inside}, {inside}, 1).front, 1, 0.03);
    EXPECT_NEAR(factorsOf({insideWood}, {insideWood}, 0).front, 1 / 0.99, 0.03);
    EXPECT_GT(factorsOf({insideWood}, {insideWood}, 1).front, 1.15);
}

TEST(CardLight, WhatIsBesideThemChangesNothingWhereItIsSeenAlike) {
    for (const LitPlace& beside : {wood(CrownLayer::OtherWood), blossom()})
        for (const std::vector<LitPlace>& leaves : {std::vector{kFront}, std::vector{shaded()}})
            EXPECT_NEAR(factorsOf({leaves[0], beside}, {kFront, beside}).front, factorsOf(leaves, {kFront}).front, 0.03);
}

/// As dark as twigs, and a little darker where blossoms get more sun between cards, or lighter where they get less: not by as much as all of it.
TEST(CardLight, WhatIsBrighterBetweenCardsMakesThemDarker) {
    LitPlace sunny = blossom();
    sunny.sunVisibility = 1;
    LitPlace less = blossom();
    less.sunVisibility = 0.1f;
    EXPECT_NEAR(factorsOf({kFront, blossom()}, {kFront, sunny}).front, 1 / 1.3, 0.03) << "the most";
    EXPECT_LT(factorsOf({kFront, blossom()}, {kFront, less}).front, 0.97);
    EXPECT_GT(factorsOf({kFront, less}, {kFront, blossom()}).front, 1.03);
}

TEST(CardLight, WhatIsNotSeenChangesNothing) {
    for (const Factors& factors : {factorsOf({}, {kFront}), factorsOf({kFront}, {}), factorsOf({}, {}), factorsOf({blossom()}, {kFront, blossom()})}) {
        EXPECT_NEAR(factors.front, 1, 0.01);
        EXPECT_NEAR(factors.back, 1, 0.01);
    }
}

TEST(CardLight, APixelOfLightAndShadeIsDarkerThanTheTwoBesideEachOther) {
    CardLooks looks{crownOf({}), crownOf({kFront, shaded()})};
    looks.crown.pixels = {{kFront, shaded()}};
    CCardLight light(looks, kBark, kBlossom, 0);
    light.add(kLeaf, 1);
    TextureMaps maps;
    maps.albedo = {{128, 128, 128, 255}};
    maps.back = maps.albedo;
    const auto apart = factorsOf({kFront, shaded()}, {kFront, shaded()}).front;
    light.applyTo(maps);
    EXPECT_LT(linearOf(float(maps.albedo[0][1]) / 255) / linearOf(128 / 255.0f), 0.97 * apart);
}

} // namespace
} // namespace stromar::test
