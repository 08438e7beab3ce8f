// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/measurement.hpp"

#include <cmath>
#include <type_traits>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::topography {

const Metadata& metadata(const Measurement& measurement) {
    return std::visit([](const auto& m) -> const Metadata& { return m.metadata; }, measurement);
}

Metadata& metadata(Measurement& measurement) {
    return std::visit([](auto& m) -> Metadata& { return m.metadata; }, measurement);
}

std::array<Index, 2> shape(const Measurement& measurement) {
    return std::visit(
        [](const auto& m) -> std::array<Index, 2> {
            return {m.heights.rows(), m.heights.cols()};
        },
        measurement);
}

Array1D all_heights(const Measurement& measurement) {
    return std::visit(
        [](const auto& m) -> Array1D { return Eigen::Map<const Array1D>(m.heights.data(), m.heights.size()); },
        measurement);
}

Measurement scaled(Measurement measurement, double factor) {
    std::visit([factor](auto& m) { m.heights *= factor; }, measurement);
    if (auto* profile = std::get_if<Profile>(&measurement)) {
        profile->standard_error *= std::abs(factor);
        if (profile->response) profile->response->noise_density *= factor * factor;
    }
    return measurement;
}

std::string label(const Metadata& metadata) {
    if (metadata.file.empty()) return metadata.name.empty() ? "measurement" : metadata.name;
    return metadata.name.empty() ? metadata.file : fmt::format("{} ({})", metadata.file, metadata.name);
}

namespace {

void require_extent(double size, Index points, const char* direction, const Metadata& metadata) {
    if (points < 2)
        throw InvalidArgument(
            fmt::format("{}: {} points along {}, expected at least 2", label(metadata), points, direction));
    if (!(size > 0.0) || !std::isfinite(size))
        throw InvalidArgument(
            fmt::format("{}: size along {} is {} m, expected a positive length", label(metadata), direction, size));
}

template <class Heights>
void require_heights(const Heights& heights, const Metadata& metadata) {
    if ((heights - heights).sum() == 0.0) return;  // all are finite
    if (heights.isInf().any())
        throw InvalidArgument(fmt::format("{}: a height is infinite; write undefined heights as NaN", label(metadata)));
    if (heights.isNaN().all())
        throw UndefinedDataError(fmt::format("{}: all {} heights are undefined", label(metadata), heights.size()));
}

void check(const HeightMap& map) {
    require_extent(map.size[0], map.heights.rows(), "x", map.metadata);
    require_extent(map.size[1], map.heights.cols(), "y", map.metadata);
    require_heights(map.heights, map.metadata);
}

void check(const LineScan& scan) {
    require_extent(scan.size, scan.heights.size(), "x", scan.metadata);
    require_heights(scan.heights, scan.metadata);
}

void check(const TraceResponse& response, const Metadata& metadata) {
    const auto require = [&](double value, const char* what, bool positive) {
        if (!std::isfinite(value) || value < 0.0 || (positive && value == 0.0))
            throw InvalidArgument(fmt::format("{}: {} of the trace is {} in SI units; expected {}", label(metadata),
                                              what, value, positive ? "> 0" : ">= 0"));
    };
    require(response.blur, "blur", false);
    require(response.smoothing_length, "smoothing length", false);
    require(response.step, "step", true);
    require(response.noise_density, "noise density", false);
}

void check(const Profile& profile) {
    const auto& x = profile.positions;
    if (x.size() != profile.heights.size())
        throw InvalidArgument(fmt::format("{}: {} positions for {} heights; expected as many of both",
                                          label(profile.metadata), x.size(), profile.heights.size()));
    require_extent(x.size() > 1 ? profile.size() : 0.0, x.size(), "x", profile.metadata);
    for (Index i = 1; i < x.size(); ++i)
        if (!(x[i] > x[i - 1]))
            throw InvalidArgument(
                fmt::format("{}: x does not increase at point {} ({} m after {} m); clean the contour first",
                            label(profile.metadata), i, x[i], x[i - 1]));
    require_heights(profile.heights, profile.metadata);
    const auto& error = profile.standard_error;
    if (error.size() != 0 && error.size() != x.size())
        throw InvalidArgument(fmt::format("{}: {} standard errors for {} heights; expected one per height",
                                          label(profile.metadata), error.size(), x.size()));
    for (Index i = 0; i < error.size(); ++i)
        if (!(error[i] >= 0.0) || !std::isfinite(error[i]))
            throw InvalidArgument(fmt::format("{}: standard error of point {} is {} m; expected >= 0",
                                              label(profile.metadata), i, error[i]));
    if (profile.response) check(*profile.response, profile.metadata);
}

}  // namespace

void validate(const Measurement& measurement) {
    std::visit([](const auto& m) { check(m); }, measurement);
}

}  // namespace setae::topography
