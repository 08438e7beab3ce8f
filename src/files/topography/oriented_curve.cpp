// SPDX-License-Identifier: GPL-3.0-or-later
#include "oriented_curve.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "mean_line.hpp"
#include "setae/core/errors.hpp"

namespace setae::topography {
namespace {

void require_sizes(const TracedCurve& traced) {
    const auto n = traced.x.size();
    if (traced.y.size() != n || (traced.standard_error.size() != 0 && traced.standard_error.size() != n))
        throw InvalidArgument(
            fmt::format("{}: traced curve of {} x, {} y and {} standard errors; expected one of each per point, or no "
                        "errors",
                        label(traced.metadata), n, traced.y.size(), traced.standard_error.size()));
}

/// Points from the leftmost to the rightmost, the higher one of several.
std::vector<Index> over_the_top(const TracedCurve& traced, const std::vector<Index>& outline) {
    const auto before = [&](double sign) {
        return [&traced, sign](Index i, Index j) {
            return traced.x[i] != traced.x[j] ? sign * traced.x[i] < sign * traced.x[j] : traced.y[i] > traced.y[j];
        };
    };
    const auto leftmost = std::min_element(outline.begin(), outline.end(), before(1.0));
    const auto rightmost = std::min_element(outline.begin(), outline.end(), before(-1.0));
    std::vector<Index> part;
    for (auto i = leftmost;; i = i + 1 == outline.end() ? outline.begin() : i + 1) {
        part.push_back(*i);
        if (i == rightmost) return part;
    }
}

}  // namespace

std::vector<Index> distinct_points(const TracedCurve& traced) {
    require_sizes(traced);
    std::vector<Index> kept;
    const auto same = [&](Index i, Index j) { return traced.x[i] == traced.x[j] && traced.y[i] == traced.y[j]; };
    for (Index i = 0; i < traced.x.size(); ++i)
        if (std::isfinite(traced.x[i]) && std::isfinite(traced.y[i]) && (kept.empty() || !same(i, kept.back())))
            kept.push_back(i);
    while (traced.closed && kept.size() > 1 && same(kept.front(), kept.back())) kept.pop_back();
    if (kept.size() < 2)
        throw UndefinedDataError(
            fmt::format("{}: {} of {} points of the traced curve are defined and distinct, expected at least 2",
                        label(traced.metadata), kept.size(), traced.x.size()));
    return kept;
}

OrientedCurve OrientedCurve::points(const std::vector<Index>& chosen) const {
    OrientedCurve part{x(chosen), y(chosen), along(chosen), {}};
    if (standard_error.size() > 0) part.standard_error = standard_error(chosen);
    return part;
}

double OrientedCurve::x_at(double length) const {
    const auto above = std::upper_bound(along.begin(), along.end(), length);
    const Index i = std::clamp<Index>(above - along.begin() - 1, 0, x.size() - 2);
    return x[i] + (x[i + 1] - x[i]) * ((length - along[i]) / (along[i + 1] - along[i]));
}

Array1D OrientedCurve::height_error() const {
    constexpr Index neighbours = 2;
    constexpr double min_cosine = 0.1;
    if (standard_error.size() == 0) return {};
    const Index last = x.size() - 1;
    return Array1D::NullaryExpr(x.size(), [&](Index i) {
        const Index from = std::max<Index>(0, i - neighbours), to = std::min(last, i + neighbours);
        const double cosine = (x[to] - x[from]) / std::hypot(x[to] - x[from], y[to] - y[from]);
        return standard_error[i] / std::max(min_cosine, cosine);
    });
}

Orientation oriented_curve(const TracedCurve& traced) {
    auto kept = distinct_points(traced);
    if (traced.closed) kept = over_the_top(traced, kept);
    if (kept.size() < 2)
        throw UndefinedDataError(
            fmt::format("{}: the closed outline has no width; expected points at different x", label(traced.metadata)));
    const Array1D x = traced.x(kept), y = traced.y(kept);
    const auto line = mean_line(x, y);
    const double angle = traced.closed ? 0.0 : line.angle, c = std::cos(angle), s = std::sin(angle);
    Orientation result;
    result.rotation = -angle;
    auto& curve = result.curve;
    curve.x = (x - line.centre[0]) * c + (y - line.centre[1]) * s;
    curve.y = (y - line.centre[1]) * c - (x - line.centre[0]) * s;
    curve.along = lengths_along(x, y);
    if (traced.standard_error.size() > 0) curve.standard_error = traced.standard_error(kept);
    return result;
}

Alert closed_outline_alert(const TracedCurve& traced, double length) {
    const auto n = traced.x.size();
    const double closing = std::hypot(traced.x[n - 1] - traced.x[0], traced.y[n - 1] - traced.y[0]);
    const double whole = lengths_along(traced.x, traced.y)[n - 1] + closing;
    return {"CLOSED_OUTLINE", label(traced.metadata),
            fmt::format("the outline is closed: it was not rotated, and {:.0f} % of its length, from the leftmost to "
                        "the rightmost point, was used",
                        100.0 * length / whole),
            "for a spectrum, trace a straight part of the surface; for the whole outline, use the "
            "parametric statistics"};
}

}  // namespace setae::topography
