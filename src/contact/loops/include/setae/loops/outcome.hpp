// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace setae::loops {

/// A result, or the reason for which there is none.
template <class T>
struct Outcome {
    std::optional<T> value;
    std::string reason;  ///< empty where there is a value

    Outcome() = default;
    Outcome(T result) : value(std::move(result)) {}
    [[nodiscard]] static Outcome missing(std::string why) {
        Outcome outcome;
        outcome.reason = std::move(why);
        return outcome;
    }

    explicit operator bool() const { return value.has_value(); }
    const T& operator*() const { return *value; }
    const T* operator->() const { return &*value; }
};

}  // namespace setae::loops
