// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/elastic_operator.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pixel_kernels.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/summation.hpp"
#include "setae/fourier/fast_length.hpp"

namespace setae::half_space {
namespace {

bool repeats_along_x(Edges edges) { return edges == Edges::periodic || edges == Edges::periodic_along_x; }
bool repeats_along_y(Edges edges) { return edges == Edges::periodic || edges == Edges::periodic_along_y; }

/// For an axis that is not periodic, as many additional points without pressure, with an even number suited to the
/// transform.
Index period(Index points, bool repeats) { return repeats ? points : 2 * fourier::fast_length(points); }

const Grid& checked(const Grid& grid, const Body& body, Edges edges) {
    require(grid);
    require(body);
    if (edges == Edges::periodic) return grid;
    if (body.layer) throw InvalidArgument("a layer with free edges; expected periodic edges, or a half-space");
    if ((grid.nx == 1 && !repeats_along_x(edges)) || (grid.ny == 1 && !repeats_along_y(edges)))
        throw InvalidArgument(
            fmt::format("{} x {} points with free edges across the line; expected edges periodic "
                        "along its length",
                        grid.nx, grid.ny));
    return grid;
}

fourier::LoadRow rows_of(const ArrayView2D& map) {
    return [&map](Index i, double* line) {
        const double* row = map.data() + i * map.outerStride();
        std::copy(row, row + map.cols(), line);
    };
}

fourier::StoreRow rows_to(Eigen::Ref<Array2D>& map) {
    return
        [&map](Index i, const double* line) { std::copy(line, line + map.cols(), map.data() + i * map.outerStride()); };
}

}  // namespace

ElasticOperator::ElasticOperator(const Grid& grid, const Body& body, Edges edges, parallel::Threads threads,
                                 const parallel::Ranks* ranks)
    : grid_(checked(grid, body, edges)),
      body_(body),
      edges_(edges),
      slab_(slab_of(grid, ranks)),
      filter_(slab_, grid.ny, period(grid.nx, repeats_along_x(edges)), period(grid.ny, repeats_along_y(edges)),
              threads) {
    if (!slab_.in_one_process() && edges != Edges::periodic)
        throw InvalidArgument("a map with free edges is divided between processes; expected periodic edges");
    const double x = grid.nx > 1 ? 2.0 * pi / grid.size_x : 0.0, y = grid.ny > 1 ? 2.0 * pi / grid.size_y : 0.0;
    const double longest = x > 0.0 && y > 0.0 ? std::min(x, y) : std::max(x, y);
    const Index half_x = grid.nx / 2, half_y = grid.ny / 2;
    const double shortest = std::hypot(x * static_cast<double>(half_x), y * static_cast<double>(half_y));
    min_stiffness_ = longest > 0.0 ? half_space::stiffness(longest, body_) : 0.0;
    greatest_stiffness_ = shortest > 0.0 ? half_space::stiffness(shortest, body_) : 0.0;
}

double ElasticOperator::wavevector(Index k, Index m) const {
    const double length_x = static_cast<double>(filter_.period_x()) * grid_.pixel_x(),
                 length_y = static_cast<double>(filter_.period_y()) * grid_.pixel_y();
    return 2.0 * pi * std::hypot(static_cast<double>(k) / length_x, static_cast<double>(m) / length_y);
}

MeanDisplacement ElasticOperator::mean_displacement() const {
    if (edges_ == Edges::free) return MeanDisplacement::finite;
    const double mean = half_space::stiffness(0.0, body_);
    if (mean == 0.0) return MeanDisplacement::undefined;
    return std::isinf(mean) ? MeanDisplacement::blocked : MeanDisplacement::finite;
}

fourier::Multiplier ElasticOperator::multiplier(const std::function<double(double)>& factor) const {
    return filter_.multiplier([&](Index k, Index m) { return factor(half_space::stiffness(wavevector(k, m), body_)); });
}

fourier::Multiplier ElasticOperator::made_compliance() const {
    using Axes = fourier::MapFilter::KernelAxes;
    const double dx = grid_.pixel_x(), dy = grid_.pixel_y(), modulus = body_.contact_modulus;
    const auto place = [](Index i, double step) { return static_cast<double>(i) * step; };
    switch (edges_) {
        case Edges::free:
            return filter_.kernel_multiplier([&](Index i, Index j) {
                return rectangle_displacement(place(i, dx), place(j, dy), {0.5 * dx, 0.5 * dy}) / modulus;
            });
        case Edges::periodic_along_x:
            return filter_.kernel_multiplier(
                [&](Index k, Index j) {
                    return strip_displacement(wavevector(k, 0), place(j, dy), 0.5 * dy, grid_.size_x) / modulus;
                },
                Axes::y);
        case Edges::periodic_along_y:
            return filter_.kernel_multiplier(
                [&](Index i, Index m) {
                    return strip_displacement(wavevector(0, m), place(i, dx), 0.5 * dx, grid_.size_y) / modulus;
                },
                Axes::x);
        case Edges::periodic: break;
    }
    return multiplier([](double k) { return k > 0.0 ? 1.0 / k : 0.0; });
}

const fourier::Multiplier& ElasticOperator::compliance() {
    if (!compliance_) compliance_ = made_compliance();
    return *compliance_;
}

const fourier::Multiplier& ElasticOperator::stiffness() {
    if (edges_ != Edges::periodic)
        throw InvalidArgument(
            "pressures follow from displacements only with periodic edges, and these are free; expected "
            "periodic edges");
    if (!stiffness_) stiffness_ = multiplier([](double k) { return std::isinf(k) ? 0.0 : k; });
    return *stiffness_;
}

void ElasticOperator::displacements(const ArrayView2D& pressures, Eigen::Ref<Array2D> displacements) {
    require_shape(pressures, grid_, "pressures");
    require_shape(displacements, grid_, "displacements");
    apply(compliance(), rows_of(pressures), rows_to(displacements));
}

void ElasticOperator::pressures(const ArrayView2D& displacements, Eigen::Ref<Array2D> pressures) {
    require_shape(displacements, grid_, "displacements");
    require_shape(pressures, grid_, "pressures");
    apply(stiffness(), rows_of(displacements), rows_to(pressures));
}

double ElasticOperator::energy_of_pressures(const ArrayView2D& pressures) {
    require_shape(pressures, grid_, "pressures");
    return 0.5 * grid_.pixel_area() * filter_.quadratic_form(compliance(), rows_of(pressures));
}

double ElasticOperator::energy_of_displacements(const ArrayView2D& displacements) {
    require_shape(displacements, grid_, "displacements");
    return 0.5 * grid_.pixel_area() * filter_.quadratic_form(stiffness(), rows_of(displacements));
}

double stored_energy(const ArrayView2D& pressures, const ArrayView2D& displacements, const Grid& grid) {
    require_shape(pressures, grid, "pressures");
    require_shape(displacements, grid, "displacements");
    Array1D rows(grid.nx);
    for (Index i = 0; i < grid.nx; ++i) rows[i] = pairwise_sum((pressures.row(i) * displacements.row(i)).transpose());
    return 0.5 * grid.pixel_area() * pairwise_sum(rows);
}

}  // namespace setae::half_space
