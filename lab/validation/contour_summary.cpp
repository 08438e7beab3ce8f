// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/contour_summary.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"

namespace setae::validation {
namespace {

constexpr double largest_rms_error = 0.5, height_tolerance = 0.02, spectrum_tolerance = 0.1;  // px, 1, 1

using Members = std::vector<const ContourTrial*>;

/// Numbers of the runs that have one; `ideal`: expected value.
template <class Value>
OverRuns over_runs(const Members& members, double ideal, Value value) {
    OverRuns result{.mean = undefined, .standard_error = undefined, .worst = undefined};
    double sum = 0.0, squares = 0.0;
    for (const auto* trial : members) {
        const double number = value(*trial);
        if (!trial->refusal.empty() || !std::isfinite(number)) continue;
        ++result.count;
        sum += number;
        if (!(std::abs(number - ideal) <= std::abs(result.worst - ideal))) {
            result.worst = number;
            result.worst_run = trial->run;
        }
    }
    if (result.count == 0) return result;
    result.mean = sum / result.count;
    for (const auto* trial : members)
        if (const double number = value(*trial); trial->refusal.empty() && std::isfinite(number))
            squares += std::pow(number - result.mean, 2);
    if (result.count > 1) result.standard_error = std::sqrt(squares / (result.count - 1.0) / result.count);
    return result;
}

ContourRow row_of(const Members& members) {
    ContourRow row{
        .kind = members.front()->kind, .judged = members.front()->judged, .runs = static_cast<int>(members.size())};
    row.segments = over_runs(members, 1.0, [](const auto& t) { return static_cast<double>(t.segments); });
    row.completeness = over_runs(members, 1.0, [](const auto& t) { return t.completeness; });
    row.rms_error = over_runs(members, 0.0, [](const auto& t) { return t.rms_error; });
    row.largest_error = over_runs(members, 0.0, [](const auto& t) { return t.largest_error; });
    row.offset = over_runs(members, 0.0, [](const auto& t) { return t.offset; });
    row.within_two_errors = over_runs(members, 0.954, [](const auto& t) { return t.within_two_errors; });
    row.rms_height_ratio = over_runs(members, 1.0, [](const auto& t) { return t.rms_height_ratio; });
    row.floor_ratio = over_runs(members, 1.0, [](const auto& t) { return t.floor_ratio; });
    row.overhang_depth_ratio = over_runs(members, 1.0, [](const auto& t) { return t.overhang_depth_ratio; });
    for (std::size_t band = 0; band < row.spectrum_ratio.size(); ++band)
        row.spectrum_ratio[band] = over_runs(members, 1.0, [band](const auto& t) { return t.spectrum_ratio[band]; });
    for (const auto* trial : members) {
        if (!trial->refusal.empty()) ++row.refused;
        if (trial->vacuum_mistaken) ++row.vacuum_mistaken;
        row.overhangs += trial->overhangs;
        row.overhangs_found += trial->overhangs_found;
        row.overhangs_false += trial->overhangs_false;
    }
    return row;
}

/// Ends of a half decade of waves [px], the longer first.
std::array<double, 2> band_ends(std::size_t band) {
    return {spectrum_band_ends[band],
            band + 1 < spectrum_band_ends.size() ? spectrum_band_ends[band + 1] : shortest_compared_wave};
}

std::string percent(const OverRuns& ratio) {
    if (ratio.count == 0) return "-";
    const auto error =
        std::isfinite(ratio.standard_error) ? fmt::format("{:.1f}", 100.0 * ratio.standard_error) : std::string("?");
    return fmt::format("{:+.1f} ± {}", 100.0 * (ratio.mean - 1.0), error);
}

void judge(std::vector<ContourVerdict>& verdicts, const ContourRow& row) {
    const auto add = [&](const std::string& criterion, bool passed, const std::string& found) {
        verdicts.push_back({row.kind, criterion, passed, found});
    };
    add("every picture traced", row.refused == 0, fmt::format("{} of {} refused", row.refused, row.runs));
    if (row.refused == row.runs) return;
    add("vacuum distinguished from the sample", row.vacuum_mistaken == 0,
        fmt::format("mistaken in {} of {}", row.vacuum_mistaken, row.runs));
    add(fmt::format("rms error below {} px in every run", largest_rms_error), row.rms_error.worst < largest_rms_error,
        fmt::format("{:.3f} px on average, {:.3f} px in run {}", row.rms_error.mean, row.rms_error.worst,
                    row.rms_error.worst_run));
    add("overhangs all found, none false", row.overhangs_found == row.overhangs && row.overhangs_false == 0,
        fmt::format("{} of {} found, {} false", row.overhangs_found, row.overhangs, row.overhangs_false));
    add(fmt::format("Rq within {:g} % in every run", 100.0 * height_tolerance),
        std::abs(row.rms_height_ratio.worst - 1.0) <= height_tolerance,
        fmt::format("{:+.2f} % on average, {:+.2f} % in run {}", 100.0 * (row.rms_height_ratio.mean - 1.0),
                    100.0 * (row.rms_height_ratio.worst - 1.0), row.rms_height_ratio.worst_run));
    for (std::size_t band = 0; band < row.spectrum_ratio.size(); ++band) {
        const auto& ratio = row.spectrum_ratio[band];
        if (ratio.count == 0) continue;
        const auto [longest, shortest] = band_ends(band);
        add(fmt::format("C1D of waves of {:.0f} to {:.0f} px within {:g} % on average", longest, shortest,
                        100.0 * spectrum_tolerance),
            std::abs(ratio.mean - 1.0) <= spectrum_tolerance,
            percent(ratio) + fmt::format(" % in {} runs", ratio.count));
    }
}

}  // namespace

std::vector<ContourRow> contour_summary(const std::vector<ContourTrial>& trials) {
    std::vector<Members> groups;
    for (const auto& trial : trials) {
        const auto place =
            std::find_if(groups.begin(), groups.end(), [&](const Members& g) { return g.front()->kind == trial.kind; });
        if (place == groups.end()) groups.push_back({&trial});
        else place->push_back(&trial);
    }
    std::vector<ContourRow> rows;
    for (const auto& group : groups) rows.push_back(row_of(group));
    return rows;
}

std::vector<ContourVerdict> contour_verdicts(const std::vector<ContourRow>& rows) {
    std::vector<ContourVerdict> verdicts;
    for (const auto& row : rows)
        if (row.judged) judge(verdicts, row);
    return verdicts;
}

std::string contour_table(const std::vector<ContourRow>& rows) {
    std::string text =
        fmt::format("{:<22} {:>4} {:>7} {:>7} {:>6} {:>6} {:>8} {:>8} {:>6} {:>8} {:>8} {:>6} {:>11} {:>5}\n", "kind",
                    "n", "refused", "traced", "rms", "worst", "largest", "offset", "in 2σ", "Rq [%]", "worst", "floor",
                    "overhangs", "false");
    for (const auto& row : rows)
        text += fmt::format(
            "{:<22} {:>4} {:>7} {:>7.3f} {:>6.3f} {:>6.3f} {:>8.2f} {:>+8.3f} {:>6.3f} {:>+8.2f} {:>+8.2f} {:>6} {:>11} {:>5}\n",
            row.kind, row.runs, row.refused, row.completeness.mean, row.rms_error.mean, row.rms_error.worst,
            row.largest_error.worst, row.offset.mean, row.within_two_errors.mean,
            100.0 * (row.rms_height_ratio.mean - 1.0), 100.0 * (row.rms_height_ratio.worst - 1.0),
            row.floor_ratio.count > 0 ? fmt::format("{:.2f}", row.floor_ratio.mean) : "-",
            fmt::format("{}/{}", row.overhangs_found, row.overhangs), row.overhangs_false);
    text += fmt::format("\n{:<22}", "C1D [%], waves [px]");
    for (std::size_t band = 0; band < spectrum_band_ends.size(); ++band)
        text += fmt::format(" {:>15}", fmt::format("{:.0f} to {:.0f}", band_ends(band)[0], band_ends(band)[1]));
    for (const auto& row : rows) {
        text += fmt::format("\n{:<22}", row.kind);
        for (const auto& ratio : row.spectrum_ratio) text += fmt::format(" {:>15}", percent(ratio));
    }
    text += "\n\n";
    const auto verdicts = contour_verdicts(rows);
    for (const auto& verdict : verdicts)
        if (!verdict.passed)
            text += fmt::format("failed: {}: {}: {}\n", verdict.kind, verdict.criterion, verdict.found);
    return text + fmt::format("{} of {} criteria met\n",
                              std::count_if(verdicts.begin(), verdicts.end(), [](const auto& v) { return v.passed; }),
                              verdicts.size());
}

std::string contour_trials_csv(const std::vector<ContourTrial>& trials) {
    std::string text =
        "kind,run,segments,vacuum_mistaken,completeness,rms_error,largest_error,offset,within_two_errors,rms_height_ratio,floor_ratio,smoothing_length,edge_width,overhangs,overhangs_found,"
        "overhangs_false,overhang_depth_ratio";
    for (std::size_t band = 0; band < spectrum_band_ends.size(); ++band)
        text += fmt::format(",spectrum_ratio_{:.0f}_{:.0f}", band_ends(band)[0], band_ends(band)[1]);
    text += ",refusal\n";
    const auto cell = [](double value) { return std::isfinite(value) ? fmt::format("{}", value) : std::string(); };
    for (const auto& t : trials) {
        const bool refused = !t.refusal.empty();
        const auto number = [&](double value) { return refused ? std::string() : cell(value); };
        text +=
            fmt::format("\"{}\",{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", t.kind, t.run, t.segments,
                        t.vacuum_mistaken ? 1 : 0, number(t.completeness), number(t.rms_error), number(t.largest_error),
                        number(t.offset), number(t.within_two_errors), number(t.rms_height_ratio),
                        number(t.floor_ratio), number(t.smoothing_length), number(t.edge_width), t.overhangs,
                        t.overhangs_found, t.overhangs_false, number(t.overhang_depth_ratio));
        for (const double ratio : t.spectrum_ratio) text += "," + number(ratio);
        std::string reason = t.refusal;
        std::replace(reason.begin(), reason.end(), '"', '\'');
        text += refused ? fmt::format(",\"{}\"\n", reason) : ",\n";
    }
    return text;
}

}  // namespace setae::validation
