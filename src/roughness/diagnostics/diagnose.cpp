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

std::vector<Finding> as_list(Found finding) {
    std::vector<Finding> findings;
    add(findings, std::move(finding));
    return findings;
}

std::vector<Finding> diagnosed(const Evidence& evidence, const topography::Measurement& measurement,
                               const DiagnosisOptions& options) {
    std::vector<Finding> findings;
    add(findings, undefined_heights(evidence));
    add(findings, quantised(evidence, options.threads));
    if (evidence.flat) return findings;
    // in the order of the page of diagnostics; each looks at the same evidence by itself
    const std::vector<std::function<std::vector<Finding>()>> tests{
        [&] { return clipped(evidence, options.threads); },
        [&] { return as_list(large_tilt(evidence)); },
        [&] { return as_list(curvature_left(evidence, options.threads)); },
        [&] { return as_list(spikes(evidence, options.threads)); },
        [&] { return as_list(scars(evidence)); },
        [&] { return as_list(pixel_noise(evidence, options)); },
        [&] { return as_list(tip_cutoff(measurement, options.threads)); },
        [&] { return as_list(low_wavevector_gap(evidence, options)); },
        [&] { return directions(evidence, options); }};
    std::vector<std::vector<Finding>> found(tests.size());
    parallel::for_each_index(tests.size(), options.threads, [&](std::size_t i) { found[i] = tests[i](); });
    for (auto& more : found) add(findings, std::move(more));
    return findings;
}

std::vector<Finding> diagnose_kind(const topography::HeightMap& map, const DiagnosisOptions& options) {
    return diagnosed(evidence_of(map, options.threads), map, options);
}

std::vector<Finding> diagnose_kind(const topography::LineScan& scan, const DiagnosisOptions& options) {
    return diagnosed(evidence_of(scan, options.threads), scan, options);
}

/// Heights of a polyline at equal steps, as many as it has points.
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

/// Polylines: what turns back is found and left out; where points lie at equal steps all tests of lines follow, else
/// those of form.
std::vector<Finding> diagnose_kind(const Profile& profile, const DiagnosisOptions& options) {
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
                      "{:.2g} % of the curve's length lies on stretches that turn back, which no function of x shows; they are left out",
                      100.0 * cleaned.reentrant_share),
                  "look at the curve; a share above a few per cent makes slope and curvature lower bounds"},
                 {effect("reentrant_share", "", cleaned.reentrant_share, "1"),
                  effect_count("reentrant_points", cleaned.reentrant_points)}});
        function = std::move(cleaned.profile);
    }
    if (const auto scan = topography::to_line_scan(function)) {
        add(findings, diagnosed(evidence_of(*scan, options.threads), *scan, options));
        return findings;
    }
    const auto evidence = evidence_of(at_equal_steps(function), options.threads);
    if (!evidence.flat) {
        add(findings, large_tilt(evidence));
        add(findings, curvature_left(evidence, options.threads));
        add(findings, tip_cutoff(function, options.threads));
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
    // a polyline that turns back is a finding, no error
    if (!std::holds_alternative<Profile>(measurement)) topography::validate(measurement);
    return std::visit([&](const auto& kind) { return diagnose_kind(kind, options); }, measurement);
}

}  // namespace setae::diagnostics
