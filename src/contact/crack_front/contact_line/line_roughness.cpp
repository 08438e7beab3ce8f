// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact_line/line_roughness.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/resampling.hpp"
#include "setae/core/units.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/transform.hpp"
#include "setae/numerics/minimum.hpp"

namespace setae::contact_line {
namespace {

constexpr Index max_blocks = 16, min_modes = 4;
constexpr double lowest_exponent = -0.5, highest_exponent = 2.5;

/// |r_n|² of every frame, n = 0 … N/2: shape (M, N/2 + 1).
Array2D periodograms(const ContactLine& line) {
    const Index n = line.angles();
    const fourier::RealTransform transform(n);
    fourier::Buffer<double> radius(static_cast<std::size_t>(n));
    fourier::Buffer<fourier::Complex> modes(static_cast<std::size_t>(transform.modes()));
    Array2D power(line.frames(), transform.modes());
    for (Index i = 0; i < line.frames(); ++i) {
        for (Index j = 0; j < n; ++j) radius[static_cast<std::size_t>(j)] = line.radius(i, j);
        transform.forward(radius.data(), modes.data());
        for (Index k = 0; k < transform.modes(); ++k)
            power(i, k) =
                std::norm(modes[static_cast<std::size_t>(k)]) / (static_cast<double>(n) * static_cast<double>(n));
    }
    return power;
}

struct Law {
    double exponent = 0.0, amplitude = 0.0;
};

/// Whittle's fit of A n^−(1 + 2ζ) + noise to powers of modes.
class WhittleFit {
public:
    WhittleFit(const ArrayView1D& mode, const ArrayView1D& power, double noise)
        : log_mode_(mode.log()), power_(power), noise_(noise) {}

    [[nodiscard]] Law law() const {
        const auto best = numerics::minimum_between([this](double exponent) { return deviance(exponent); },
                                                    lowest_exponent, highest_exponent, 30);
        return {best.place, amplitude(shape(best.place))};
    }

private:
    [[nodiscard]] Array1D shape(double exponent) const { return (-(1.0 + 2.0 * exponent) * log_mode_).exp(); }

    /// The likelihood's maximum for a given ζ, by Fisher's scoring; 0 where only noise is more likely.
    [[nodiscard]] double amplitude(const Array1D& shape) const {
        double a = (power_ / shape).mean();
        if (noise_ == 0.0) return a;
        for (int round = 0; round < 200; ++round) {
            const Array1D weight = (shape / (a * shape + noise_)).square();
            const double next = std::max(0.0, (weight * (power_ - noise_) / shape).sum() / weight.sum());
            if (std::abs(next - a) <= 1e-13 * a) return next;
            a = next;
        }
        return a;
    }

    [[nodiscard]] double deviance(double exponent) const {
        const Array1D s = shape(exponent);
        const Array1D expected = amplitude(s) * s + noise_;
        return (expected.log() + power_ / expected).sum();
    }

    Array1D log_mode_, power_;
    double noise_;
};

/// ⟨(r(θ + Δθ) − r(θ))²⟩^½ = (4 Σ_n w_n power_n (1 − cos nΔθ))^½ of modes from 3 on; w_n = 1, ½ for n = N/2.
Array1D structure_function(const ArrayView1D& power, Index angles) {
    const Index half = angles / 2;
    Array1D structure(half);
    for (Index k = 1; k <= half; ++k) {
        double sum = 0.0;
        for (Index n = 3; n <= half; ++n) {
            const double phase = 2.0 * pi * static_cast<double>((n * k) % angles) / static_cast<double>(angles);
            sum += (2 * n == angles ? 0.5 : 1.0) * power[n] * (1.0 - std::cos(phase));
        }
        structure[k - 1] = std::sqrt(4.0 * sum);
    }
    return structure;
}

/// Means without each of at most 16 blocks of consecutive frames.
std::vector<Array1D> means_without_blocks(const Array2D& power) {
    const Index frames = power.rows(), blocks = std::min(frames, max_blocks);
    const Array1D whole = power.colwise().sum().transpose();
    std::vector<Array1D> means;
    for (Index b = 0; b < blocks && blocks > 1; ++b) {
        const Index first = frames * b / blocks, end = frames * (b + 1) / blocks;
        const Array1D block = power.middleRows(first, end - first).colwise().sum().transpose();
        means.emplace_back((whole - block) / static_cast<double>(frames - (end - first)));
    }
    return means;
}

}  // namespace

LineRoughness line_roughness(const ContactLine& line, const RoughnessBand& band) {
    require_valid(line);
    const Index half = line.angles() / 2, first = band.smallest_mode,
                last = band.largest_mode == 0 ? line.angles() / 4 : band.largest_mode;
    if (first < 1 || last > half || last - first + 1 < min_modes)
        throw InvalidArgument(fmt::format("modes {} to {} of a line of {} angles; expected at least {} of 1 to {}",
                                          first, last, line.angles(), min_modes, half));
    const auto power = periodograms(line);
    const Array1D mean = power.colwise().mean().transpose();
    const double noise = line.place_error * line.place_error / static_cast<double>(line.angles());
    LineRoughness result;
    result.smallest_mode = first;
    result.largest_mode = last;
    result.mode = Array1D::LinSpaced(half, 1.0, static_cast<double>(half));
    result.power = mean.tail(half);
    result.lag = 2.0 * pi / static_cast<double>(line.angles()) * result.mode;
    result.structure = structure_function(mean, line.angles());
    const auto fit = [&](const Array1D& powers) {
        return WhittleFit(result.mode.segment(first - 1, last - first + 1), powers.segment(first, last - first + 1),
                          noise)
            .law();
    };
    const auto law = fit(mean);
    if (!(law.amplitude > 0.0))
        throw UndefinedDataError(
            fmt::format("modes {} to {} of the contact line are not stronger than the noise of {:.3g} m per place; use "
                        "lower modes or a sharper recording",
                        first, last, line.place_error));
    LeaveOneOut exponents;
    for (const auto& without : means_without_blocks(power)) exponents.push_back(fit(without).exponent);
    result.exponent = jackknife_estimate(law.exponent, std::vector<LeaveOneOut>{exponents});
    result.amplitude = law.amplitude;
    return result;
}

}  // namespace setae::contact_line
