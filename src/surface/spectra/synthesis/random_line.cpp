// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/summation.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/transform.hpp"
#include "setae/numerics/random_blocks.hpp"
#include "setae/synthesis/amplitude_table.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "setae/synthesis/rms_height.hpp"

namespace setae::synthesis {
namespace {

void check(const LineGrid& grid) {
    if (grid.points < 2 || !(grid.size > 0.0) || !std::isfinite(grid.size))
        throw InvalidArgument(fmt::format(
            "a line of {} points over {} m; expected at least 2 points and a positive size", grid.points, grid.size));
}

/// √(C1D/L) of the modes 0 … n/2, zero for the mean.
Array1D amplitudes(const spectra::SpectralDensity& C1D, const LineGrid& grid) {
    check(grid);
    const Index modes = grid.points / 2;
    const double unit = 2.0 * pi / grid.size, highest = unit * static_cast<double>(modes);
    const AmplitudeTable table(C1D, unit * unit * (1.0 - 1e-9), highest * highest * (1.0 + 1e-9));
    Array1D result = Array1D::Zero(modes + 1);
    for (Index k = 1; k < result.size(); ++k) {
        const double q = unit * static_cast<double>(k);
        result[k] = table(q * q) / std::sqrt(grid.size);
    }
    return result;
}

}  // namespace

topography::LineScan random_line(const spectra::SpectralDensity& C1D, const LineGrid& grid,
                                 const SurfaceOptions& options) {
    if (options.anisotropy.stretch != 1.0)
        throw InvalidArgument(
            fmt::format("a line of a surface stretched by a factor {}; expected no stretch: give the spectrum of the "
                        "line itself",
                        options.anisotropy.stretch));
    if (options.exact_rms_height) require_rms_height(*options.exact_rms_height);
    const Array1D amplitude = amplitudes(C1D, grid);
    const fourier::InverseRealTransform transform(grid.points);
    fourier::Buffer<fourier::Complex> modes(static_cast<std::size_t>(amplitude.size()));
    std::vector<std::uint64_t> blocks(modes.size());
    for (std::size_t k = 0; k < blocks.size(); ++k) blocks[k] = k;
    const bool gaussian = options.amplitudes == Amplitudes::gaussian;
    (gaussian ? numerics::complex_normals : numerics::unit_phases)(options.key, blocks.data(), modes.data(),
                                                                   amplitude.size());
    for (std::size_t k = 0; k < modes.size(); ++k)
        modes[k] *= amplitude[static_cast<Index>(k)] * (gaussian ? std::sqrt(0.5) : 1.0);
    // the highest mode of an even number of points is real
    if (grid.points % 2 == 0)
        modes.back() = gaussian ? std::sqrt(2.0) * modes.back().real()
                                : std::copysign(amplitude[amplitude.size() - 1], modes.back().real());
    fourier::Buffer<double> heights(static_cast<std::size_t>(grid.points));
    transform.apply(modes.data(), heights.data());
    topography::LineScan scan{
        .heights = Eigen::Map<const Array1D>(heights.data(), grid.points), .size = grid.size, .periodic = true};
    if (options.exact_rms_height)
        scan.heights *= scale_to(*options.exact_rms_height,
                                 std::sqrt(pairwise_sum(scan.heights.square()) / static_cast<double>(grid.points)));
    return scan;
}

ExpectedRoughness expected_roughness(const spectra::SpectralDensity& C1D, const LineGrid& grid) {
    const Array1D amplitude = amplitudes(C1D, grid);
    Array1D height = 2.0 * amplitude.square();
    if (grid.points % 2 == 0) height[height.size() - 1] *= 0.5;
    const Array1D q =
        Array1D::LinSpaced(height.size(), 0.0, static_cast<double>(height.size() - 1)) * (2.0 * pi / grid.size);
    return {std::sqrt(pairwise_sum(height)), std::sqrt(pairwise_sum(height * q.square()))};
}

}  // namespace setae::synthesis
