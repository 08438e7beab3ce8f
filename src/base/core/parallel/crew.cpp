// SPDX-License-Identifier: GPL-3.0-or-later
#include "crew.hpp"

#include <algorithm>
#include <system_error>
#include <thread>

#include "setae/platform/processes.hpp"

namespace setae::parallel {
namespace {

/// Polls of a thread before it sleeps: about ten microseconds of its own, then a few hundred polls between which other
/// threads may run. The next short loop often comes in that time, and waking a thread takes as long as such a loop.
constexpr int looks = 400, patient_looks = 400;

template <class Condition>
bool soon(const Condition& condition) {
    for (int look = 0; look < looks; ++look) {
        if (condition()) return true;
#if defined(__x86_64__) || defined(__i386__)
        __builtin_ia32_pause();
#endif
    }
    for (int look = 0; look < patient_looks; ++look) {
        if (condition()) return true;
        std::this_thread::yield();
    }
    return condition();
}

// waiting threads outlive main(), so the crew is never destroyed
std::atomic<Crew*> crew{nullptr};

}  // namespace

Crew& Crew::of_process() {
    static const bool first = [] {
        crew = new Crew;
        platform::in_every_child([] { crew = new Crew; });  // threads do not exist in the child
        return true;
    }();
    (void)first;
    return *crew;
}

void Crew::run(std::size_t helpers, const std::function<void()>& work) {
    if (helpers == 0) return work();
    Loop loop{work, helpers};
    invite(loop);
    work();
    dismiss(loop);
}

void Crew::invite(Loop& loop) {
    {
        const std::lock_guard lock(mutex_);
        loops_.push_back(&loop);
        places_ += loop.places;
        try {
            for (; idle_ < places_; ++idle_) std::thread([this] { help(); }).detach();
        } catch (const std::system_error&) {
            // no further thread can be started: the existing ones do the work
        }
    }
    wake_.notify_all();
}

void Crew::dismiss(Loop& loop) {
    {
        const std::lock_guard lock(mutex_);
        if (loop.places > 0) loops_.erase(std::find(loops_.begin(), loops_.end(), &loop));
        places_ -= loop.places;
        loop.places = 0;
    }
    (void)soon([&] { return loop.active == 0; });
    std::unique_lock lock(mutex_);  // the helper has released the loop, too
    done_.wait(lock, [&] { return loop.active == 0; });
}

void Crew::help() {
    std::unique_lock lock(mutex_);
    while (true) {
        wake_.wait(lock, [&] { return places_ > 0; });
        Loop& loop = *loops_.front();
        if (--loop.places == 0) loops_.pop_front();
        --places_;
        --idle_;
        ++loop.active;
        lock.unlock();
        loop.work();
        lock.lock();
        ++idle_;
        --loop.active;
        done_.notify_all();
        lock.unlock();
        (void)soon([&] { return places_ > 0; });
        lock.lock();
    }
}

}  // namespace setae::parallel
