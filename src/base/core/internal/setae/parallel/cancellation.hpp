// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace setae::parallel {

/// While it lives, for_each_index() called by this thread, or by what that runs, begins no further index once
/// `cancelled` is true, and throws Cancelled.
///
/// For computations that know nothing of being stopped; results then end as they can, so nobody keeps them.
class CancellationScope {
public:
    explicit CancellationScope(const std::atomic<bool>& cancelled);
    ~CancellationScope();
    CancellationScope(const CancellationScope&) = delete;
    CancellationScope& operator=(const CancellationScope&) = delete;

private:
    const std::atomic<bool>* outer_;
};

/// For iterations that begin no index: @throws Cancelled where a CancellationScope of this thread was asked to stop.
void stop_if_cancelled();

}  // namespace setae::parallel
