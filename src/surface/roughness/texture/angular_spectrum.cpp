// SPDX-License-Identifier: GPL-3.0-or-later
#include "angular_spectrum.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "setae/core/constants.hpp"
#include "setae/fourier/map_transform.hpp"
#include "setae/spectra/window.hpp"

namespace setae::texture {
namespace {

constexpr int sectors = 180;
constexpr int reach = 20;  ///< of the weight cos² about a direction, in sectors

/// Power by direction, with the sum of power times exp(2iθ), whose phase is twice the mean direction.
struct Sectors {
    std::array<double, sectors> power{};
    std::array<std::complex<double>, sectors> doubled{};
};

/// Power about a direction.
struct Around {
    double power = 0.0;
    std::complex<double> doubled = 0.0;
};

int wrapped(int sector) { return (sector % sectors + sectors) % sectors; }

}  // namespace

StrongestDirection strongest_direction(const topography::HeightMap& map, double mean, parallel::Threads threads) {
    const auto nx = map.heights.rows(), ny = map.heights.cols();
    const auto window = spectra::resolved(spectra::Window::automatic, map.periodic);
    const Array1D window_x = spectra::window_values(window, nx), window_y = spectra::window_values(window, ny);
    const double step_x = 2.0 * pi / map.size[0], step_y = 2.0 * pi / map.size[1];
    const double longest = pi / std::max(map.pixel_size()[0], map.pixel_size()[1]);
    std::vector<Sectors> blocks(static_cast<std::size_t>(fourier::block_count(ny / 2 + 1)));
    const auto load = [&](Index i, double* row) {
        for (Index j = 0; j < ny; ++j) {
            const double h = map.heights(i, j);
            row[j] = std::isnan(h) ? 0.0 : (h - mean) * window_x[i] * window_y[j];
        }
    };
    fourier::transform_map(
        nx, ny, load,
        [&](const fourier::SpectrumBlock& block) {
            auto& sums = blocks[static_cast<std::size_t>(block.index)];
            for (Index line = 0; line < block.lines; ++line) {
                const auto m = block.first + line;
                const double weight = m == 0 || 2 * m == ny ? 1.0 : 2.0, q_y = step_y * static_cast<double>(m);
                for (Index k = 0; k < nx; ++k) {
                    const double q_x = step_x * static_cast<double>(2 * k > nx ? k - nx : k);
                    const double q2 = q_x * q_x + q_y * q_y;
                    if ((m == 0 && k == 0) || q2 > longest * longest) continue;
                    const double power = weight * std::norm(block.line(line)[k]);
                    const double angle = std::atan2(q_y, q_x);
                    const auto sector =
                        static_cast<std::size_t>(wrapped(static_cast<int>(std::lround(angle * sectors / pi))));
                    sums.power[sector] += power;
                    sums.doubled[sector] += power / q2 * std::complex<double>(q_x * q_x - q_y * q_y, 2.0 * q_x * q_y);
                }
            }
        },
        threads);
    Sectors all;
    double total = 0.0;
    for (const auto& block : blocks)
        for (std::size_t s = 0; s < sectors; ++s) {
            all.power[s] += block.power[s];
            all.doubled[s] += block.doubled[s];
            total += block.power[s];
        }
    if (!(total > 0.0)) return {};
    const auto around = [&all](double direction) {
        Around sums;
        const int middle = static_cast<int>(std::lround(direction * sectors / pi));
        for (int k = middle - reach; k <= middle + reach; ++k) {
            const double cosine = std::cos(0.5 * pi * std::min(1.0, std::abs(k - direction * sectors / pi) / reach));
            const auto sector = static_cast<std::size_t>(wrapped(k));
            sums.power += cosine * cosine * all.power[sector];
            sums.doubled += cosine * cosine * all.doubled[sector];
        }
        return sums;
    };
    double angle = 0.0, largest = -1.0;
    for (int s = 0; s < sectors; ++s)
        if (const double power = around(s * pi / sectors).power; power > largest * (1.0 + 1e-12)) {
            largest = power;
            angle = s * pi / sectors;
        }
    for (int step = 0; step < 20; ++step) angle = 0.5 * std::arg(around(angle).doubled);
    if (angle < 0.0) angle += pi;
    return {angle, largest / total * sectors / reach};
}

}  // namespace setae::texture
