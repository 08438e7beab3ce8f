// SPDX-License-Identifier: GPL-3.0-or-later
#include "session.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::cli {

void add_common(CLI::App& verb, Common& common) {
    verb.add_flag("--json", common.json, "print JSON, SI units");
    verb.add_flag("--explain", common.explain, "print formulas and sources, then stop");
    verb.add_option("--threads", common.threads, "number of threads; the result is the same for any")
        ->check(CLI::Range(1, 1024))
        ->option_text("N");
}

void print(const std::string& text) { std::fputs(text.c_str(), stdout); }

ExitCode explained(const char* explanation) {
    print(explanation);
    return ExitCode::done;
}

void print_json(const output::Json& json) { print(json.dump(2) + "\n"); }

void complain(const std::string& message) {
    std::fflush(stdout);  // so that both streams read in order where they meet
    std::fputs(fmt::format("setae: {}\n", message).c_str(), stderr);
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
        }
    }
    if (failed == 0) return ExitCode::done;
    return failed < items.size() ? ExitCode::some_failed : ExitCode::nothing_done;
}

std::string as_line(const Quantity& q) {
    std::string value = format_value(q.estimate.value, q.unit, 5);
    if (q.estimate.uncertain()) value += " ± " + format_value(q.estimate.standard_error, q.unit, 2);
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

void add_layout_option(CLI::App& verb, std::string& as) {
    verb.add_option(
            "--as", as,
            "how text of three columns is read: matrix, a narrow map, or columns, points x y z; default: from the numbers")
        ->check(CLI::IsMember({"matrix", "columns"}).description(""));
}

void FileOptions::add_to(CLI::App& verb) {
    verb.add_option("--size", size, "extent where the file leaves it open: \"1 mm x 1 mm\" or \"2 mm\"");
    verb.add_option("--unit", unit,
                    "unit of lengths where the file leaves it open, such as um; \"mm, um\": of x, then of heights");
    add_layout_option(verb, as);
    verb.add_option("--channel", channel, "channel, counted from 0 as `setae info` lists them");
}

formats::ReadOptions FileOptions::read_options() const {
    formats::ReadOptions options;
    if (!unit.empty()) options.unit = unit;
    if (!as.empty()) options.layout = as == "matrix" ? formats::TextLayout::matrix : formats::TextLayout::columns;
    if (size.empty()) return options;
    std::vector<double> lengths;
    std::string rest = size;
    for (std::size_t at = rest.find(" x "); at != std::string::npos; at = rest.find(" x ")) {
        lengths.push_back(parse_quantity(rest.substr(0, at), dimension::length));
        rest = rest.substr(at + 3);
    }
    lengths.push_back(parse_quantity(rest, dimension::length));
    if (lengths.size() > 2)
        throw InvalidArgument(
            fmt::format("'{}' has {} lengths; expected \"1 mm x 1 mm\" or \"2 mm\"", size, lengths.size()));
    options.size = lengths;
    return options;
}

}  // namespace setae::cli
