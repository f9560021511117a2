#include "view/LightPanel.h"
#include "library/TextureWorkshop.h"
#include "WindowFixture.h"
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QSet>
#include <QSlider>
#include <gtest/gtest.h>

namespace stromar {
namespace {

QImage pictureOf(CTextureWorkshop& workshop) {
    return workshop.findChild<QLabel*>(QStringLiteral("picture"))->pixmap().toImage();
}

TEST(TextureWorkshop, ShowsWhatItsEditorsSay) {
    CTextureWorkshop workshop(CRecipe("leaf:oak"));
    ASSERT_TRUE(waitFor([&] { return !pictureOf(workshop).isNull(); }));
    const QImage oak = pictureOf(workshop);
    workshop.findChild<QDoubleSpinBox*>(QStringLiteral("lobes"))->setValue(8);
    EXPECT_EQ(workshop.recipe().text(), "leaf:oak lobes=8");
    EXPECT_TRUE(waitFor([&] { return pictureOf(workshop) != oak; }));
    workshop.findChild<QComboBox*>(QStringLiteral("kind"))->setCurrentIndex(0);
    EXPECT_EQ(workshop.recipe().text(), "leaf:oval") << "another kind begins with its own values";
}

TEST(TextureWorkshop, HasAnEditorForEveryRow) {
    for (const char* start : {"bark:birch", "leaf:maple"}) {
        CTextureWorkshop workshop{CRecipe(start)};
        for (const CRecipe::Row& row : workshop.recipe().rows())
            EXPECT_TRUE(workshop.findChild<QWidget*>(QString::fromUtf8(row.key.data(), qsizetype(row.key.size()))))
                << row.key;
    }
}

TEST(TextureWorkshop, SlidersAndNumbersFollowEachOther) {
    CTextureWorkshop workshop(CRecipe("bark:birch"));
    auto* number = workshop.findChild<QDoubleSpinBox*>(QStringLiteral("depth"));
    auto* slider = number->parentWidget()->findChild<QSlider*>();
    number->setValue(1.5);
    EXPECT_EQ(slider->value(), slider->maximum() / 2);
    slider->setValue(slider->maximum());
    EXPECT_EQ(number->value(), 3);
    EXPECT_EQ(workshop.recipe().text(), "bark:birch depth=3");
}

class WorkshopTest : public WindowFixture {
protected:
    CTextureWorkshop* open() {
        window.files().openWorkshop(paramRef("BarkTexture"));
        return window.findChild<CTextureWorkshop*>();
    }
    const std::string& bark() { return window.document().params().text.barkTexture; }
};

TEST_F(WorkshopTest, TheTreeWearsWhatIsMadeAsOneStep) {
    const std::string before = bark();
    CTextureWorkshop* workshop = open();
    ASSERT_TRUE(workshop);
    EXPECT_FALSE(workshop->isModal());
    auto* depth = workshop->findChild<QDoubleSpinBox*>(QStringLiteral("depth"));
    for (const double value : {0.5, 1.5, 2.5}) {
        depth->setValue(value);
        ASSERT_TRUE(waitFor([&] { return bark() == workshop->recipe().text(); }));
    }
    EXPECT_EQ(window.document().history().count(), 1);
    workshop->reject();
    EXPECT_EQ(bark(), before);
    EXPECT_EQ(window.document().history().count(), 0) << "as if nothing had been";
}

TEST_F(WorkshopTest, AnotherOneKeepsWhatTheFirstMade) {
    CTextureWorkshop* first = open();
    first->findChild<QDoubleSpinBox*>(QStringLiteral("depth"))->setValue(2.2);
    const std::string made = first->recipe().text();
    window.files().openWorkshop(paramRef("LeafTexture"));
    EXPECT_EQ(bark(), made);
    QTest::qWait(100);
    EXPECT_EQ(bark(), made) << "not the leaf's";
}

TEST_F(WorkshopTest, IsClosedWithItsTree) {
    QPointer<CTextureWorkshop> workshop = open();
    ASSERT_TRUE(workshop);
    workshop->findChild<QDoubleSpinBox*>(QStringLiteral("depth"))->setValue(2.2);
    window.document().startNew();
    const CParams fresh = window.document().params();
    EXPECT_TRUE(waitFor([&] { return !workshop; }));
    EXPECT_EQ(window.document().params(), fresh);
}

TEST(TextureWorkshop, ShowsEveryMapInTheFormOfTheLeaf) {
    CTextureWorkshop workshop(CRecipe("leaf:oak"), 0.5);
    QSet<QRgb> corners;
    std::vector<QImage> seen;
    auto* map = workshop.findChild<QComboBox*>(QStringLiteral("map"));
    ASSERT_EQ(map->count(), 4);
    ASSERT_TRUE(waitFor([&] { return !pictureOf(workshop).isNull(); }));
    for (int i = 0; i < map->count(); ++i) {
        map->setCurrentIndex(i);
        const QImage image = pictureOf(workshop);
        for (const QImage& other : seen) EXPECT_NE(image, other);
        seen.push_back(image);
        for (int y = 0; y < image.height(); ++y) corners << image.pixel(image.width() / 8, y);
    }
    EXPECT_EQ(corners.size(), 1) << "half as wide as high: nothing but the ground there";
}

TEST(LightPanel, MovesTheSunOfTheLook) {
    CLightPanel panel;
    ViewLook look;
    panel.applyTo(look);
    EXPECT_EQ(look, ViewLook());
    int changes = 0;
    QObject::connect(&panel, &CLightPanel::changed, &panel, [&] { ++changes; });
    auto* hour = panel.findChild<QSlider*>(QStringLiteral("hour"));
    hour->setValue(hour->maximum());
    EXPECT_EQ(changes, 1);
    panel.applyTo(look);
    EXPECT_EQ(look.light.hour, 20);
    CLightPanel again;
    ViewLook kept;
    again.applyTo(kept);
    EXPECT_EQ(kept, look) << "kept between runs";
    panel.findChild<QPushButton*>(QStringLiteral("resetLight"))->click();
    panel.applyTo(look);
    EXPECT_EQ(look, ViewLook());
}

TEST(LightPanel, TheWindowShowsIt) {
    CMainWindow window;
    auto* hour = window.findChild<QSlider*>(QStringLiteral("hour"));
    ASSERT_TRUE(hour);
    hour->setValue(0);
    EXPECT_EQ(window.viewport().look().light.hour, 5);
    hour->setValue(hour->maximum() / 3); // 10
    EXPECT_EQ(window.viewport().look().light.hour, 10);
}

} // namespace
} // namespace stromar
