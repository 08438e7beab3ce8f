// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/stylus.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "instrument.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::simulation {
namespace {

constexpr int artefact_waves = 6;

void check(const DriveArtefact& artefact) {
    require_not_negative(artefact.rms, "rms height [m] of the drive's artefact");
    if (!(artefact.longest_wavelength > 0.0) || !std::isfinite(artefact.longest_wavelength))
        throw InvalidArgument(fmt::format("longest wavelength of the drive's artefact {} m; expected a positive length",
                                          artefact.longest_wavelength));
}

/// Σ_k amplitude_k cos(2π k x/longest + φ_k) with phases drawn once.
class ArtefactCurve {
public:
    explicit ArtefactCurve(const DriveArtefact& artefact) : base_(2.0 * pi / artefact.longest_wavelength) {
        check(artefact);
        const auto session = substream(artefact.session, 1);
        double power = 0.0;
        for (int k = 1; k <= artefact_waves; ++k) power += 1.0 / (k * k);
        amplitude_ = artefact.rms * std::sqrt(2.0 / power);
        for (int k = 1; k <= artefact_waves; ++k)
            phases_[static_cast<std::size_t>(k - 1)] =
                2.0 * pi * numerics::uniform_number(session, static_cast<std::uint64_t>(k));
    }

    [[nodiscard]] double operator()(double position) const {
        if (amplitude_ == 0.0) return 0.0;
        double sum = 0.0;
        for (int k = 1; k <= artefact_waves; ++k)
            sum += std::cos(base_ * k * position + phases_[static_cast<std::size_t>(k - 1)]) / k;
        return amplitude_ * sum;
    }

private:
    double base_, amplitude_ = 0.0;
    std::array<double, artefact_waves> phases_{};
};

Index points_of(const StylusOptions& options) {
    if (!(options.step > 0.0) || !std::isfinite(options.step) || !std::isfinite(options.length) ||
        !(options.length / options.step < 1e9))
        throw InvalidArgument(
            fmt::format("stylus scan of {} m with steps of {} m; expected positive lengths and fewer than 1e9 points",
                        options.length, options.step));
    const auto points = static_cast<Index>(std::llround(options.length / options.step));
    if (points < 2)
        throw InvalidArgument(fmt::format("stylus scan of {} m with steps of {} m has {} points; expected at least 2",
                                          options.length, options.step, points));
    return points;
}

Array1D positions_of(const StylusOptions& options) {
    const auto points = points_of(options);
    return Array1D::LinSpaced(points, 0.0, static_cast<double>(points - 1)) * options.step;
}

}  // namespace

double drive_artefact(const DriveArtefact& artefact, double position) { return ArtefactCurve(artefact)(position); }

topography::LineScan stylus_scan(const topography::HeightMap& surface, const StylusOptions& options) {
    return stylus_scan(topography::Dilator(surface, options.tip, options.touch), options);
}

topography::LineScan stylus_scan(const topography::Dilator& touched, const StylusOptions& options) {
    const Array1D x = positions_of(options) + options.start_x;
    return recorded_scan(touched.readings(x, Array1D::Constant(x.size(), options.start_y)), options);
}

topography::LineScan recorded_scan(Array1D readings, const StylusOptions& options) {
    require_not_negative(options.noise_rms, "rms noise [m] of the stylus");
    require_finite(options.tilt, "tilt of the stylus scan");
    require_finite(options.bow, "bow [m] of the stylus scan");
    const auto points = points_of(options);
    if (readings.size() != points)
        throw InvalidArgument(fmt::format("{} readings of a stylus scan with {} points", readings.size(), points));
    const ArtefactCurve artefact(options.artefact);
    const Array1D noise = numerics::normal_numbers(substream(options.key, 0), 0, points);
    for (Index i = 0; i < points; ++i) {
        const double x = static_cast<double>(i) * options.step,
                     share = static_cast<double>(i) / static_cast<double>(points - 1);
        readings[i] += options.tilt * x + bow_at(options.bow, share) + artefact(x) + options.noise_rms * noise[i];
    }
    return {std::move(readings), static_cast<double>(points) * options.step, false,
            simulated_with_tip("stylus", options.tip, options.tip_radius_standard_error)};
}

topography::LineScan reference_scan(const StylusOptions& options) {
    return recorded_scan(Array1D::Zero(points_of(options)), options);
}

}  // namespace setae::simulation
