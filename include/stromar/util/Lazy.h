#pragma once
#include "stromar/util/Progress.h"
#include <functional>
#include <mutex>
#include <optional>
#include <utility>

namespace stromar {

/// A value that is made when it is first asked for. Any thread may ask; the others wait for the one that makes it.
template <typename Value>
class CLazy {
public:
    /// make(progress) → Value; it is called once, again only after it has thrown.
    explicit CLazy(std::function<Value(const CProgress&)> make) : m_make(std::move(make)) {}

    /// As long as this object lives. Throws what making it does.
    const Value& get(const CProgress& progress) const {
        const std::lock_guard lock(m_mutex);
        if (!m_value) {
            m_value = m_make(progress);
            m_make = nullptr; // with what it holds
        }
        return *m_value;
    }

private:
    mutable std::mutex m_mutex;
    mutable std::function<Value(const CProgress&)> m_make;
    mutable std::optional<Value> m_value;
};

} // namespace stromar
