// SPDX-License-Identifier: GPL-3.0-or-later
#include "trace.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/units.hpp"
#include "setae/topography/line_scans.hpp"

namespace setae::formats {
namespace {

using topography::LineScan;
using topography::Profile;

constexpr double stray_of_step = 0.02;    ///< as for line scans
constexpr double stray_of_digit = 0.55;   ///< rounding and truncation deviate by half a digit from the line
constexpr double min_filled_nodes = 0.1;  ///< of a line with missing rows
constexpr double min_usual_steps = 0.7;   ///< of all steps: a line with missing rows, no irregular one
constexpr Index min_points = 20;          ///< needed to detect rounding or gaps

/// −1, 0 or 1.
int direction(double step) { return (step > 0.0) - (step < 0.0); }

/// The straight line through positions by index, and their deviation from it.
struct EvenSteps {
    double first = 0.0, step = 0.0, stray = 0.0;
};

EvenSteps even_steps(const Array1D& positions) {
    const auto n = static_cast<double>(positions.size());
    const double middle = 0.5 * (n - 1.0);
    double sum = 0.0;
    for (Index i = 0; i < positions.size(); ++i)
        sum += (static_cast<double>(i) - middle) * (positions[i] - positions[0]);
    EvenSteps line;
    line.step = 12.0 * sum / (n * (n * n - 1.0));
    const double mean = positions[0] + (positions - positions[0]).sum() / n;
    line.first = mean - line.step * middle;
    for (Index i = 0; i < positions.size(); ++i)
        line.stray = std::max(line.stray, std::abs(positions[i] - line.first - static_cast<double>(i) * line.step));
    return line;
}

std::string count_of(Index n, const char* one, const char* several) {
    return fmt::format("{} {}", n, n == 1 ? one : several);
}

Index repeated_positions(const Array1D& positions) {
    Index repeated = 0;
    for (Index i = 1; i < positions.size(); ++i) repeated += positions[i] == positions[i - 1];
    return repeated;
}

bool never_turns(const Array1D& positions) {
    for (Index i = 1; i < positions.size(); ++i)
        if (positions[i] < positions[i - 1]) return false;
    return true;
}

/// Equal steps hidden by rounding to the last digit, possibly with repeated positions.
std::optional<Trace> rounded_scan(const Profile& profile, double last_digit, const std::string& subject) {
    if (profile.positions.size() < min_points) return std::nullopt;
    const auto line = even_steps(profile.positions);
    if (!(line.step > 0.0) || !(line.stray <= stray_of_digit * last_digit)) return std::nullopt;
    const Index n = profile.positions.size(), repeated = repeated_positions(profile.positions);
    Trace trace{LineScan{profile.heights, line.step * static_cast<double>(n), false, profile.metadata}, {}};
    if (repeated > 0)
        trace.alerts.push_back(
            {"POSITIONS_REPEATED", subject,
             fmt::format(
                 "{} of {} points {} the position of the point before: positions rounded to {} hide equal steps "
                 "of {}, which were used; all points count",
                 repeated, n, repeated == 1 ? "has" : "have", format_value(last_digit, "m"),
                 format_value(line.step, "m")),
             "export positions with more digits"});
    return trace;
}

/// The usual step: the mean of those within half the median of all, unaffected by rounding.
double usual_step(const Array1D& positions) {
    std::vector<double> steps;
    steps.reserve(static_cast<std::size_t>(positions.size()));
    for (Index i = 1; i < positions.size(); ++i) steps.push_back(positions[i] - positions[i - 1]);
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    const double median = *middle;
    double sum = 0.0, count = 0.0;
    for (const double step : steps)
        if (std::abs(step - median) <= 0.5 * median) {
            sum += step;
            count += 1.0;
        }
    return count > 0.0 ? sum / count : median;
}

/// Nodes of positions on a line with equal steps; empty if there are none, or few are occupied.
std::optional<std::vector<Index>> nodes_of(const Array1D& positions, double last_digit) {
    const Index n = positions.size();
    if (n < min_points) return std::nullopt;
    const double usual = usual_step(positions);
    if (!(usual > 0.0)) return std::nullopt;
    std::vector<Index> nodes{0};
    Index single = 0;
    for (Index i = 1; i < n; ++i) {
        const double steps = std::round((positions[i] - positions[i - 1]) / usual);
        if (!(steps >= 1.0) || steps > static_cast<double>(n) / min_filled_nodes) return std::nullopt;
        single += steps == 1.0;
        nodes.push_back(nodes.back() + static_cast<Index>(steps));
    }
    const auto last = static_cast<double>(nodes.back());
    if (static_cast<double>(n) < min_filled_nodes * (last + 1.0) ||
        static_cast<double>(single) < min_usual_steps * static_cast<double>(n - 1))
        return std::nullopt;
    const double step = (positions[n - 1] - positions[0]) / last;
    const double allowed = std::max(stray_of_step * step, 2.0 * stray_of_digit * last_digit);
    for (Index i = 0; i < n; ++i)
        if (std::abs(positions[i] - positions[0] - static_cast<double>(nodes[static_cast<std::size_t>(i)]) * step) >
            std::min(allowed, 0.5 * step))
            return std::nullopt;
    return nodes;
}

/// A line scan whose rows of undefined heights were left out.
std::optional<Trace> scan_with_gaps(const Profile& profile, double last_digit, const std::string& subject) {
    const auto nodes = nodes_of(profile.positions, last_digit);
    if (!nodes) return std::nullopt;
    const Index n = profile.positions.size(), points = nodes->back() + 1;
    const double step = profile.size() / static_cast<double>(nodes->back());
    LineScan scan{Array1D::Constant(points, undefined), step * static_cast<double>(points), false, profile.metadata};
    Index gaps = 0, widest = 1;
    for (std::size_t i = 0; i < nodes->size(); ++i) {
        scan.heights[(*nodes)[i]] = profile.heights[static_cast<Index>(i)];
        if (i == 0) continue;
        const Index across = (*nodes)[i] - (*nodes)[i - 1];
        gaps += across > 1;
        widest = std::max(widest, across);
    }
    return Trace{
        scan,
        {{"ROWS_MISSING", subject,
          fmt::format("{} are missing in {}: steps along x are up to {} times the usual {}; the heights there are "
                      "undefined and are not interpolated",
                      count_of(points - n, "row", "rows"), count_of(gaps, "gap", "gaps"), widest,
                      format_value(step, "m")),
          "export all rows, with an empty cell where there is no height"}}};
}

/// Heights at the same position averaged.
Trace averaged(const Profile& profile, const std::string& subject) {
    const Index n = profile.positions.size(), repeated = repeated_positions(profile.positions);
    const bool errors = profile.standard_error.size() > 0;
    Profile kept = profile;
    Index to = 0;
    for (Index i = 0; i < n;) {
        Index end = i + 1;
        while (end < n && profile.positions[end] == profile.positions[i]) ++end;
        double sum = 0.0, squares = 0.0;
        Index defined = 0;
        for (Index k = i; k < end; ++k)
            if (std::isfinite(profile.heights[k])) {
                sum += profile.heights[k];
                if (errors) squares += profile.standard_error[k] * profile.standard_error[k];
                ++defined;
            }
        kept.positions[to] = profile.positions[i];
        kept.heights[to] = defined > 0 ? sum / static_cast<double>(defined) : undefined;
        if (errors)
            kept.standard_error[to] =
                defined > 0 ? std::sqrt(squares) / static_cast<double>(defined) : profile.standard_error[i];
        ++to;
        i = end;
    }
    kept.positions.conservativeResize(to);
    kept.heights.conservativeResize(to);
    if (errors) kept.standard_error.conservativeResize(to);
    return {
        std::move(kept),
        {{"POSITIONS_REPEATED", subject,
          fmt::format("{} of {} points {} the position of the point before: heights at equal positions were averaged, "
                      "{} points remain",
                      repeated, n, repeated == 1 ? "has" : "have", to),
          "look at the profile; if positions are rounded, export them with more digits"}}};
}

/// The profile with x from left to right.
void turn(Profile& profile) {
    profile.positions.reverseInPlace();
    profile.heights.reverseInPlace();
    profile.standard_error.reverseInPlace();
}

}  // namespace

std::vector<Pass> passes_of(const Array1D& positions) {
    constexpr Index min_of_pass = 8;
    const Index n = positions.size();
    const double half = 0.5 * (positions.maxCoeff() - positions.minCoeff());
    std::vector<Pass> passes{{0, 0, false}};
    int along = 0;
    for (Index i = 1; i < n; ++i) {
        const double step = positions[i] - positions[i - 1];
        const int sign = direction(step);
        auto& pass = passes.back();
        const bool jumps_back = along != 0 && sign == -along && std::abs(step) >= half;
        const bool repeats_end =
            sign == 0 && i + 1 < n && direction(positions[i + 1] - positions[i]) == -along && along != 0;
        if (jumps_back || repeats_end || (along != 0 && sign == -along)) {
            passes.push_back({i, i, false});
            along = jumps_back || repeats_end ? 0 : sign;
            if (along != 0) passes.back().backward = along < 0;
            continue;
        }
        if (along == 0 && sign != 0) {
            along = sign;
            pass.backward = sign < 0;
        }
        pass.last = i;
    }
    const bool all_wide = std::all_of(passes.begin(), passes.end(), [&](const Pass& pass) {
        return pass.last - pass.first + 1 >= min_of_pass &&
               std::abs(positions[pass.last] - positions[pass.first]) >= half;
    });
    if (passes.size() > 1 && all_wide) return passes;
    return {{0, n - 1, false}};
}

bool are_scattered(const Array1D& positions) {
    constexpr Index min_scattered = 10;
    constexpr double far = 0.1;
    const Index n = positions.size();
    if (n < min_scattered) return false;
    const double range = positions.maxCoeff() - positions.minCoeff();
    Index jumps = 0;
    int turns = 0, along = 0;
    for (Index i = 1; i < n; ++i) {
        const double step = positions[i] - positions[i - 1];
        jumps += std::abs(step) >= far * range;
        turns += along != 0 && direction(step) == -along;
        if (step != 0.0) along = direction(step);
    }
    return turns > 2 && 2 * jumps >= n;
}

double last_digit(const Array1D& positions) {
    constexpr int max_digits = 9;
    constexpr double rounding = 1e-6;
    const double largest = positions.abs().maxCoeff();
    if (!(largest > 0.0) || !std::isfinite(largest)) return 0.0;
    const int first = -static_cast<int>(std::floor(std::log10(largest)));  // places after the point of its first digit
    for (int places = first; places < first + max_digits; ++places) {
        const double digit = std::pow(10.0, static_cast<double>(-places));
        const bool all = std::all_of(positions.begin(), positions.end(), [digit](double x) {
            return std::abs(x / digit - std::round(x / digit)) <= rounding;
        });
        if (all) return digit;
    }
    return 0.0;
}

namespace {

/// The trace of positions that do not turn and have no equal steps within 2 %.
Trace traced_unevenly(Profile profile, double last_digit, const std::string& subject) {
    const bool stays_profile = profile.response || profile.standard_error.size() > 0;
    if (!stays_profile) {
        if (auto scan = rounded_scan(profile, last_digit, subject)) return std::move(*scan);
        if (auto scan = scan_with_gaps(profile, last_digit, subject)) return std::move(*scan);
    }
    if (repeated_positions(profile.positions) == 0) return {std::move(profile), {}};
    auto trace = averaged(profile, subject);
    const auto& kept = std::get<Profile>(trace.measurement);
    if (stays_profile || kept.positions.size() < 2) return trace;
    auto again = traced_unevenly(kept, last_digit, subject);
    if (auto scan = topography::to_line_scan(kept)) again = {std::move(*scan), {}};
    again.alerts.insert(again.alerts.begin(), trace.alerts.begin(), trace.alerts.end());
    return again;
}

}  // namespace

Trace traced(Profile profile, const Array1D& stated, double unit, const std::string& subject) {
    const bool decreases = profile.positions[profile.positions.size() - 1] < profile.positions[0];
    if (decreases && never_turns(-profile.positions)) turn(profile);
    if (auto scan = topography::to_line_scan(profile)) return {std::move(*scan), {}};
    if (!never_turns(profile.positions)) return {std::move(profile), {}};
    return traced_unevenly(std::move(profile), unit * last_digit(stated), subject);
}

}  // namespace setae::formats
