#pragma once

namespace stromar {

/// A number for the changes of one drag or burst, so that the history takes them as one step. Positive.
inline int nextGesture() {
    static int last = 0;
    return ++last;
}

} // namespace stromar
