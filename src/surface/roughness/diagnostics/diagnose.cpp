// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/diagnostics/diagnose.hpp"

#include <cmath>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "evidence.hpp"
#include "options.hpp"
#include "setae/core/errors.hpp"
#include "setae/topography/contour.hpp"
#include "setae/topography/line_scans.hpp"

namespace setae::diagnostics {
namespace {

using topography::Profile;

void add(std::vector<Finding>& findings, Found finding) {
    if (finding) findings.push_back(std::move(*finding));
}

void add(std::vector<Finding>& findings, std::vector<Finding> more) {
    for (auto& finding : more) findings.push_back(std::move(finding));
}

/// Runs tasks, simultaneously if possible.
void side_by_side(const std::vector<std::function<void()>>& tasks, parallel::Threads threads) {
    parallel::for_each_index(tasks.size(), threads, [&](std::size_t i) { tasks[i](); });
}

/// In the order of the page of diagnostics. The heights are changed in place between the stages.
std::vector<Finding> diagnosed(Evidence evidence, const topography::Measurement& measurement,
                               const DiagnosisOptions& options) {
    const auto threads = options.threads;
    std::vector<Finding> findings;
    add(findings, undefined_heights(evidence));
    if (evidence.flat) {
        add(findings, constant_heights(evidence));
        return findings;
    }
    Levels levels;
    side_by_side({[&] { levels = levels_of(evidence, threads); }, [&] { evidence.form = form_of(evidence, threads); },
                  [&] {
                      if (!evidence.is_line) evidence.scars = scar_points(evidence.heights, threads);
                  }},
                 threads);
    if (levels.digitised) add(findings, quantised(evidence, *levels.digitised));
    add(findings, std::move(levels.clipped));
    add(findings, large_tilt(evidence));
    add(findings, curvature_left(evidence));
    auto found_scars = scars(evidence);
    clean(evidence, threads);
    add(findings, spikes(evidence, threads));
    add(findings, std::move(found_scars));
    Found noise, tip, gap;
    side_by_side({[&] { noise = pixel_noise(evidence, options); }, [&] { tip = tip_cutoff(measurement, threads); },
                  [&] { gap = low_wavevector_gap(evidence, options); }},
                 threads);
    for (auto* finding : {&noise, &tip, &gap}) add(findings, std::move(*finding));
    add(findings, directions(evidence, options));
    return findings;
}

/// A map or line scan in `measurement`, passed separately because another measurement would need a copy of its heights.
template <class Uniform>
std::vector<Finding> diagnose_kind(const Uniform& uniform, const topography::Measurement& measurement,
                                   const DiagnosisOptions& options) {
    return diagnosed(evidence_of(uniform, options.threads), measurement, options);
}

/// Heights of a polyline at equal steps, with the same number of points.
topography::LineScan at_equal_steps(const Profile& profile) {
    const Index n = profile.positions.size();
    const double step = profile.size() / static_cast<double>(n - 1);
    topography::LineScan scan{Array1D(n), step * static_cast<double>(n), false, profile.metadata};
    Index segment = 0;
    for (Index i = 0; i < n; ++i) {
        const double x = profile.positions[0] + step * static_cast<double>(i);
        while (segment + 2 < n && profile.positions[segment + 1] < x) ++segment;
        const double t =
            (x - profile.positions[segment]) / (profile.positions[segment + 1] - profile.positions[segment]);
        scan.heights[i] = (1.0 - t) * profile.heights[segment] + t * profile.heights[segment + 1];
    }
    return scan;
}

/// Polylines: re-entrant parts are reported and left out; all tests of lines follow if points have equal steps,
/// otherwise only those of form.
std::vector<Finding> diagnose_kind(const Profile& profile, const topography::Measurement&,
                                   const DiagnosisOptions& options) {
    std::vector<Finding> findings;
    Profile function = profile;
    if (((profile.positions.tail(profile.positions.size() - 1) -
          profile.positions.head(profile.positions.size() - 1)) <= 0.0)
            .any() ||
        profile.heights.isNaN().any()) {
        auto cleaned = topography::clean_contour(profile);
        if (cleaned.reentrant_share > 0.0)
            findings.push_back(
                {{"REENTRANT", topography::label(profile.metadata),
                  fmt::format(
                      "{:.2g} % of the length of the curve lies on stretches that turn back, which no function h(x) "
                      "can describe; these stretches are left out",
                      100.0 * cleaned.reentrant_share),
                  "look at the curve; if the share exceeds a few per cent, slope and curvature are lower bounds"},
                 {effect("reentrant_share", "", cleaned.reentrant_share, "1"),
                  effect_count("reentrant_points", cleaned.reentrant_points)}});
        function = std::move(cleaned.profile);
    }
    if (const auto scan = topography::to_line_scan(function)) {
        add(findings, diagnosed(evidence_of(*scan, options.threads), *scan, options));
        return findings;
    }
    auto evidence = evidence_of(at_equal_steps(function), options.threads);
    if (!evidence.flat) {
        evidence.form = form_of(evidence, options.threads);
        add(findings, large_tilt(evidence));
        add(findings, curvature_left(evidence));
        add(findings, tip_cutoff(function, options.threads));
        clean(evidence, options.threads);
        add(findings, low_wavevector_gap(evidence, options));
    }
    return findings;
}

}  // namespace

void check(const DiagnosisOptions& options) {
    if (!(options.false_alarm > 0.0 && options.false_alarm < 0.5))
        throw InvalidArgument(
            fmt::format("false_alarm {}; expected a probability above 0 and below 0.5", options.false_alarm));
}

std::vector<Finding> diagnose(const topography::Measurement& measurement, const DiagnosisOptions& options) {
    check(options);
    // a re-entrant polyline is a reported problem, no error
    if (!std::holds_alternative<Profile>(measurement)) topography::validate(measurement);
    return std::visit([&](const auto& kind) { return diagnose_kind(kind, measurement, options); }, measurement);
}

}  // namespace setae::diagnostics
