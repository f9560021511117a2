#include "view/LightPanel.h"
#include "library/TextureWorkshop.h"
#include "WindowFixture.h"
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <gtest/gtest.h>

namespace stromar {
namespace {

QImage pictureOf(CTextureWorkshop& workshop) {
    return workshop.findChild<QLabel*>(QStringLiteral("picture"))->pixmap().toImage();
}

TEST(TextureWorkshop, ShowsWhatItsEditorsSay) {
    CTextureWorkshop workshop(CRecipe("leaf:oak"));
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
    panel.findChild<QPushButton*>(QStringLiteral("usualLight"))->click();
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
