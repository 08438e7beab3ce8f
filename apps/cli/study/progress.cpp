// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/progress.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "program/messages.hpp"
#include "program/terminal.hpp"
#include "setae/platform/terminal.hpp"

namespace setae::cli {
namespace {

ProgressMode resolved(ProgressMode mode) {
    if (mode != ProgressMode::automatic) return mode;
    return platform::is_terminal(platform::Stream::errors) ? ProgressMode::bar : ProgressMode::none;
}

double seconds(std::chrono::steady_clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

std::string duration_text(double seconds_left) {
    const auto whole = static_cast<long>(seconds_left + 0.5);
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace

ProgressDisplay::ProgressDisplay(ProgressMode mode) : mode_(resolved(mode)), start_(Clock::now()) {}

std::optional<double> ProgressDisplay::remaining(double elapsed) const {
    constexpr double min_share = 0.02;  // before this share, the estimate is not stable
    if (last_.done == last_.total) return 0.0;
    if (last_.computed_share < min_share) return std::nullopt;
    return elapsed / last_.computed_share * (1.0 - last_.share);
}

void ProgressDisplay::show(const study::Progress& progress) {
    const std::lock_guard lock(mutex_);
    last_ = progress;
    if (mode_ == ProgressMode::none) return;
    const auto now = Clock::now();
    const bool last = progress.done == progress.total;
    if (!last && progress.stage == shown_stage_ && seconds(now - shown_) < 0.1) return;
    shown_ = now;
    shown_stage_ = progress.stage;
    print(seconds(now - start_));
    line_ = mode_ == ProgressMode::bar;
}

void ProgressDisplay::print(double elapsed) const {
    const auto left = remaining(elapsed);
    if (mode_ == ProgressMode::json) {
        using Json = nlohmann::ordered_json;
        const Json line{{"event", last_.begins ? "begin" : "done"},
                        {"done", last_.done},
                        {"total", last_.total},
                        {"stage", last_.stage},
                        {"item", last_.item},
                        {"cached", last_.cached},
                        {"elapsed_s", elapsed},
                        {"remaining_s", left ? Json(*left) : Json(nullptr)}};
        std::fputs((line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n").c_str(), stderr);
        return;
    }
    constexpr std::size_t width = 24;
    const auto filled = std::min(width, static_cast<std::size_t>(static_cast<double>(width) * last_.share));
    auto text = fmt::format("[{}{}] {} of {}  {}{}", std::string(filled, '#'), std::string(width - filled, '.'),
                            last_.done, last_.total, left ? duration_text(*left) + " left  " : std::string(),
                            last_.stage == "measurement" || last_.stage == "experiment"
                                ? std::filesystem::path(last_.item).filename().string()
                                : last_.stage + " " + last_.item);
    if (const auto columns = columns_of_errors(); text.size() >= columns) text.resize(columns - 1);
    std::fputs(("\r\x1b[K" + text).c_str(), stderr);
    std::fflush(stderr);
}

void ProgressDisplay::finish() {
    const std::lock_guard lock(mutex_);
    if (line_) std::fputs("\r\x1b[K", stderr);
    line_ = false;
}

}  // namespace setae::cli
