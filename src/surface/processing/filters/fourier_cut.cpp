// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/fourier_cut.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "grids/fourier_lines.hpp"
#include "setae/core/errors.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/inverse_map_transform.hpp"
#include "setae/fourier/map_transform.hpp"

namespace setae::processing {
namespace {

using topography::HeightMap;
using topography::LineScan;

constexpr double forgiven = 1e-9;

void require_valid(const FourierCut& band, const topography::Metadata& metadata) {
    const std::string name = topography::label(metadata);
    if (!band.shortest && !band.longest)
        throw InvalidArgument(
            fmt::format("{}: Fourier cut without a limit; expected the shortest wavelength to keep, the longest, or "
                        "both",
                        name));
    for (const auto& limit : {band.shortest, band.longest})
        if (limit && (!(*limit > 0.0) || !std::isfinite(*limit)))
            throw InvalidArgument(
                fmt::format("{}: Fourier cut at a wavelength of {} m; expected a positive one", name, *limit));
    if (band.shortest && band.longest && *band.shortest > *band.longest)
        throw InvalidArgument(
            fmt::format("{}: Fourier cut that keeps wavelengths from {} m but none above {} m; expected shortest below "
                        "longest",
                        name, *band.shortest, *band.longest));
}

/// Whether a mode of 1/wavelength squared is kept.
class Passband {
public:
    explicit Passband(const FourierCut& band) : band_(band) {}
    [[nodiscard]] bool holds(double inverse_squared) const {
        if (inverse_squared == 0.0) return true;
        if (band_.shortest && inverse_squared * *band_.shortest * *band_.shortest > 1.0 + 2.0 * forgiven) return false;
        return !(band_.longest && inverse_squared * *band_.longest * *band_.longest < 1.0 - 2.0 * forgiven);
    }

private:
    FourierCut band_;
};

double squared(double value) { return value * value; }

}  // namespace

HeightMap cut(HeightMap map, const FourierCut& band, parallel::Threads threads) {
    require_valid(band, map.metadata);
    require_periodic(map.periodic, !map.heights.isNaN().any(), "the Fourier cut", map.metadata);
    const Index nx = map.heights.rows(), ny = map.heights.cols();
    const Passband passband(band);
    Eigen::Array<fourier::Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> spectrum(ny / 2 + 1, nx);
    const double factor = 1.0 / (static_cast<double>(nx) * static_cast<double>(ny)), centre = map.heights(0, 0);
    fourier::transform_map(
        nx, ny,
        [&](Index i, double* line) {
            Eigen::Map<Eigen::Array<double, 1, Eigen::Dynamic>>(line, ny) = map.heights.row(i) - centre;
        },
        [&](const fourier::SpectrumBlock& block) {
            for (Index m = 0; m < block.lines; ++m) {
                const double along_y = squared(static_cast<double>(block.first + m) / map.size[1]);
                for (Index k = 0; k < nx; ++k) {
                    const double along_x = squared(static_cast<double>(std::min(k, nx - k)) / map.size[0]);
                    spectrum(block.first + m, k) =
                        passband.holds(along_x + along_y) ? factor * block.line(m)[k] : fourier::Complex(0.0);
                }
            }
        },
        threads);
    fourier::inverse_transform_map([&](Index m, fourier::Complex* modes) { std::copy_n(&spectrum(m, 0), nx, modes); },
                                   map.heights, threads);
    map.heights += centre;
    return map;
}

LineScan cut(LineScan scan, const FourierCut& band) {
    require_valid(band, scan.metadata);
    require_periodic(scan.periodic, !scan.heights.isNaN().any(), "the Fourier cut", scan.metadata);
    const Index n = scan.heights.size();
    const Passband passband(band);
    const fourier::RealTransform forward(n);
    fourier::Buffer<double> line(static_cast<std::size_t>(n));
    fourier::Buffer<fourier::Complex> modes(static_cast<std::size_t>(forward.modes()));
    const double centre = scan.heights[0];
    for (Index i = 0; i < n; ++i) line[static_cast<std::size_t>(i)] = scan.heights[i] - centre;
    forward.forward(line.data(), modes.data());
    for (Index k = 0; k < forward.modes(); ++k)
        modes[static_cast<std::size_t>(k)] *=
            passband.holds(squared(static_cast<double>(k) / scan.size)) ? 1.0 / static_cast<double>(n) : 0.0;
    fourier::InverseRealTransform(n).apply(modes.data(), line.data());
    for (Index i = 0; i < n; ++i) scan.heights[i] = centre + line[static_cast<std::size_t>(i)];
    return scan;
}

Processed apply(const FourierCut& step, topography::Measurement measurement, parallel::Threads threads) {
    StepRecord record{.step = std::string(step_name(step))};
    if (auto* map = std::get_if<HeightMap>(&measurement))
        return {cut(std::move(*map), step, threads), std::move(record)};
    if (auto* scan = std::get_if<LineScan>(&measurement)) return {cut(std::move(*scan), step), std::move(record)};
    const auto& profile = std::get<topography::Profile>(measurement);
    throw InvalidArgument(fmt::format(
        "{}: {} needs equally spaced periodic data, and this is a polyline of {} points; use a filter of ISO 16610 after step resample",
        topography::label(profile.metadata), step_name(step), profile.positions.size()));
}

}  // namespace setae::processing
