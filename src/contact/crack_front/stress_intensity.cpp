// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/crack_front/stress_intensity.hpp"

#include <cmath>

#include <fmt/format.h>

#include "map_modes.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/fourier/fast_length.hpp"
#include "setae/fourier/inverse_map_transform.hpp"

namespace setae::crack_front {
namespace {

void require_rays(Index angles, const LinePoints& radii, double shortest) {
    if (angles < 2 || angles % 2 != 0 || radii.count < 2 || !(radii.spacing > 0.0 && radii.first >= 0.0))
        throw InvalidArgument(
            fmt::format("{} rays with {} radii from {} m on, {} m apart; expected an even number of rays and 2 or more "
                        "radii that increase",
                        angles, radii.count, radii.first, radii.spacing));
    if (!(radii.spacing <= 0.25 * shortest))
        throw InvalidArgument(fmt::format("radii {} m apart are too coarse for waves of {} m; expected at most {} m",
                                          radii.spacing, shortest, 0.25 * shortest));
    const double apart = 2.0 * pi * radii.last() / static_cast<double>(angles);
    if (!(apart <= 0.5 * shortest))
        throw InvalidArgument(
            fmt::format("{} rays are {} m apart at {} m, too coarse for waves of {} m; expected {} rays or more",
                        angles, apart, radii.last(), shortest, std::ceil(4.0 * pi * radii.last() / shortest)));
}

Array2D sums_on_rays(const MapModes& modes, RaySums::Factor factor, Index angles, const LinePoints& radii,
                     parallel::Threads threads) {
    const RaySums sums(modes, factor, radii);
    Array2D values(angles, radii.count);
    parallel::for_each_index(static_cast<std::size_t>(angles / 2), threads, [&](std::size_t i) {
        const auto j = static_cast<Index>(i);
        sums.along(2.0 * pi * static_cast<double>(j) / static_cast<double>(angles), values.row(j).data(),
                   values.row(j + angles / 2).data());
    });
    return values;
}

StressIntensity of_modes(const MapModes& modes, const MapOnFront& options, const LinePoints& points) {
    const auto energy = energy_of(modes, options.contact_modulus);
    return {.values = {},
            .points = points,
            .stored_energy = energy.stored_energy,
            .mean_wavelength = energy.mean_wavelength,
            .contact_modulus = options.contact_modulus,
            .shortest_wavelength = options.shortest_wavelength};
}

}  // namespace

StressIntensity stress_intensity_on_rays(const topography::HeightMap& map, const MapOnFront& options, Index angles,
                                         const LinePoints& radii, parallel::Threads threads) {
    require_rays(angles, radii, options.shortest_wavelength);
    const auto modes = modes_of(map, options, radii.last(), threads);
    auto found = of_modes(modes, options, radii);
    found.values = sums_on_rays(modes, RaySums::Factor::front, angles, radii, threads);
    found.values *= -options.contact_modulus / std::sqrt(2.0);
    return found;
}

StressIntensity stress_intensity_on_parallels(const topography::HeightMap& map, const MapOnFront& options,
                                              parallel::Threads threads) {
    if (!map.periodic) throw InvalidArgument("a straight front travels around an endless map; expected a periodic map");
    const Index nx = map.heights.rows(), ny = map.heights.cols();
    const auto modes = modes_of(map, {options.contact_modulus, options.shortest_wavelength, {}}, 0.0, threads);
    auto found = of_modes(modes, options, {nx, 0.0, map.size[0] / static_cast<double>(nx)});
    Eigen::ArrayXXcd spectrum = Eigen::ArrayXXcd::Zero(nx, ny / 2 + 1);
    const double step_x = 2.0 * pi / map.size[0], step_y = 2.0 * pi / map.size[1];
    for (std::size_t i = 0; i < modes.count(); ++i) {
        const auto k = static_cast<Index>(std::llround(modes.qx[i] / step_x));
        const auto m = static_cast<Index>(std::llround(modes.qy[i] / step_y));
        const std::complex<double> split(std::abs(modes.qy[i]), modes.qx[i]);
        const auto value = -options.contact_modulus / std::sqrt(2.0) * std::sqrt(split) *
                           std::complex<double>(modes.real[i], modes.imaginary[i]);
        spectrum(k < 0 ? k + nx : k, m) = value;
        if (m == 0) spectrum(nx - k, 0) = std::conj(value);
    }
    Array2D values(nx, ny);
    fourier::inverse_transform_map(
        [&](Index m, fourier::Complex* line) { std::copy_n(spectrum.col(m).data(), nx, line); }, values, threads);
    found.values = values.transpose();
    return found;
}

WorkField works_on_rays(const topography::HeightMap& map, const MapOnFront& options, Index angles,
                        const LinePoints& radii, parallel::Threads threads) {
    if (!map.periodic) throw InvalidArgument("works on rays are computed from waves; expected a periodic map");
    require_rays(angles, radii, options.shortest_wavelength);
    const auto modes = modes_of(map, {1.0, options.shortest_wavelength, options.centre}, radii.last(), threads);
    WorkField field{.works = sums_on_rays(modes, RaySums::Factor::none, angles, radii, threads) + modes.mean,
                    .points = radii,
                    .mean_work = modes.mean};
    require(field);
    return field;
}

RayGrid ray_grid(double largest_radius, double shortest_wavelength) {
    if (!(largest_radius > 0.0 && shortest_wavelength > 0.0))
        throw InvalidArgument(
            fmt::format("rays of {} m for waves of {} m; expected both above 0", largest_radius, shortest_wavelength));
    const double spacing = shortest_wavelength / 16.0;
    const LinePoints radii{static_cast<Index>(std::ceil(largest_radius / spacing)) + 1, 0.0, spacing};
    const auto half = static_cast<Index>(std::ceil(8.0 * pi * radii.last() / shortest_wavelength));
    return {.angles = 2 * fourier::fast_length(half), .radii = radii};
}

}  // namespace setae::crack_front
