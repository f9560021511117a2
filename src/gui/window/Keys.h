#pragma once
#include <QKeyEvent>
#include <QKeySequence>

namespace stromar {

/// A step through the history, back or forward.
inline bool isUndo(const QKeyEvent& key) { return key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo); }

} // namespace stromar
