// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/rehearsal.hpp"

#include <atomic>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/platform/processes.hpp"

namespace setae::bytes {
namespace {

std::atomic<bool> left_out = false;

constexpr unsigned max_seconds = 60;

/// Reason for the failure of a child, as text.
std::string end_of_child(const platform::ProcessEnd& end) {
    if (end.out_of_time) return fmt::format("the library did not finish within {} s", max_seconds);
    if (!end.signal.empty()) return fmt::format("the library failed while reading it ({})", end.signal);
    return fmt::format("the library ended the process that reads it (exit code {})", end.exit_code);
}

}  // namespace

void rehearse(const std::string& name, const std::string& library, const std::function<void()>& use) {
    if (left_out) return;
    const auto end = platform::run_in_child(use, max_seconds);
    if (!end) throw FileError(fmt::format("{}: the process that reads the file was lost", name));
    if (end->start)
        throw FileError(
            fmt::format("{}: no process could be started to read the file ({})", name, end->start.message()));
    if (!end->well())
        throw FormatError(name, {}, fmt::format("{}: {}; the file is damaged", library, end_of_child(*end)));
}

void disable_rehearsals() { left_out = true; }

}  // namespace setae::bytes
