// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/messages.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/output/alert_kinds.hpp"

namespace setae::cli {
namespace {

fields::Spelling& option_spelling() {
    static fields::Spelling spelling = [](std::string_view, std::string_view) { return std::string(); };
    return spelling;
}

bool& every_warning() {
    static bool every = false;
    return every;
}

}  // namespace

void spell_options_by(fields::Spelling spelling) { option_spelling() = std::move(spelling); }

void print(const std::string& text) {
    const auto shown = printable(text);
    std::fwrite(shown.data(), 1, shown.size(), stdout);
}

void print_for_reader(const std::string& text) {
    std::fflush(stdout);
    std::fputs(printable(text).c_str(), stderr);
}

void print_message(const std::string& message) {
    std::fflush(stdout);  // so that both streams have the right order on one terminal
    std::fputs(fmt::format("setae: {}\n", one_line(fields::spelled(message, option_spelling()))).c_str(), stderr);
}

void show(const std::vector<Alert>& alerts) {
    for (const auto& line : lines_of(alerts)) print_message(line);
}

void show_every_warning(bool every) { every_warning() = every; }

std::vector<std::string> lines_of(const std::vector<Alert>& alerts, std::string (*line_of)(const Alert&)) {
    if (!every_warning()) return output::warning_lines(alerts, line_of);
    std::vector<std::string> lines;
    for (const auto& alert : alerts) lines.push_back(line_of(alert));
    return lines;
}

std::vector<Alert> show_reading_warnings(std::vector<Alert> alerts) {
    const auto others = std::stable_partition(alerts.begin(), alerts.end(),
                                              [](const Alert& alert) { return output::concerns_reading(alert.code); });
    show({alerts.begin(), others});
    return {others, alerts.end()};
}

ExitCode for_each_item(const std::vector<std::string>& items, const std::function<void(const std::string&)>& body) {
    std::size_t failed = 0;
    for (const auto& item : items) {
        try {
            body(item);
        } catch (const Error& error) {
            print_message(error.what());
            ++failed;
        } catch (const std::exception& error) {
            print_message(reason_of(error, item));
            ++failed;
        }
    }
    if (failed == 0) return ExitCode::done;
    return failed < items.size() ? ExitCode::some_failed : ExitCode::nothing_done;
}

}  // namespace setae::cli
