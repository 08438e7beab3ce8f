// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace setae::python {

/// Where Python asked to stop.
struct Interrupted {};

/// A call that computes without the interpreter's lock. Threads that are still in one when the interpreter ends could
/// not take the lock back, and would abort the process: end_running_calls() asks them to stop and waits. Made and
/// destroyed with the lock.
class RunningCall {
public:
    /// cancelled: asks the call to stop. @throws Interrupted where calls have been ended.
    explicit RunningCall(std::atomic<bool>& cancelled);
    ~RunningCall();
    RunningCall(const RunningCall&) = delete;
    RunningCall& operator=(const RunningCall&) = delete;

private:
    std::atomic<bool>& cancelled_;
};

/// For atexit: asks every running call to stop, waits until all have, without the lock, and lets no other begin.
/// Returns whether threads may be left, which keep what they hold until the process has gone.
bool end_running_calls();

/// For a child of fork(): it has none of the threads that were in calls, and a mutex may be held for good.
void forget_running_calls();

}  // namespace setae::python
