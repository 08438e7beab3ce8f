// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace setae::parallel {

/// While this object exists, for_each_index() called by this thread or inside it starts no further index once
/// `cancelled` is true, and throws Cancelled.
///
/// For computations that do not check for cancellation: their results are then incomplete and are discarded.
class CancellationScope {
public:
    explicit CancellationScope(const std::atomic<bool>& cancelled);
    ~CancellationScope();
    CancellationScope(const CancellationScope&) = delete;
    CancellationScope& operator=(const CancellationScope&) = delete;

private:
    const std::atomic<bool>* outer_;
};

/// For iterations without for_each_index(). @throws Cancelled if a CancellationScope of this thread was cancelled.
void stop_if_cancelled();

}  // namespace setae::parallel
