// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>

namespace setae::parallel {

/// Threads that wait between loops: starting one takes longer than a short loop.
///
/// One crew a process, which grows to as many threads as ever worked at once and ends with the process. After fork()
/// the child begins with a crew of its own.
class Crew {
public:
    [[nodiscard]] static Crew& of_process();

    /// Calls `work` here and on up to `helpers` threads at the same time, and returns when all have returned. A helper
    /// that has not begun when the work here is done is not waited for. `work` throws nothing. May be called from
    /// within `work`.
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
    std::deque<Loop*> loops_;             ///< with places
    std::atomic<std::size_t> places_{0};  ///< of all loops
    std::size_t idle_ = 0;                ///< threads without a loop
};

}  // namespace setae::parallel
