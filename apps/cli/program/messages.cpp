// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/messages.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"

namespace setae::cli {

void print(const std::string& text) {
    const auto shown = printable(text);
    std::fwrite(shown.data(), 1, shown.size(), stdout);
}

void complain(const std::string& message) {
    std::fflush(stdout);  // so that both streams read in order where they meet
    std::fputs(fmt::format("setae: {}\n", one_line(message)).c_str(), stderr);
}

void show(const std::vector<Alert>& alerts) {
    for (const auto& alert : alerts)
        complain(fmt::format("{}: {}: {}{}", alert.code, alert.subject, alert.message,
                             alert.action.empty() ? "" : "; " + alert.action));
}

ExitCode for_each_item(const std::vector<std::string>& items, const std::function<void(const std::string&)>& body) {
    std::size_t failed = 0;
    for (const auto& item : items) {
        try {
            body(item);
        } catch (const Error& error) {
            complain(error.what());
            ++failed;
        } catch (const std::exception& error) {
            complain(reason_of(error, item));
            ++failed;
        }
    }
    if (failed == 0) return ExitCode::done;
    return failed < items.size() ? ExitCode::some_failed : ExitCode::nothing_done;
}

std::string as_line(const Quantity& q) {
    const auto value = q.estimate.uncertain() ? format_uncertain(q.estimate, q.unit)
                                              : format_value(q.estimate.value, q.unit, 5);
    std::string line = fmt::format("{:<48} {:<16} {}", q.quantity, q.symbol, value);
    if (q.band)
        line +=
            fmt::format("   [{} … {}]", format_value(q.band->lower, "1/m", 4), format_value(q.band->upper, "1/m", 4));
    if (q.n) line += fmt::format("   n = {}", *q.n);
    if (const auto interval = interval_of(q.estimate))
        line +=
            fmt::format("   {:.0f} %: {} … {} ({})", 100.0 * interval->level, format_value(interval->lower, q.unit, 4),
                        format_value(interval->upper, q.unit, 4), q.estimate.method);
    return line + "\n";
}

}  // namespace setae::cli
