// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/interruption.hpp"

#include <csignal>
#include <cstdlib>

namespace setae::cli {
namespace {

std::atomic<bool> interrupted{false};
volatile std::sig_atomic_t signal_seen = 0;

void note(int number) {
    signal_seen = number;
    interrupted = true;
    std::signal(number, SIG_DFL);
}

}  // namespace

const std::atomic<bool>& interruption() {
    static_assert(std::atomic<bool>::is_always_lock_free);
    std::signal(SIGINT, note);
    std::signal(SIGTERM, note);
    return interrupted;
}

void end_as_interrupted() {
    std::signal(signal_seen, SIG_DFL);
    std::raise(signal_seen);
    std::abort();
}

}  // namespace setae::cli
