// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/projection_bias.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/transform.hpp"
#include "setae/simulation/silhouette.hpp"

namespace setae::simulation {
namespace {

/// Sums over lines of one kind on one surface.
struct LineSums {
    Array1D power;  ///< mean |Σ h exp(−iqx)|² of modes 0 … n/2
    double mean = 0.0, variance = 0.0, square_difference = 0.0;
};

struct SurfaceSums {
    LineSums lines, silhouettes;
};

class LineAverage {
public:
    explicit LineAverage(const fourier::RealTransform& transform)
        : transform_(transform),
          in_(static_cast<std::size_t>(transform.points())),
          out_(static_cast<std::size_t>(transform.modes())) {
        sums_.power = Array1D::Zero(transform.modes());
    }

    void add(const Eigen::Ref<const Array1D, 0, Eigen::InnerStride<>>& heights) {
        const auto n = heights.size();
        Eigen::Map<Array1D> line(in_.data(), n);
        const double mean = heights.mean();
        line = heights - mean;
        sums_.mean += mean;
        sums_.variance += line.square().mean();
        sums_.square_difference +=
            ((line.tail(n - 1) - line.head(n - 1)).square().sum() + std::pow(line[0] - line[n - 1], 2)) /
            static_cast<double>(n);
        transform_.forward(in_.data(), out_.data());
        for (Index k = 0; k < sums_.power.size(); ++k) sums_.power[k] += std::norm(out_[static_cast<std::size_t>(k)]);
        sums_.power[0] += std::pow(mean * static_cast<double>(n), 2);
        ++count_;
    }

    [[nodiscard]] LineSums average() const {
        const double n = count_;
        return {sums_.power / n, sums_.mean / n, sums_.variance / n, sums_.square_difference / n};
    }

private:
    const fourier::RealTransform& transform_;
    fourier::Buffer<double> in_;
    fourier::Buffer<fourier::Complex> out_;
    LineSums sums_;
    int count_ = 0;
};

Index lines_of_foil(const ProjectionOptions& options) {
    const double step = options.grid.size_y / static_cast<double>(options.grid.ny);
    if (!(options.thickness >= 0.0) || !(options.thickness <= options.grid.size_y - step * (1.0 - 1e-9)))
        throw InvalidArgument(fmt::format("foil {} m thick on a surface {} m wide; expected 0 <= thickness < width",
                                          options.thickness, options.grid.size_y));
    return static_cast<Index>(std::floor(options.thickness / step * (1.0 + 1e-12))) + 1;
}

SurfaceSums simulate(const spectra::SpectralDensity& C_iso, const ProjectionOptions& options, Index index,
                     const fourier::RealTransform& transform) {
    const auto map = random_surface(C_iso, options.grid,
                                    {.key = substream(options.key, static_cast<std::uint64_t>(index)), .threads = {1}});
    LineAverage lines(transform), silhouettes(transform);
    for (Index j = 0; j < options.grid.ny; ++j) lines.add(map.heights.col(j));
    const Index foil = lines_of_foil(options);
    const double step = map.pixel_size()[1];
    for (Index first = 0; first + foil <= options.grid.ny; first += foil)
        silhouettes.add(silhouette(map, options.thickness, static_cast<double>(first) * step).heights);
    return {lines.average(), silhouettes.average()};
}

/// Ratio of two sums over surfaces, and its standard error from their scatter about it.
BiasFactor ratio(const Array1D& numerator, const Array1D& denominator) {
    const double n = static_cast<double>(numerator.size()), value = numerator.sum() / denominator.sum();
    const Array1D deviation = (numerator - value * denominator) / denominator.mean();
    return {value, std::sqrt(deviation.square().sum() / (n * (n - 1.0)))};
}

BiasFactor root(const BiasFactor& square) {
    const double value = std::sqrt(square.value);
    return {value, 0.5 * square.standard_error / value};
}

/// Distance at which the transform of a power spectrum falls to 1/e; NaN where it does not over half the line.
double correlation_length(const Array1D& power, Index points, double step) {
    const fourier::InverseRealTransform inverse(points);
    fourier::Buffer<fourier::Complex> spectrum(static_cast<std::size_t>(inverse.modes()));
    fourier::Buffer<double> correlation(static_cast<std::size_t>(points));
    for (Index k = 0; k < power.size(); ++k) spectrum[static_cast<std::size_t>(k)] = power[k];
    inverse.apply(spectrum.data(), correlation.data());
    const double level = correlation[0] * std::exp(-1.0);
    for (std::size_t i = 1; i <= static_cast<std::size_t>(points / 2); ++i)
        if (correlation[i] <= level)
            return step * (static_cast<double>(i) - (level - correlation[i]) / (correlation[i - 1] - correlation[i]));
    return undefined;
}

template <class Value>
Array1D of_each(const std::vector<SurfaceSums>& surfaces, Value value) {
    Array1D result(static_cast<Index>(surfaces.size()));
    for (Index s = 0; s < result.size(); ++s) result[s] = value(surfaces[static_cast<std::size_t>(s)]);
    return result;
}

void fill_bins(ProjectionBias& bias, const std::vector<SurfaceSums>& surfaces, const ProjectionOptions& options) {
    const Index modes = surfaces.front().lines.power.size();
    // edges aligned with decades; a mode on an edge belongs to the bin above
    const auto bin_of = [&](Index mode) {
        const double wavevector = 2.0 * pi * static_cast<double>(mode) / options.grid.size_x;
        return static_cast<Index>(std::floor(std::log10(wavevector) * options.bins_per_decade + 1e-9));
    };
    // lines have only rounding errors beyond the spectrum's end
    double strongest = 0.0;
    for (const auto& surface : surfaces)
        strongest = std::max(strongest, surface.lines.power.tail(modes - 1).maxCoeff());
    const double rounding = 1e-16 * strongest * static_cast<double>(surfaces.size());
    std::vector<double> centres, values, errors;
    for (Index first = 1; first < modes;) {
        Index last = first;
        while (last + 1 < modes && bin_of(last + 1) == bin_of(first)) ++last;
        const auto power_in = [&](const LineSums& sums) { return sums.power.segment(first, last - first + 1).sum(); };
        const auto denominator = of_each(surfaces, [&](const SurfaceSums& s) { return power_in(s.lines); });
        if (denominator.sum() > rounding * static_cast<double>(last - first + 1)) {
            const auto factor =
                ratio(of_each(surfaces, [&](const SurfaceSums& s) { return power_in(s.silhouettes); }), denominator);
            centres.push_back(std::pow(10.0, (static_cast<double>(bin_of(first)) + 0.5) / options.bins_per_decade));
            values.push_back(factor.value);
            errors.push_back(factor.standard_error);
        }
        first = last + 1;
    }
    const auto n = static_cast<Index>(centres.size());
    bias.wavevector = Eigen::Map<const Array1D>(centres.data(), n);
    bias.C1D = Eigen::Map<const Array1D>(values.data(), n);
    bias.C1D_standard_error = Eigen::Map<const Array1D>(errors.data(), n);
}

}  // namespace

ProjectionBias projection_bias(const spectra::SpectralDensity& C_iso, const ProjectionOptions& options) {
    if (options.surfaces < 2 || options.bins_per_decade < 1)
        throw InvalidArgument(
            fmt::format("{} surfaces, {} bins a decade for the bias of a foil; expected at least 2 and 1",
                        options.surfaces, options.bins_per_decade));
    (void)lines_of_foil(options);
    const fourier::RealTransform transform(options.grid.nx);
    std::vector<SurfaceSums> surfaces(static_cast<std::size_t>(options.surfaces));
    parallel::for_each_index(surfaces.size(), options.threads, [&](std::size_t s) {
        surfaces[s] = simulate(C_iso, options, static_cast<Index>(s), transform);
    });
    ProjectionBias bias;
    bias.thickness = options.thickness;
    Array1D power = Array1D::Zero(transform.modes());
    for (const auto& surface : surfaces) power += surface.lines.power;
    bias.correlation_length =
        correlation_length(power, options.grid.nx, options.grid.size_x / static_cast<double>(options.grid.nx));
    fill_bins(bias, surfaces, options);
    const auto variance = of_each(surfaces, [](const SurfaceSums& s) { return s.lines.variance; });
    bias.rms_height =
        root(ratio(of_each(surfaces, [](const SurfaceSums& s) { return s.silhouettes.variance; }), variance));
    bias.rms_slope = root(ratio(of_each(surfaces, [](const SurfaceSums& s) { return s.silhouettes.square_difference; }),
                                of_each(surfaces, [](const SurfaceSums& s) { return s.lines.square_difference; })));
    const auto shift = of_each(surfaces, [](const SurfaceSums& s) { return s.silhouettes.mean - s.lines.mean; });
    bias.mean_height_shift = shift.mean() / std::sqrt(variance.mean());
    return bias;
}

std::vector<Alert> projection_alerts(const ProjectionBias& bias, const std::string& subject, double tolerance) {
    const double lowest = std::min({bias.C1D.minCoeff(), bias.rms_height.value, bias.rms_slope.value});
    const double highest = std::max({bias.C1D.maxCoeff(), bias.rms_height.value, bias.rms_slope.value});
    if (1.0 - lowest <= tolerance && highest - 1.0 <= tolerance) return {};
    return {
        {"FOIL_PROJECTION", subject,
         fmt::format(
             "a contour is the silhouette of a foil {:.3g} nm thick, not a line scan: on a Gaussian surface of this spectrum it reads "
             "{:.3g} of the rms height, {:.3g} of the slope, and C1D {:.3g} … {:.3g} of the true value",
             bias.thickness * 1e9, bias.rms_height.value, bias.rms_slope.value, bias.C1D.minCoeff(),
             bias.C1D.maxCoeff()),
         "divide C1D by the factor of each wavevector, use thinner foils, or leave out wavelengths shorter than the foil is thick"}};
}

}  // namespace setae::simulation
