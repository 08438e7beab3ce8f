// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/scales/half_derivative.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/isotropic.hpp"
#include "setae/spectra/power_spectrum.hpp"

namespace setae::scales {
namespace {

spectra::SpectrumOptions options_of(bool periodic, spectra::Window window, parallel::Threads threads) {
    spectra::SpectrumOptions options;
    options.window = window;
    options.trend = periodic ? topography::Trend::mean : topography::Trend::tilt;
    options.threads = threads;
    return options;
}

/// ∫ A/r² dr between two nodes of a power law A ∝ r^p.
double between(double r0, double A0, double r1, double A1) {
    if (!(A0 > 0.0) || !(A1 > 0.0)) return 0.5 * (A0 / (r0 * r0) + A1 / (r1 * r1)) * (r1 - r0);
    const double steps = std::log(r1 / r0), growth = std::log(A1 / A0) - steps;  // of A/r
    const double share = std::abs(growth) < 1e-8 ? 1.0 + 0.5 * growth : std::expm1(growth) / growth;
    return A0 / r0 * steps * share;
}

HalfDerivative of_lines(double grating, SurfaceKind kind) {
    if (kind == SurfaceKind::grating) return {grating, "grating", {}};
    return {0.5 * pi * grating, "isotropic", {}};
}

}  // namespace

HalfDerivative half_derivative_variance(const topography::HeightMap& map, spectra::Window window,
                                        parallel::Threads threads) {
    const Array2D C2D = spectra::power_spectrum_map(map, options_of(map.periodic, window, threads));
    const Index nx = C2D.rows(), ny = C2D.cols();
    const auto wavevector = [](Index k, Index n, double size) {
        return 2.0 * pi * static_cast<double>(k <= n / 2 ? k : k - n) / size;
    };
    Array1D qy(ny), rows(nx);
    for (Index m = 0; m < ny; ++m) qy[m] = wavevector(m, ny, map.size[1]);
    for (Index k = 0; k < nx; ++k) {
        const double qx = wavevector(k, nx, map.size[0]);
        rows[k] = ((qy.square() + qx * qx).sqrt() * C2D.row(k).transpose()).sum();
    }
    return {rows.sum() / (map.size[0] * map.size[1]), "none", {}};
}

HalfDerivative half_derivative_variance(const topography::LineScan& scan, SurfaceKind kind, spectra::Window window) {
    const auto spectrum = spectra::power_spectrum(scan, options_of(scan.periodic, window, {1}));
    double sum = 0.0;
    for (Index k = 0; k < spectrum.C1D.size(); ++k) {
        const bool stands_for_both_signs = 2 * (k + 1) == scan.heights.size();
        sum += (stands_for_both_signs ? 0.5 : 1.0) * spectrum.wavevector[k] * spectrum.C1D[k];
    }
    return of_lines(2.0 * sum / scan.size, kind);
}

HalfDerivative half_derivative_from_autocorrelation(const FunctionOfScale& autocorrelation, double rms_height,
                                                    SurfaceKind kind) {
    if (autocorrelation.quantity != "autocorrelation" && autocorrelation.quantity != "autocorrelation_of_area")
        throw InvalidArgument(
            fmt::format("the half derivative follows from an autocorrelation; got {}", autocorrelation.quantity));
    const auto& r = autocorrelation.distance;
    const auto& A = autocorrelation.value;
    if (r.size() == 0) throw InvalidArgument("an autocorrelation without a distance; expected at least one");
    const Index last = r.size() - 1;
    double integral = A[0] / r[0] + rms_height * rms_height / r[last];
    for (Index k = 0; k < last; ++k) integral += between(r[k], A[k], r[k + 1], A[k + 1]);
    if (autocorrelation.quantity == "autocorrelation_of_area") return {integral, "none", {}};
    return of_lines(2.0 / pi * integral, kind);
}

}  // namespace setae::scales
