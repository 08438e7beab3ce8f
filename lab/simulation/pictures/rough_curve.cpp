// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/rough_curve.hpp"

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::simulation {
namespace {

constexpr double beyond = 60.0;                           // px of curve on either side of the picture
constexpr double point_spacing = 0.25;                    // px
constexpr double height_spacing = 0.0625;                 // px: straight between, 1e-4 px for a cutoff of 10 px
constexpr double min_neck = 6.0, largest_neck = 9.0;      // half of it in px
constexpr double min_fillet = 5.0, largest_fillet = 8.0;  // px
constexpr double apart = 20.0;                            // px of level line between bulges

enum CurveStream : std::uint64_t { height_stream, bulge_stream };

void require_curve(bool holds, const std::string& what) {
    if (!holds) throw InvalidArgument(what);
}

void check(const RoughCurveOptions& o) {
    require_curve(o.width >= 16 && o.height >= 16,
                  fmt::format("a curve for {} × {} pixels; expected at least 16 × 16", o.width, o.height));
    require_curve(o.rms_height > 0.0 && std::isfinite(o.rms_height),
                  fmt::format("rms height {} px of the curve; expected a positive number", o.rms_height));
    require_curve(o.hurst_exponent > 0.0 && o.hurst_exponent <= 1.0,
                  fmt::format("Hurst exponent {}; expected 0 < H <= 1", o.hurst_exponent));
    require_curve(
        o.cutoff_wavelength >= 2.0 && o.cutoff_wavelength < o.rolloff_wavelength && std::isfinite(o.rolloff_wavelength),
        fmt::format("waves from {} down to {} px; expected 2 <= cutoff < rolloff", o.rolloff_wavelength,
                    o.cutoff_wavelength));
    require_curve(std::abs(o.tilt) < 1.0, fmt::format("a tilt of {} rad; expected less than 1", o.tilt));
    require_curve(
        o.bulges >= 0 && o.min_depth > 0.0 && o.min_depth <= o.largest_depth && std::isfinite(o.largest_depth),
        fmt::format("{} bulges that overhang by {} to {} px; expected 0 < least <= largest", o.bulges, o.min_depth,
                    o.largest_depth));
}

/// Random heights [px], upwards, at any place of the curve.
class Heights {
public:
    Heights(const RoughCurveOptions& options, double begin, double end) : begin_(begin) {
        const double period = 1.5 * (end - begin);
        const auto points = 2 * static_cast<Index>(std::ceil(0.5 * period / height_spacing));
        const double rolloff = 2.0 * pi / options.rolloff_wavelength, cutoff = 2.0 * pi / options.cutoff_wavelength,
                     power = -1.0 - 2.0 * options.hurst_exponent;
        const auto density = [=](double q) { return q > cutoff ? 0.0 : std::pow(std::max(1.0, q / rolloff), power); };
        auto line = synthesis::random_line(
            density, {points, period},
            {.key = substream(options.key, height_stream), .exact_rms_height = options.rms_height});
        heights_ = std::move(line.heights);
        spacing_ = period / static_cast<double>(points);
    }
    [[nodiscard]] double at(double x) const {
        const double place = (x - begin_) / spacing_, before = std::floor(place);
        const auto index = static_cast<Index>(before);
        return heights_[index] + (place - before) * (heights_[index + 1] - heights_[index]);
    }

private:
    double begin_, spacing_ = 0.0;
    Array1D heights_;
};

/// A round cap on a neck. v: height above the level line [px].
struct Bulge {
    double centre, neck, depth, fillet;

    [[nodiscard]] double cap() const { return neck + depth; }
    [[nodiscard]] double half_width() const { return neck + fillet + depth; }
    [[nodiscard]] double cap_height() const {
        return fillet + std::sqrt(std::pow(cap() + fillet, 2) - std::pow(neck + fillet, 2));
    }
    /// Angle of the line from a fillet's centre to the cap's, above the horizontal.
    [[nodiscard]] double joint() const { return std::acos((neck + fillet) / (cap() + fillet)); }
};

/// Points of a curve under construction.
struct Points {
    std::vector<double> x, v;

    void add(double at, double height) {
        x.push_back(at);
        v.push_back(height);
    }
    void add_level(double from, double to) {
        const auto count = std::max(1L, std::lround((to - from) / point_spacing));
        for (long k = 0; k < count; ++k)
            add(from + (to - from) * static_cast<double>(k) / static_cast<double>(count), 0.0);
    }
    /// An arc from one angle to another, anticlockwise from x towards v; without its end.
    void add_arc(double x0, double v0, double radius, double from, double to) {
        const auto count = std::max(1L, std::lround(std::abs(to - from) * radius / point_spacing));
        for (long k = 0; k < count; ++k) {
            const double angle = from + (to - from) * static_cast<double>(k) / static_cast<double>(count);
            add(x0 + radius * std::cos(angle), v0 + radius * std::sin(angle));
        }
    }
    void add_bulge(const Bulge& b) {
        const double foot = b.neck + b.fillet, joint = b.joint();
        add_arc(b.centre - foot, b.fillet, b.fillet, -0.5 * pi, joint);
        add_arc(b.centre, b.cap_height(), b.cap(), pi + joint, -joint);
        add_arc(b.centre + foot, b.fillet, b.fillet, pi - joint, 1.5 * pi);
    }
};

/// Bulges in equal parts of the picture's width, each somewhere within its part.
std::vector<Bulge> bulges_of(const RoughCurveOptions& options) {
    const auto key = substream(options.key, bulge_stream);
    const double part = static_cast<double>(options.width) * std::cos(options.tilt) / std::max(1, options.bulges);
    const double widest = 2.0 * (largest_neck + largest_fillet + options.largest_depth) + apart;
    require_curve(
        options.bulges == 0 || part >= widest,
        fmt::format("{} bulges within {} px; expected at most one in {} px", options.bulges, options.width, widest));
    std::vector<Bulge> bulges;
    for (int i = 0; i < options.bulges; ++i) {
        const auto number = 4 * static_cast<std::uint64_t>(i);
        const auto between = [&](std::uint64_t which, double least, double largest) {
            return least + (largest - least) * uniform_number(key, number + which);
        };
        Bulge bulge{0.0, between(0, min_neck, largest_neck), between(1, options.min_depth, options.largest_depth),
                    between(2, min_fillet, largest_fillet)};
        const double room = part - 2.0 * bulge.half_width() - apart;
        bulge.centre = part * (i + 0.5 - 0.5 * options.bulges) + room * (uniform_number(key, number + 3) - 0.5);
        bulges.push_back(bulge);
    }
    return bulges;
}

}  // namespace

RoughCurve rough_curve(const RoughCurveOptions& options) {
    check(options);
    // x from the picture's middle; the tilted curve must still span the picture
    const double half = (0.5 * static_cast<double>(options.width) + beyond +
                         8.0 * options.rms_height * std::abs(std::sin(options.tilt))) /
                        std::cos(options.tilt);
    const auto bulges = bulges_of(options);
    Points points;
    double reached = -half;
    for (const auto& bulge : bulges) {
        points.add_level(reached, bulge.centre - bulge.neck - bulge.fillet);
        points.add_bulge(bulge);
        reached = bulge.centre + bulge.neck + bulge.fillet;
    }
    points.add_level(reached, half);
    points.add(half, 0.0);

    const Heights heights(options, -half - 1.0, half + 1.0);
    const double middle_x = 0.5 * static_cast<double>(options.width - 1),
                 middle_y = 0.5 * static_cast<double>(options.height - 1);
    const double cosine = std::cos(options.tilt), sine = std::sin(options.tilt);
    const auto place = [&](double x, double v) {
        const double down = -(v + heights.at(x));
        return Overhang{middle_x + cosine * x - sine * down, middle_y + sine * x + cosine * down};
    };
    RoughCurve result;
    const auto count = static_cast<Index>(points.x.size());
    result.curve = {Array1D(count), Array1D(count)};
    for (Index i = 0; i < count; ++i) {
        const auto at = place(points.x[static_cast<std::size_t>(i)], points.v[static_cast<std::size_t>(i)]);
        result.curve.x[i] = at.x;
        result.curve.y[i] = at.y;
    }
    for (const auto& bulge : bulges)
        for (const double side : {-1.0, 1.0}) {
            auto overhang = place(bulge.centre + side * bulge.neck, bulge.fillet);
            overhang.depth = bulge.depth;
            result.overhangs.push_back(overhang);
        }
    return result;
}

}  // namespace setae::simulation
