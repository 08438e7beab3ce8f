// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/dilation.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "contact_search.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "tip_contact.hpp"

namespace setae::topography {
namespace {

/// Points read in sequence by one thread; each starts from the contact of its predecessor.
constexpr Index run_length = 512;

std::size_t runs(Index points) { return static_cast<std::size_t>((points + run_length - 1) / run_length); }

Index wrapped(Index index, Index points) { return ((index % points) + points) % points; }

/// A line as a map one point wide, with a width beyond the reach of the tip.
HeightMap as_map(const LineScan& line, const Tip& tip, const DilationOptions& options) {
    HeightMap map{line.heights.transpose(), {line.size, line.size}, line.periodic, line.metadata};
    const double reach = contact_reach(tip, height_range(map, options));
    if (!line.periodic && reach > line.size)
        throw InvalidArgument(
            fmt::format("{}: the tip extends {:.4g} m from its axis, but the line is {:.4g} m long; expected a tip "
                        "smaller than the line, a periodic line or a lower height_range",
                        label(line.metadata), reach, line.size));
    map.size[0] = 2.0 * reach + line.size;
    return map;
}

HeightMap upside_down(HeightMap map) {
    map.heights = -map.heights;
    return map;
}

/// The mirrored tip: t(−u).
Tip mirrored(Tip tip) {
    if (auto* array = std::get_if<ArrayTip>(&tip)) {
        array->heights = array->heights.reverse().eval();
        array->centre_x = array->heights.rows() - 1 - array->centre_x;
        array->centre_y = array->heights.cols() - 1 - array->centre_y;
    }
    return tip;
}

LineScan with_heights(LineScan line, const HeightMap& map) {
    line.heights = map.heights.row(0).transpose();
    return line;
}

}  // namespace

struct Dilator::State {
    const HeightMap* surface;
    DilationOptions options;
    ContactSearch search;

    /// The reading at a grid point of the surface; `contact` is that of the predecessor and becomes that of this point.
    double read(Index x, Index y, Contact& contact) const {
        if (options.keep_undefined && std::isnan(surface->heights(x, y))) return undefined;
        contact = search.highest(x, y, contact);
        return contact.x < 0 ? undefined : contact.apex_height;
    }
};

Dilator::Dilator(const HeightMap& surface, const Tip& tip, const DilationOptions& options)
    : state_(std::make_unique<State>(State{&surface, options,
                                           ContactSearch(surface.heights, surface.periodic, surface.periodic,
                                                         touching_tip(surface, tip, options), options.threads)})) {}

Dilator::~Dilator() = default;
Dilator::Dilator(Dilator&&) noexcept = default;
Dilator& Dilator::operator=(Dilator&&) noexcept = default;

double Dilator::reading(Index x, Index y) const {
    const auto& [surface, options, search] = *state_;
    const auto [nx, ny] = surface->shape();
    if (!surface->periodic && (x < 0 || y < 0 || x >= nx || y >= ny))
        throw InvalidArgument(fmt::format(
            "grid point ({}, {}) of {} by {}; expected a point of the grid, or a periodic surface", x, y, nx, ny));
    Contact none;
    return state_->read(wrapped(x, nx), wrapped(y, ny), none);
}

Array1D Dilator::readings(const ArrayView1D& x, const ArrayView1D& y) const {
    const auto& surface = *state_->surface;
    if (x.size() != y.size())
        throw InvalidArgument(fmt::format("{} positions x and {} y; expected as many of both", x.size(), y.size()));
    const auto pixel = surface.pixel_size();
    const auto [nx, ny] = surface.shape();
    Array1D result(x.size());
    parallel::for_each_index(runs(x.size()), state_->options.threads, [&, nx = nx, ny = ny](std::size_t run) {
        Contact contact;
        const auto first = static_cast<Index>(run) * run_length;
        for (Index k = first; k < std::min(first + run_length, x.size()); ++k) {
            const double at_x = std::round(x[k] / pixel[0]), at_y = std::round(y[k] / pixel[1]);
            const bool inside =
                at_x >= 0.0 && at_y >= 0.0 && at_x < static_cast<double>(nx) && at_y < static_cast<double>(ny);
            if (!(inside || (surface.periodic && std::abs(at_x) < 1e15 && std::abs(at_y) < 1e15)))
                throw InvalidArgument(fmt::format(
                    "point {} at ({} m, {} m) lies beyond the last point of the surface at ({} m, {} m); expected "
                    "points on the surface, or a periodic surface",
                    k, x[k], y[k], static_cast<double>(nx - 1) * pixel[0], static_cast<double>(ny - 1) * pixel[1]));
            result[k] =
                state_->read(wrapped(static_cast<Index>(at_x), nx), wrapped(static_cast<Index>(at_y), ny), contact);
        }
    });
    return result;
}

Array2D Dilator::readings() const {
    const auto [nx, ny] = state_->surface->shape();
    Array2D result(nx, ny);
    const std::size_t runs_per_row = runs(ny);
    parallel::for_each_index(static_cast<std::size_t>(nx) * runs_per_row, state_->options.threads,
                             [&, ny = ny](std::size_t run) {
                                 Contact contact;
                                 const auto row = static_cast<Index>(run / runs_per_row),
                                            first = static_cast<Index>(run % runs_per_row) * run_length;
                                 for (Index j = first; j < std::min(first + run_length, ny); ++j)
                                     result(row, j) = state_->read(row, j, contact);
                             });
    return result;
}

HeightMap dilated(const HeightMap& surface, const Tip& tip, const DilationOptions& options) {
    return {Dilator(surface, tip, options).readings(), surface.size, surface.periodic, surface.metadata};
}

LineScan dilated(const LineScan& surface, const Tip& tip, const DilationOptions& options) {
    return with_heights(surface, dilated(as_map(surface, tip, options), tip, options));
}

Array1D dilated_at(const HeightMap& surface, const Tip& tip, const ArrayView1D& x, const ArrayView1D& y,
                   const DilationOptions& options) {
    return Dilator(surface, tip, options).readings(x, y);
}

HeightMap eroded(const HeightMap& image, const Tip& tip, const DilationOptions& options) {
    return upside_down(dilated(upside_down(image), mirrored(tip), options));
}

LineScan eroded(const LineScan& image, const Tip& tip, const DilationOptions& options) {
    return with_heights(image, eroded(as_map(image, tip, options), tip, options));
}

}  // namespace setae::topography
