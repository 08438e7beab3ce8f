// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace setae::python {

/// Thrown when Python requested a stop.
struct Interrupted {};

/// A call that computes without the lock of the interpreter. A thread in such a call at the end of the interpreter
/// could not take the lock again and would abort the process. end_running_calls() therefore stops these threads and
/// waits. Constructed and destroyed with the lock.
class RunningCall {
public:
    /// cancelled: flag that requests the call to stop. @throws Interrupted after end_running_calls().
    explicit RunningCall(std::atomic<bool>& cancelled);
    ~RunningCall();
    RunningCall(const RunningCall&) = delete;
    RunningCall& operator=(const RunningCall&) = delete;

private:
    std::atomic<bool>& cancelled_;
};

/// For atexit: requests every running call to stop, waits without the lock until all have stopped, and refuses new
/// calls. Returns true if threads may remain; their memory is not released before the process ends.
bool end_running_calls();

/// For a child of fork(): the child has none of the threads in calls, and a mutex may stay locked.
void forget_running_calls();

}  // namespace setae::python
