// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>

namespace setae::parallel {

/// Threads that wait between loops: starting a thread takes longer than a short loop.
///
/// One crew per process. It grows to the maximum number of simultaneous threads and ends with the process. After fork()
/// the child begins with a new crew.
class Crew {
public:
    [[nodiscard]] static Crew& of_process();

    /// Calls `work` in this thread and in up to `helpers` threads simultaneously, and returns when all have returned. A
    /// helper that has not begun when this thread has finished is not awaited. `work` must not throw. May be called
    /// from within `work`.
    void run(std::size_t helpers, const std::function<void()>& work);

private:
    struct Loop {
        const std::function<void()>& work;
        std::size_t places;                  ///< for helpers, not yet taken
        std::atomic<std::size_t> active{0};  ///< helpers at work
    };
    void invite(Loop& loop);
    void dismiss(Loop& loop);
    void help();

    std::mutex mutex_;
    std::condition_variable wake_, done_;
    std::deque<Loop*> loops_;             ///< loops with places
    std::atomic<std::size_t> places_{0};  ///< of all loops
    std::size_t idle_ = 0;                ///< threads without a loop
};

}  // namespace setae::parallel
