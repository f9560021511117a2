#pragma once
#include <memory>
#include <utility>
#include <vector>

namespace stromar {

/// Leaves new elements of trivial types uninitialised, so that a big array is first touched by the threads that fill
/// it.
template <typename T>
struct DefaultInitAllocator : std::allocator<T> {
    template <typename U>
    struct rebind {
        using other = DefaultInitAllocator<U>;
    };
    using std::allocator<T>::allocator;

    template <typename U>
    void construct(U* place) {
        ::new (static_cast<void*>(place)) U;
    }
    template <typename U, typename... Args>
    void construct(U* place, Args&&... args) {
        ::new (static_cast<void*>(place)) U(std::forward<Args>(args)...);
    }
};

/// A vector whose resize() does not write the new elements: fill every one.
template <typename T>
using RawVector = std::vector<T, DefaultInitAllocator<T>>;

} // namespace stromar
