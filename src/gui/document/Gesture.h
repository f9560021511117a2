#pragma once
#include <QRandomGenerator>

namespace stromar {

/// A number for the changes of one drag or burst, so that the history takes them as one step. Positive.
inline int nextGesture() {
    static int last = 0;
    return ++last;
}

/// What the dice throws: few digits, easy to tell others.
inline int randomSeed() { return QRandomGenerator::global()->bounded(10000); }

} // namespace stromar
