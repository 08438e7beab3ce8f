// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/parallel/for_each.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <utility>
#include <vector>

#include "crew.hpp"
#include "setae/core/errors.hpp"
#include "setae/parallel/cancellation.hpp"

namespace setae::parallel {

namespace {

std::atomic<int> max_threads{0};
thread_local const std::atomic<bool>* cancellation = nullptr;

}  // namespace

CancellationScope::CancellationScope(const std::atomic<bool>& cancelled) : outer_(cancellation) {
    cancellation = &cancelled;
}

CancellationScope::~CancellationScope() { cancellation = outer_; }

void stop_if_cancelled() {
    if (cancellation && *cancellation) throw Cancelled("the caller asked to stop");
}

void limit_threads(Threads threads) { max_threads = std::max(0, threads.count); }

int Threads::resolved() const {
    if (count > 0) return count;
    if (const int most = max_threads; most > 0) return most;
    static const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));  // reads files
    return processors;
}

void for_each_index(std::size_t n, Threads threads, const std::function<void(std::size_t)>& body) {
    std::vector<std::exception_ptr> failures(n);
    std::atomic<std::size_t> next{0};
    const auto* cancelled = cancellation;
    const std::function<void()> work = [&] {
        const auto* outer = std::exchange(cancellation, cancelled);
        for (auto i = next.fetch_add(1); i < n; i = next.fetch_add(1)) {
            try {
                stop_if_cancelled();
                body(i);
            } catch (...) {
                failures[i] = std::current_exception();
            }
        }
        cancellation = outer;
    };
    const auto workers = std::min<std::size_t>(n, static_cast<std::size_t>(threads.resolved()));
    if (workers > 0) Crew::of_process().run(workers - 1, work);
    for (const auto& failure : failures)
        if (failure) std::rethrow_exception(failure);
}

}  // namespace setae::parallel
