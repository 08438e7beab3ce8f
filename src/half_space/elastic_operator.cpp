// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/elastic_operator.hpp"

#include <algorithm>
#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/summation.hpp"

namespace setae::half_space {
namespace {

const Grid& checked(const Grid& grid) {
    require(grid);
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

ElasticOperator::ElasticOperator(const Grid& grid, const Body& body, Edges edges, parallel::Threads threads)
    : grid_(checked(grid)), body_(body), edges_(edges), filter_(grid.nx, grid.ny, grid.nx, grid.ny, threads) {
    require(body);
    if (edges != Edges::periodic) throw InvalidArgument("edges of the map are not periodic; expected periodic edges");
    const Index longest_x = std::min<Index>(1, grid.nx / 2), longest_y = std::min<Index>(1, grid.ny / 2);
    double least = 0.0;  // of a grid of one point, which holds no wave
    if (longest_x > 0) least = half_space::stiffness(wavevector(longest_x, 0), body_);
    if (longest_y > 0) {
        const double along_y = half_space::stiffness(wavevector(0, longest_y), body_);
        least = longest_x > 0 ? std::min(least, along_y) : along_y;
    }
    least_stiffness_ = least;
    greatest_stiffness_ =
        longest_x + longest_y > 0 ? half_space::stiffness(wavevector(grid.nx / 2, grid.ny / 2), body_) : 0.0;
}

double ElasticOperator::wavevector(Index k, Index m) const {
    return 2.0 * pi * std::hypot(static_cast<double>(k) / grid_.size_x, static_cast<double>(m) / grid_.size_y);
}

MeanDisplacement ElasticOperator::mean_displacement() const {
    const double mean = half_space::stiffness(0.0, body_);
    if (mean == 0.0) return MeanDisplacement::undefined;
    return std::isinf(mean) ? MeanDisplacement::blocked : MeanDisplacement::finite;
}

fourier::Multiplier ElasticOperator::multiplier(const std::function<double(double)>& factor) const {
    return filter_.multiplier([&](Index k, Index m) { return factor(half_space::stiffness(wavevector(k, m), body_)); });
}

const fourier::Multiplier& ElasticOperator::compliance() {
    if (!compliance_) compliance_ = multiplier([](double k) { return k > 0.0 ? 1.0 / k : 0.0; });
    return *compliance_;
}

const fourier::Multiplier& ElasticOperator::stiffness() {
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
