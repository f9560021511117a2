#pragma once
#include <QString>
#include <span>

namespace stromar {

enum class ViewMotion { None, Turn, Pan, Zoom };

/// Mouse buttons and keys that move the view while they are held.
struct MouseGesture {
    Qt::MouseButtons buttons;
    Qt::KeyboardModifiers keys;
    ViewMotion motion;
};

/// One row of the table of mouse maps. The wheel zooms in all of them, a left click picks.
struct Navigation {
    const char* name;  ///< in the settings
    const char* label; ///< marked for translation
    std::span<const MouseGesture> gestures;
};

std::span<const Navigation> navigationTable();
/// The row of this name, else the first.
const Navigation& navigationNamed(const QString& name);
ViewMotion motionOf(const Navigation& navigation, Qt::MouseButtons buttons, Qt::KeyboardModifiers keys);
/// "Left drag", "Shift + middle drag" …
QString gestureText(const MouseGesture& gesture);
/// "Turn", "Move" …
QString motionText(ViewMotion motion);

} // namespace stromar
