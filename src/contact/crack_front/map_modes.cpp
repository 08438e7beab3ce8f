// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_modes.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/fourier/map_transform.hpp"

namespace setae::crack_front {
namespace {

double folded(Index k, Index n) { return static_cast<double>(k > n / 2 ? k - n : k); }

/// 1 up to the radius, then half a cosine to 0 at the edge.
double fade(double distance, double radius, double edge) {
    if (distance <= radius) return 1.0;
    if (distance >= edge) return 0.0;
    return 0.5 * (1.0 + std::cos(pi * (distance - radius) / (edge - radius)));
}

double distance_to_edge(const topography::HeightMap& map, const std::array<double, 2>& centre) {
    const auto pixel = map.pixel_size();
    return std::min({centre[0], centre[1], map.size[0] - pixel[0] - centre[0], map.size[1] - pixel[1] - centre[1]});
}

double distance_from(const topography::HeightMap& map, const std::array<double, 2>& centre, Index i, Index j) {
    const auto pixel = map.pixel_size();
    return std::hypot(static_cast<double>(i) * pixel[0] - centre[0], static_cast<double>(j) * pixel[1] - centre[1]);
}

double mean_inside(const topography::HeightMap& map, const std::array<double, 2>& centre, double radius) {
    double sum = 0.0;
    Index n = 0;
    for (Index i = 0; i < map.heights.rows(); ++i)
        for (Index j = 0; j < map.heights.cols(); ++j)
            if (distance_from(map, centre, i, j) <= radius) {
                sum += map.heights(i, j);
                ++n;
            }
    return n > 0 ? sum / static_cast<double>(n) : 0.0;
}

double mean_square_fade(const topography::HeightMap& map, const std::array<double, 2>& centre, double radius,
                        double edge) {
    double sum = 0.0;
    for (Index i = 0; i < map.heights.rows(); ++i)
        for (Index j = 0; j < map.heights.cols(); ++j)
            sum += std::pow(fade(distance_from(map, centre, i, j), radius, edge), 2);
    return sum / static_cast<double>(map.heights.size());
}

void check(const topography::HeightMap& map, const MapOnFront& options, double largest_radius) {
    topography::validate(map);
    if (const Index undefined = map.heights.isNaN().count(); undefined > 0)
        throw UndefinedDataError(fmt::format("{}: {} of {} heights are undefined; fill them first",
                                             topography::label(map.metadata), undefined, map.heights.size()));
    if (!(options.contact_modulus > 0.0))
        throw InvalidArgument(fmt::format("contact modulus {} Pa; expected more than 0", options.contact_modulus));
    const auto pixel = map.pixel_size();
    const double shortest = 2.0 * std::max(pixel[0], pixel[1]);
    if (!(options.shortest_wavelength >= shortest))
        throw InvalidArgument(fmt::format("a shortest wavelength of {} m on pixels of {} m; expected {} m or more",
                                          options.shortest_wavelength, 0.5 * shortest, shortest));
    if (map.periodic) return;
    if (const double edge = distance_to_edge(map, options.centre); !(largest_radius <= 0.9 * edge))
        throw InvalidArgument(
            fmt::format("a front up to {} m in a map that ends {} m from its centre; expected at most {} m, or a "
                        "periodic map",
                        largest_radius, edge, 0.9 * edge));
}

}  // namespace

MapModes modes_of(const topography::HeightMap& map, const MapOnFront& options, double largest_radius,
                  parallel::Threads threads) {
    check(map, options, largest_radius);
    const Index nx = map.heights.rows(), ny = map.heights.cols();
    const double edge = map.periodic ? 0.0 : distance_to_edge(map, options.centre);
    const double mean = map.periodic ? 0.0 : mean_inside(map, options.centre, largest_radius);
    const double points = static_cast<double>(nx) * static_cast<double>(ny);
    const double step_x = 2.0 * pi / map.size[0], step_y = 2.0 * pi / map.size[1];
    const double largest = 2.0 * pi / options.shortest_wavelength;
    std::vector<MapModes> blocks(static_cast<std::size_t>(fourier::block_count(ny / 2 + 1)));
    double sum = 0.0;
    const auto load = [&](Index i, double* line) {
        for (Index j = 0; j < ny; ++j) {
            line[j] = map.heights(i, j) - mean;
            if (!map.periodic) line[j] *= fade(distance_from(map, options.centre, i, j), largest_radius, edge);
        }
    };
    const auto consume = [&](const fourier::SpectrumBlock& block) {
        auto& kept = blocks[static_cast<std::size_t>(block.index)];
        for (Index l = 0; l < block.lines; ++l) {
            const Index m = block.first + l;
            if (2 * m == ny) continue;
            const double qy = step_y * static_cast<double>(m);
            if (qy > largest) continue;
            for (Index k = 0; k < nx; ++k) {
                if (m == 0 && k == 0) sum = block.line(l)[0].real();
                if (2 * k == nx || (m == 0 && 2 * k >= nx) || (m == 0 && k == 0)) continue;
                const double qx = step_x * folded(k, nx);
                if (qx * qx + qy * qy > largest * largest) continue;
                const auto value =
                    block.line(l)[k] / points * std::polar(1.0, qx * options.centre[0] + qy * options.centre[1]);
                kept.qx.push_back(qx);
                kept.qy.push_back(qy);
                kept.real.push_back(value.real());
                kept.imaginary.push_back(value.imag());
            }
        }
    };
    fourier::transform_map(nx, ny, load, consume, threads);
    MapModes modes;
    modes.mean = mean + sum / points;
    if (!map.periodic) modes.seen = mean_square_fade(map, options.centre, largest_radius, edge);
    const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    for (const auto& block : blocks) {
        append(modes.qx, block.qx);
        append(modes.qy, block.qy);
        append(modes.real, block.real);
        append(modes.imaginary, block.imaginary);
    }
    return modes;
}

ModeEnergy energy_of(const MapModes& modes, double contact_modulus) {
    double variance = 0.0, stored = 0.0;
    for (std::size_t m = 0; m < modes.count(); ++m) {
        const double power = 2.0 * (modes.real[m] * modes.real[m] + modes.imaginary[m] * modes.imaginary[m]);
        variance += power;
        stored += std::hypot(modes.qx[m], modes.qy[m]) * power;
    }
    return {.stored_energy = 0.25 * contact_modulus * stored / modes.seen,
            .mean_wavelength = stored > 0.0 ? 2.0 * pi * variance / stored : 0.0};
}

}  // namespace setae::crack_front
