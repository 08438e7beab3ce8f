// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/admissible_spectra.hpp"

#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::spectra {
namespace {

/// A positive number, lognormal about its estimate.
class Positive {
public:
    Positive(const Estimate& estimate, const char* name) {
        if (!(estimate.value > 0.0 && std::isfinite(estimate.value)))
            throw InvalidArgument(fmt::format("{} of {}; expected a positive number", name, estimate.value));
        const double relative = estimate.standard_error > 0.0 ? estimate.standard_error / estimate.value : 0.0,
                     square = std::log1p(relative * relative);
        deviation_ = std::sqrt(square);
        mean_ = std::log(estimate.value) - 0.5 * square;
    }
    [[nodiscard]] double at(double normal) const { return std::exp(mean_ + deviation_ * normal); }

private:
    double mean_ = 0.0, deviation_ = 0.0;
};

std::optional<SelfAffine> self_affine(const std::array<double, 4>& moments) {
    try {
        const auto model = self_affine_with_moments(moments[0], moments[1], moments[2], moments[3]);
        if (model.hurst_exponent < 1.0) return model;
    } catch (const InvalidArgument&) {
        // no spectrum has these moments
    }
    return std::nullopt;
}

}  // namespace

AdmissibleSpectra admissible_spectra(const StatedMoments& moments, int count, std::uint64_t seed) {
    if (count < 1) throw InvalidArgument(fmt::format("{} spectra; expected at least 1", count));
    const std::array<Positive, 4> stated{
        Positive(moments.rms_height, "rms height"), Positive(moments.rms_slope, "rms slope"),
        Positive(moments.rms_curvature, "rms curvature"), Positive(moments.short_wavevector, "short wavevector")};
    constexpr int tries_per_spectrum = 100;
    AdmissibleSpectra result;
    std::uint64_t tried = 0;
    while (static_cast<int>(result.draws.size()) < count) {
        if (tried >= static_cast<std::uint64_t>(tries_per_spectrum) * (result.draws.size() + 1))
            throw InvalidArgument(fmt::format(
                "{} of {} sets of moments within their errors belong to a self-affine spectrum with 0 < H < "
                "1; expected at least one in {}: check h_rms, slope and curvature against each other",
                result.draws.size(), tried, tries_per_spectrum));
        const auto key = numerics::substream({seed, 0}, tried++);
        std::array<double, 4> drawn{};
        for (std::size_t i = 0; i < drawn.size(); ++i) drawn[i] = stated[i].at(numerics::normal_number(key, i));
        if (const auto model = self_affine(drawn)) result.draws.push_back(*model);
    }
    result.share = static_cast<double>(count) / static_cast<double>(tried);
    return result;
}

}  // namespace setae::spectra
