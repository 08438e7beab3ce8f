// SPDX-License-Identifier: GPL-3.0-or-later
#include "running_calls.hpp"

#include <condition_variable>
#include <mutex>
#include <set>

#include <nanobind/nanobind.h>

namespace setae::python {
namespace {

struct Calls {
    std::mutex mutex;
    std::condition_variable over;
    std::set<std::atomic<bool>*> running;
    bool ended = false;
    bool forked = false;  ///< this process is a fork; its parent may have had threads in calls
};

Calls* calls = new Calls;  // not destroyed, because threads may run longer than main()

}  // namespace

RunningCall::RunningCall(std::atomic<bool>& cancelled) : cancelled_(cancelled) {
    auto& all = *calls;
    const std::lock_guard lock(all.mutex);
    if (all.ended) throw Interrupted();
    all.running.insert(&cancelled_);
}

RunningCall::~RunningCall() {
    auto& all = *calls;
    {
        const std::lock_guard lock(all.mutex);
        all.running.erase(&cancelled_);
    }
    all.over.notify_all();
}

void forget_running_calls() {
    calls = new Calls;
    calls->forked = true;
}

bool end_running_calls() {
    const nanobind::gil_scoped_release released;
    auto& all = *calls;
    std::unique_lock lock(all.mutex);
    const bool threads = all.forked || !all.running.empty();
    all.ended = true;
    for (auto* cancelled : all.running) *cancelled = true;
    all.over.wait(lock, [&] { return all.running.empty(); });
    return threads;
}

}  // namespace setae::python
