#include "view/Navigation.h"
#include "window/QtText.h"
#include "stromar/util/Translatable.h"
#include <QKeySequence>
#include <QStringList>
#include <algorithm>

namespace stromar {

namespace {
constexpr MouseGesture kThesis[] = {
    {Qt::LeftButton, Qt::NoModifier, ViewMotion::Turn},
    {Qt::RightButton, Qt::NoModifier, ViewMotion::Zoom},
    {Qt::MiddleButton, Qt::NoModifier, ViewMotion::Pan},
    {Qt::LeftButton | Qt::RightButton, Qt::NoModifier, ViewMotion::Pan},
};
constexpr MouseGesture kBlender[] = {
    {Qt::MiddleButton, Qt::NoModifier, ViewMotion::Turn},
    {Qt::MiddleButton, Qt::ShiftModifier, ViewMotion::Pan},
    {Qt::MiddleButton, Qt::ControlModifier, ViewMotion::Zoom},
};
constexpr MouseGesture kMaya[] = {
    {Qt::LeftButton, Qt::AltModifier, ViewMotion::Turn},
    {Qt::MiddleButton, Qt::AltModifier, ViewMotion::Pan},
    {Qt::RightButton, Qt::AltModifier, ViewMotion::Zoom},
};
constexpr Navigation kNavigations[] = {
    {"stromar", N_("Stromar: left turns, right zooms, middle moves"), kThesis},
    {"blender", N_("Blender: middle button with Shift and Ctrl"), kBlender},
    {"maya", N_("Maya: all buttons with Alt"), kMaya},
};
} // namespace

std::span<const Navigation> navigationTable() { return kNavigations; }

const Navigation& navigationNamed(const QString& name) {
    const auto found =
        std::ranges::find_if(kNavigations, [&](const Navigation& n) { return name == QLatin1String(n.name); });
    return found == std::end(kNavigations) ? kNavigations[0] : *found;
}

ViewMotion motionOf(const Navigation& navigation, Qt::MouseButtons buttons, Qt::KeyboardModifiers keys) {
    keys &= Qt::ShiftModifier | Qt::ControlModifier | Qt::AltModifier;
    const auto found = std::ranges::find_if(
        navigation.gestures, [&](const MouseGesture& g) { return g.buttons == buttons && g.keys == keys; });
    return found == navigation.gestures.end() ? ViewMotion::None : found->motion;
}

QString gestureText(const MouseGesture& gesture) {
    QStringList parts;
    if (gesture.keys != Qt::NoModifier)
        parts << QKeySequence(QKeyCombination(gesture.keys, Qt::Key_A)).toString(QKeySequence::NativeText).chopped(2);
    if (gesture.buttons & Qt::LeftButton) parts << trText(N_("left"));
    if (gesture.buttons & Qt::MiddleButton) parts << trText(N_("middle"));
    if (gesture.buttons & Qt::RightButton) parts << trText(N_("right"));
    return trText(N_("%1 drag")).arg(parts.join(QStringLiteral(" + ")));
}

QString motionText(ViewMotion motion) {
    constexpr const char* kTexts[] = {"", N_("Turn"), N_("Move"), N_("Nearer and farther")};
    return trText(kTexts[static_cast<std::size_t>(motion)]);
}

} // namespace stromar
