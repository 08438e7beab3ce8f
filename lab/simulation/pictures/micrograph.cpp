// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/micrograph.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "gaussian_blur.hpp"
#include "polygon_coverage.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::simulation {
namespace {

constexpr double texture_correlation = 2.0;  // px
constexpr double patch_size = 60.0;          // px
constexpr double patch_angles = 0.5;         // rad: standard deviation of the patches' angles

enum PictureStream : std::uint64_t { noise_stream, texture_stream, patch_stream };

void require(bool holds, const std::string& what) {
    if (!holds) throw InvalidArgument(what);
}

void check(const MicrographOptions& o) {
    require(o.width >= 1 && o.height >= 1,
            fmt::format("a picture of {} × {} pixels; expected at least 1 × 1", o.width, o.height));
    require(std::isfinite(o.vacuum_level) && std::isfinite(o.sample_level),
            fmt::format("grey levels {} of vacuum and {} of the sample; expected finite numbers", o.vacuum_level,
                        o.sample_level));
    const auto not_negative = [](double value, const char* name) {
        require(value >= 0.0 && std::isfinite(value),
                fmt::format("{} is {}; expected a finite number, at least 0", name, value));
    };
    not_negative(o.noise, "the picture's noise");
    not_negative(o.noise_blur, "the blur of noise");
    not_negative(o.blur, "the blur");
    not_negative(o.texture, "the texture's standard deviation");
    const auto finite = [](double value, const char* name) {
        require(std::isfinite(value), fmt::format("{} is {}; expected a finite number", name, value));
    };
    finite(o.fringe_amplitude, "the fringe's amplitude");
    finite(o.drift, "the drift of the grey level");
    finite(o.lattice_amplitude, "the lattice's amplitude");
    finite(o.lattice_angle, "the lattice's angle");
    require(o.fringe_width > 0.0 && std::isfinite(o.fringe_width),
            fmt::format("the fringe's width is {} px; expected more than 0", o.fringe_width));
    require(o.lattice_period > 0.0 && std::isfinite(o.lattice_period),
            fmt::format("the lattice's period is {} px; expected more than 0", o.lattice_period));
}

void check(const PixelCurve& curve, const MicrographOptions& options) {
    const Index n = curve.x.size();
    require(n >= 2 && curve.y.size() == n,
            fmt::format("a curve of {} x and {} y; expected as many of both, at least 2", n, curve.y.size()));
    require(curve.x.isFinite().all() && curve.y.isFinite().all(),
            "a curve with places that are not finite; expected numbers");
    const double left = -0.5, right = static_cast<double>(options.width) - 0.5;
    require(
        curve.x[0] <= left && curve.x[n - 1] >= right,
        fmt::format(
            "the curve runs from x = {} to {} px; expected from {} or before to {} or beyond, as the picture is {} px wide",
            curve.x[0], curve.x[n - 1], left, right, options.width));
}

void check_simple(const Array2D& coverage, const PixelWindow& window) {
    constexpr double rounding = 1e-9;
    Index row = 0, column = 0;
    if (coverage.maxCoeff(&row, &column) <= 1.0 + rounding && coverage.minCoeff(&row, &column) >= -rounding) return;
    throw InvalidArgument(
        fmt::format("the curve crosses itself near x = {}, y = {} px; expected a curve that turns back at most",
                    column + window.left, row + window.top));
}

/// Share of the sample in each pixel, blurred.
Array2D blurred_coverage(const PixelCurve& curve, const MicrographOptions& options) {
    const GaussianKernel kernel(options.blur);
    const PixelWindow window{-kernel.half(), -kernel.half(), options.width + 2 * kernel.half(),
                             options.height + 2 * kernel.half()};
    const Array2D coverage = coverage_below(curve, window);
    check_simple(coverage, window);
    return blurred(coverage, kernel);
}

/// White noise of standard deviation 1, blurred and as strong as before.
Array2D blurred_noise(const MicrographOptions& options, double blur, numerics::RandomKey key) {
    const GaussianKernel kernel(blur);
    const Index columns = options.width + 2 * kernel.half();
    Array2D white(options.height + 2 * kernel.half(), columns);
    Array1D numbers(columns);
    for (Index row = 0; row < white.rows(); ++row) {
        numerics::fill_normal(key, static_cast<std::uint64_t>(row * columns), numbers);
        white.row(row) = numbers.transpose();
    }
    return blurred(white, kernel) / kernel.noise_left();
}

void add_fringe(Array2D& picture, const PixelCurve& curve, const MicrographOptions& options) {
    const double reach = 4.0 * options.fringe_width;  // e⁻⁵⁰ there
    const Array2D distance = signed_distance(curve, {0, 0, options.width, options.height}, reach);
    for (Index i = 0; i < picture.size(); ++i) {
        const double d = distance.data()[i];
        if (std::abs(d) >= reach) continue;
        const double t = d / options.fringe_width;
        picture.data()[i] += options.fringe_amplitude * std::sin(pi / 6.0 * t * (2.0 + t * t)) *
                             std::exp(-std::pow(t * t - 1.0, 2) / 4.5);
    }
}

/// A crystallite: its centre, and orientation and phase of its planes.
struct Patch {
    double x, y, wave_x, wave_y, phase;
};

/// One patch in each square of a grid around the picture, at least a fifth of a square from its sides: the patch
/// nearest to a position is then that of its square or of the eight around it.
class Patches {
public:
    explicit Patches(const MicrographOptions& options) : across_(count(options.width)) {
        const long down = count(options.height);
        const auto key = substream(options.key, patch_stream);
        for (long row = 0; row < down; ++row)
            for (long column = 0; column < across_; ++column) {
                const auto number = 4 * static_cast<std::uint64_t>(row * across_ + column);
                const double place_x = uniform_number(key, number), place_y = uniform_number(key, number + 1),
                             phase = uniform_number(key, number + 2);
                const double angle = options.lattice_angle + patch_angles * normal_number(substream(key, 0), number);
                const double wave = 2.0 * pi / options.lattice_period;
                patches_.push_back({(static_cast<double>(column - 1) + 0.2 + 0.6 * place_x) * patch_size,
                                    (static_cast<double>(row - 1) + 0.2 + 0.6 * place_y) * patch_size,
                                    wave * std::cos(angle), wave * std::sin(angle), 2.0 * pi * phase});
            }
    }

    [[nodiscard]] double fringes(double x, double y) const {
        const long row = static_cast<long>(y / patch_size) + 1, column = static_cast<long>(x / patch_size) + 1;
        const Patch* nearest = nullptr;
        double least = 0.0;
        for (long i = row - 1; i <= row + 1; ++i)
            for (long j = column - 1; j <= column + 1; ++j) {
                const Patch& patch = patches_[static_cast<std::size_t>(i * across_ + j)];
                const double squared = (patch.x - x) * (patch.x - x) + (patch.y - y) * (patch.y - y);
                if (!nearest || squared < least) {
                    nearest = &patch;
                    least = squared;
                }
            }
        return std::cos(nearest->wave_x * x + nearest->wave_y * y + nearest->phase);
    }

private:
    static long count(long pixels) { return static_cast<long>(static_cast<double>(pixels) / patch_size) + 3; }
    long across_;
    std::vector<Patch> patches_;
};

void add_lattice(Array2D& picture, const Array2D& coverage, const MicrographOptions& options) {
    const Patches patches(options);
    for (long row = 0; row < options.height; ++row)
        for (long column = 0; column < options.width; ++column)
            if (coverage(row, column) > 0.0)
                picture(row, column) += options.lattice_amplitude * coverage(row, column) *
                                        patches.fringes(static_cast<double>(column), static_cast<double>(row));
}

void add_drift(Array2D& picture, const MicrographOptions& options) {
    const Array1D across = Array1D::LinSpaced(options.width, 0.0, 0.5),
                  down = Array1D::LinSpaced(options.height, 0.0, 0.5);
    for (long row = 0; row < options.height; ++row) {
        const Array1D along = across + down[row];
        picture.row(row) += (options.drift * (along + 2.0 * along * (1.0 - along))).transpose();
    }
}

}  // namespace

imaging::FramePixels render_micrograph(const PixelCurve& curve, const MicrographOptions& options) {
    check(options);
    check(curve, options);
    const Array2D coverage = blurred_coverage(curve, options);
    Array2D picture = options.vacuum_level + (options.sample_level - options.vacuum_level) * coverage;
    if (options.fringe_amplitude != 0.0) add_fringe(picture, curve, options);
    if (options.lattice_amplitude != 0.0) add_lattice(picture, coverage, options);
    if (options.texture > 0.0)
        picture += options.texture * coverage *
                   blurred_noise(options, texture_correlation / std::sqrt(2.0), substream(options.key, texture_stream));
    if (options.drift != 0.0) add_drift(picture, options);
    if (options.noise > 0.0)
        picture += options.noise * blurred_noise(options, options.noise_blur, substream(options.key, noise_stream));
    return picture.cast<float>();
}

}  // namespace setae::simulation
