// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>

namespace setae::formats {

/// An expensive object, created at the first request from any thread, and destroyed with its last reference.
template <class Kept>
class OnDemand {
public:
    explicit OnDemand(std::function<std::shared_ptr<Kept>()> make) : make_(std::move(make)) {}

    [[nodiscard]] std::shared_ptr<Kept> hold() {
        const std::lock_guard lock(guard_);
        auto kept = made_.lock();
        if (!kept) made_ = kept = make_();
        return kept;
    }

private:
    std::function<std::shared_ptr<Kept>()> make_;
    std::mutex guard_;
    std::weak_ptr<Kept> made_;
};

}  // namespace setae::formats
