// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/screen.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "reading_tables.hpp"
#include "setae/core/layout.hpp"
#include "setae/core/words.hpp"
#include "setae/output/verdict.hpp"

namespace setae::output {
namespace {

using study::StudyResult;

std::size_t lines_in(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// Equations stay on one line.
std::string unbroken(std::string text) {
    for (std::size_t at = 0; (at = text.find(" = ", at)) != std::string::npos;) text.replace(at, 3, "\u00A0=\u00A0");
    return text;
}

std::string title_of(const StudyResult& result, std::size_t width) {
    return result.study.title.empty() ? std::string() : shortened(result.study.title, width) + "\n\n";
}

/// Leading sentences in so many lines, at least the first.
std::string leading(const std::vector<std::string>& sentences, std::size_t lines, std::size_t width) {
    std::string text;
    for (const auto& sentence : sentences) {
        const auto next = wrapped(unbroken(sentence), width) + "\n";
        if (!text.empty() && lines_in(text) + lines_in(next) > lines) break;
        text += next;
    }
    return text;
}

/// "Reservation 1 of 9: …" in so many lines; those that do not fit are left to the report.
std::string reservation_lines(const Verdict& said, std::size_t lines, std::size_t width) {
    std::string text;
    for (std::size_t i = 0; i < said.reservations.size(); ++i) {
        const auto next =
            wrapped(unbroken(fmt::format("Reservation {} of {}: {}", i + 1, said.limits.size(), said.reservations[i])),
                    width, 2) +
            "\n";
        if (lines_in(text) + lines_in(next) <= lines) text += next;
    }
    return text;
}

/// Subject of a warning, without the folders of files.
std::string name_of(const Alert& alert) { return alert.subject.substr(alert.subject.find_last_of('/') + 1); }

/// "  NO_TIP_RADIUS (3)  scan.spm: no radius of the afm's tip is known: …".
std::string alert_lines(const std::vector<AlertGroup>& groups, std::size_t most, std::size_t width) {
    if (groups.empty() || most == 0) return "";
    std::string text = "Warnings\n";
    const bool cut = groups.size() > most;
    for (std::size_t i = 0; i < (cut ? most - 1 : groups.size()); ++i) {
        const auto& [code, alerts] = groups[i];
        const auto count = alerts.size() > 1 ? fmt::format(" ({})", alerts.size()) : std::string();
        text += shortened(fmt::format("  {}{}  {}: {}", code, count, name_of(alerts.front()), alerts.front().message),
                          width) +
                "\n";
    }
    if (const auto left = groups.size() - (most - 1); cut)
        text += fmt::format("  and {}\n", counted(left, "more kind", "more kinds"));
    return text + "\n";
}

/// Title, columns, "and so many more", a blank line.
constexpr std::size_t frame = 4;

/// Lines of each row: one, or more where rows are stacked.
std::size_t lines_of_rows(const tables::TidyTable& table, std::size_t width) {
    constexpr std::size_t max_heads = 2;
    const auto lines = lines_in(tables::as_text_within(table, width));
    return std::max<std::size_t>((lines - std::min(lines, max_heads) + table.rows.size() - 1) / table.rows.size(), 1);
}

/// A table whose rows take no more than so many lines, and how many rows more there are.
std::string cut_table(tables::TidyTable table, std::size_t most, const char* file, std::size_t width) {
    const auto all = table.rows.size();
    auto shown = std::min(all, std::max<std::size_t>(most / lines_of_rows(table, width), 1));
    constexpr std::size_t heads = 2;
    auto text = std::string();
    do {
        table.rows.resize(shown);
        text = tables::as_text_within(table, width);
    } while (lines_in(text) > most + heads && shown-- > 1);
    shown = table.rows.size();
    if (all > shown) text += fmt::format("  and {} more in {}\n", all - shown, file);
    return text + "\n";
}

/// Tables whose rows share the lines that are left: each as many as it has, while a fair part is kept for the others.
class Shared {
public:
    void add(tables::TidyTable table, const char* file, std::size_t width) {
        if (table.rows.empty()) return;
        const auto lines = table.rows.size() * lines_of_rows(table, width);
        tables_.push_back({std::move(table), file, lines});
    }

    [[nodiscard]] std::string text(std::size_t lines, std::size_t width) const {
        std::string text;
        auto left = lines;
        for (std::size_t i = 0; i < tables_.size(); ++i) {
            const auto fair = left / (tables_.size() - i);
            std::size_t others = 0;
            for (std::size_t k = i + 1; k < tables_.size(); ++k)
                others += std::min(tables_[k].lines + frame, std::max(fair, frame + 1));
            const auto part = left > others ? left - others : 0;
            const auto own = part > frame ? part - frame : 1;
            text += cut_table(tables_[i].table, own, tables_[i].file, width);
            left -= std::min(left, std::min(own, tables_[i].lines) + frame);
        }
        return text;
    }

private:
    struct Entry {
        tables::TidyTable table;
        const char* file;
        std::size_t lines;  ///< lines of its rows
    };
    std::vector<Entry> tables_;
};

}  // namespace

std::string screen(const StudyResult& result, const Screen& size, std::size_t reserved) {
    constexpr std::size_t max_kinds = 6, min_kinds = 2;
    constexpr std::size_t of_tables = 3 * (frame + 1);  // a row of each
    const auto said = verdict(result);
    const auto groups = grouped_alerts(result);
    // reservations state consequences of warnings: they replace as many of their lines
    const auto reservations = reservation_lines(said, max_kinds - min_kinds, size.width);
    const auto alerts = alert_lines(groups, max_kinds - lines_in(reservations), size.width);
    const auto title = title_of(result, size.width);
    const auto others = lines_in(title) + lines_in(reservations) + 1 + of_tables + lines_in(alerts) + reserved;
    const auto head =
        title + leading(said.answer, size.lines > others ? size.lines - others : 0, size.width) + reservations + "\n";
    Shared shared;
    shared.add(reading::surfaces(result, reading::Spectra::used), "surfaces.csv", size.width);
    auto pairs = reading::pairs(result);
    const bool pairless = pairs.rows.empty();
    shared.add(std::move(pairs), "pairs.csv", size.width);
    shared.add(pairless ? reading::loops(result) : reading::fits(result), pairless ? "loop_fits.csv" : "fits.csv",
               size.width);
    const auto taken = lines_in(head) + lines_in(alerts) + reserved;
    return head + shared.text(size.lines > taken ? size.lines - taken : 0, size.width) + alerts;
}

std::string summary(const StudyResult& result, std::size_t width) {
    auto text =
        result.study.title + "\n" + (result.study.description.empty() ? "" : result.study.description + "\n") + "\n";
    const auto said = verdict(result);
    for (const auto& sentence : said.answer) text += wrapped(sentence, width) + "\n";
    for (const auto& sentence : said.findings) text += wrapped("+ " + sentence, width, 2) + "\n";
    for (const auto& sentence : said.limits) text += wrapped("- " + sentence, width, 2) + "\n";
    text += "\n";
    for (const auto& table :
         {reading::surfaces(result, reading::Spectra::all), reading::agreement(result), reading::elastomers(result),
          reading::loops(result), reading::work_along(result), reading::references(result), reading::all_pairs(result),
          reading::all_fits(result), reading::cutoffs(result)})
        if (!table.rows.empty()) text += tables::as_text_within(table, width) + "\n";
    if (const auto groups = grouped_alerts(result); !groups.empty()) {
        text += "Warnings\n";
        for (const auto& [code, alerts] : groups)
            for (const auto& alert : alerts)
                text += wrapped(fmt::format("  {}: {}: {}; {}", code, alert.subject, alert.message, alert.action),
                                width, 4) +
                        "\n";
        text += "\n";
    }
    return text + "± is one standard error, [ ] the 95 % interval.\n\n";
}

}  // namespace setae::output
