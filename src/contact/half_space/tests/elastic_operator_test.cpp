// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/elastic_operator.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "pixel_kernels.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::half_space::elastic_operator_test {
namespace {

constexpr Body rubber{.contact_modulus = 2.0e6, .layer = {}};

Array2D noise(const Grid& grid, std::uint64_t seed) {
    Array2D map(grid.nx, grid.ny);
    Eigen::Map<Array1D>(map.data(), map.size()) = numerics::normal_numbers({seed}, 0, grid.points());
    return map;
}

Array2D wave(const Grid& grid, Index kx, Index ky) {
    Array2D map(grid.nx, grid.ny);
    for (Index i = 0; i < grid.nx; ++i)
        for (Index j = 0; j < grid.ny; ++j)
            map(i, j) = std::cos(2.0 * pi *
                                 (static_cast<double>(i * kx) / static_cast<double>(grid.nx) +
                                  static_cast<double>(j * ky) / static_cast<double>(grid.ny)));
    return map;
}

TEST(ElasticOperator, RespondsToAWaveWithItsStiffness) {
    const Grid grid{24, 15, 3e-6, 2e-6};  // an even and an odd side, pixels that are not square
    ElasticOperator half_space(grid, rubber);
    for (const auto& [kx, ky] : {std::pair<Index, Index>{1, 0}, {0, 1}, {3, -5}, {12, 0}, {11, 7}}) {
        const Array2D p = wave(grid, kx, ky);
        Array2D u(grid.nx, grid.ny), back(grid.nx, grid.ny);
        half_space.displacements(p, u);
        const double q = 2.0 * pi * std::hypot(static_cast<double>(kx) / 3e-6, static_cast<double>(ky) / 2e-6);
        // phases up to 140 rad are rounded to 1e-14, and the longest wave answers 12 times as much
        EXPECT_LT((u - p / (1.0e6 * q)).abs().maxCoeff() * 1.0e6 * q, 1e-13);
        half_space.pressures(u, back);
        EXPECT_LT((back - p).abs().maxCoeff(), 1e-13);
    }
}

TEST(ElasticOperator, StoresTheSameEnergyInRealAndInFourierSpace) {
    const Layer rubbery{.thickness = 1e-6, .poisson_ratio = 0.45};
    for (const Body& body : {rubber, Body{.contact_modulus = 2e6, .layer = rubbery}})
        for (const Grid& grid : {Grid{32, 32, 1e-6, 1e-6}, Grid{31, 17, 3e-6, 1e-6}, Grid{64, 1, 1e-6, 1e-6}}) {
            ElasticOperator response(grid, body);
            const Array2D p = noise(grid, 1);
            Array2D u(grid.nx, grid.ny);
            response.displacements(p, u);
            const double energy = stored_energy(p, u, grid);
            EXPECT_NEAR(response.energy_of_pressures(p) / energy, 1.0, 1e-12);
            EXPECT_NEAR(response.energy_of_displacements(u) / energy, 1.0, 1e-12);
        }
}

TEST(ElasticOperator, WithFreeEdgesSumsOverPixels) {
    for (const Grid& grid : {Grid{12, 9, 3e-6, 1e-6}, Grid{7, 16, 1e-6, 1e-6}}) {
        ElasticOperator response(grid, rubber, Edges::free);
        const Array2D p = noise(grid, 2);
        Array2D u(grid.nx, grid.ny);
        response.displacements(p, u);
        double error = 0.0;
        for (Index i = 0; i < grid.nx; ++i)
            for (Index j = 0; j < grid.ny; ++j) {
                double sum = 0.0;
                for (Index k = 0; k < grid.nx; ++k)
                    for (Index m = 0; m < grid.ny; ++m)
                        sum += p(k, m) * rectangle_displacement(static_cast<double>(i - k) * grid.pixel_x(),
                                                                static_cast<double>(j - m) * grid.pixel_y(),
                                                                {0.5 * grid.pixel_x(), 0.5 * grid.pixel_y()});
                error = std::max(error, std::abs(u(i, j) - sum / 2e6));
            }
        EXPECT_LT(error, 1e-14 * u.abs().maxCoeff());
        EXPECT_NEAR(response.energy_of_pressures(p) / stored_energy(p, u, grid), 1.0, 1e-12);
        EXPECT_EQ(response.mean_displacement(), MeanDisplacement::finite);
    }
}

TEST(ElasticOperator, PeriodicAlongOneAxisSumsOverStrips) {
    const Grid grid{9, 16, 2e-6, 3e-6}, turned{16, 9, 3e-6, 2e-6};
    ElasticOperator along_x(grid, rubber, Edges::periodic_along_x), along_y(turned, rubber, Edges::periodic_along_y);
    const Array2D p = noise(grid, 4);
    Array2D u(grid.nx, grid.ny), v(turned.nx, turned.ny);
    along_x.displacements(p, u);
    along_y.displacements(p.transpose(), v);
    EXPECT_LT((u - v.transpose()).abs().maxCoeff(), 1e-14 * u.abs().maxCoeff());
    EXPECT_NEAR(along_x.energy_of_pressures(p) / stored_energy(p, u, grid), 1.0, 1e-12);
    // one wave along x on one row
    Array2D row = Array2D::Zero(grid.nx, grid.ny);
    row.col(5) = wave(grid, 2, 0).col(0);
    along_x.displacements(row, u);
    const double q = 2.0 * 2.0 * pi / grid.size_x;
    for (Index j = 0; j < grid.ny; ++j) {
        const double amplitude =
            strip_displacement(q, static_cast<double>(j - 5) * grid.pixel_y(), 0.5 * grid.pixel_y(), grid.size_x) / 2e6;
        EXPECT_LT((u.col(j) - amplitude * row.col(5)).abs().maxCoeff(), 1e-20);
    }
    EXPECT_EQ(along_x.mean_displacement(), MeanDisplacement::undefined);
}

TEST(ElasticOperator, OfALineContactFollowsTheLogarithm) {
    // a line force q on a plane: u = −(2q/πE*) ln r + constant; a pixel of it, over its own width
    const Grid line{1, 64, 1.0, 64e-6};
    ElasticOperator response(line, rubber, Edges::periodic_along_x);
    Array2D p = Array2D::Zero(1, 64), u(1, 64);
    p(0, 0) = 1e6;
    response.displacements(p, u);
    EXPECT_NEAR((u(0, 20) - u(0, 60)) / (2.0 * 1.0 / (pi * 2e6) * std::log(3.0)), 1.0, 2e-4);  // (1/24)(1/20)²/ln 3
}

TEST(ElasticOperator, HandlesTheMeanByTypeOfBody) {
    const Grid grid{8, 8, 1e-6, 1e-6};
    const Array2D uniform = Array2D::Constant(8, 8, 5.0);
    Array2D u(8, 8);
    const auto answer = [&](const Body& body) {
        ElasticOperator response(grid, body);
        response.displacements(uniform, u);
        return response.mean_displacement();
    };
    EXPECT_EQ(answer(rubber), MeanDisplacement::undefined);
    EXPECT_LT(u.abs().maxCoeff(), 1e-20);
    EXPECT_EQ(answer({.contact_modulus = 2e6, .layer = Layer{.thickness = 1e-7, .poisson_ratio = 0.5}}),
              MeanDisplacement::blocked);
    EXPECT_LT(u.abs().maxCoeff(), 1e-20);
    EXPECT_EQ(answer({.contact_modulus = 2e6, .layer = Layer{.thickness = 1e-7, .poisson_ratio = 0.3}}),
              MeanDisplacement::finite);
    // E = 1.82 MPa, oedometer E (1 − ν)/((1 + ν)(1 − 2ν)) = 2.45 MPa
    EXPECT_LT((u / (5.0 * 1e-7 / 2.45e6) - 1.0).abs().maxCoeff(), 1e-13);
}

TEST(ElasticOperator, GivesMinimumAndMaximumStiffness) {
    ElasticOperator response({64, 32, 1e-6, 2e-6}, rubber);
    EXPECT_NEAR(response.min_stiffness() / (1e6 * pi / 1e-6), 1.0, 1e-15);
    EXPECT_NEAR(response.greatest_stiffness() / (1e6 * pi * std::hypot(64e6, 16e6)), 1.0, 1e-15);
    ElasticOperator line({1, 32, 1.0, 1e-6}, rubber);
    EXPECT_NEAR(line.min_stiffness() / (1e6 * 2e6 * pi), 1.0, 1e-15);
    EXPECT_NEAR(line.greatest_stiffness() / (1e6 * 32e6 * pi), 1.0, 1e-15);
}

TEST(ElasticOperator, GivesTheSameBytesOnAnyNumberOfThreads) {
    const Grid grid{150, 256, 1e-6, 1e-6};
    const Array2D p = noise(grid, 3);
    Array2D one(grid.nx, grid.ny), three = p;
    ElasticOperator alone(grid, rubber, Edges::periodic, {1}), crew(grid, rubber, Edges::periodic, {3});
    alone.displacements(p, one);
    crew.displacements(three, three);  // in place
    EXPECT_TRUE((one == three).all());
    EXPECT_EQ(alone.energy_of_pressures(p), crew.energy_of_pressures(p));
}

TEST(ElasticOperator, RefusesInvalidGridsAndShapes) {
    EXPECT_THROW(ElasticOperator({0, 8, 1e-6, 1e-6}, rubber), InvalidArgument);
    EXPECT_THROW(ElasticOperator({8, 8, 1e-6, 0.0}, rubber), InvalidArgument);
    EXPECT_THROW(ElasticOperator({8, 8, 1e-6, 1e-6}, Body{.contact_modulus = -1.0, .layer = {}}), InvalidArgument);
    ElasticOperator response({8, 8, 1e-6, 1e-6}, rubber);
    Array2D wrong(8, 7), right(8, 8);
    EXPECT_THROW(response.displacements(wrong, right), InvalidArgument);
    EXPECT_THROW((void)stiffness(-1.0, rubber), InvalidArgument);
    const Body layer{.contact_modulus = 2e6, .layer = Layer{.thickness = 1e-7}};
    EXPECT_THROW(ElasticOperator({8, 8, 1e-6, 1e-6}, layer, Edges::free), InvalidArgument);
    EXPECT_THROW(ElasticOperator({1, 8, 1e-6, 1e-6}, rubber, Edges::free), InvalidArgument);
    ElasticOperator free({8, 8, 1e-6, 1e-6}, rubber, Edges::free);
    EXPECT_THROW(free.pressures(right, right), InvalidArgument);
}

TEST(Stiffness, OfALayerHasThePublishedFactors) {
    const auto factor = [](double x, double nu, Base base = Base::bonded) {
        return stiffness(x, {.contact_modulus = 2.0, .layer = Layer{1.0, nu, base}}) / x;
    };
    // closed form of Carbone and Mangialardi (2008), evaluated with 30 digits
    EXPECT_NEAR(factor(0.01, 0.3) / 244.99825, 1.0, 1e-7);
    EXPECT_NEAR(factor(0.1, 0.3) / 24.48277, 1.0, 1e-6);
    EXPECT_NEAR(factor(1.0, 0.3) / 2.405281, 1.0, 1e-6);
    EXPECT_NEAR(factor(5.0, 0.3) / 1.0031352, 1.0, 1e-7);
    EXPECT_NEAR(factor(0.1, 0.5) / 1526.99317, 1.0, 1e-8);
    EXPECT_NEAR(factor(1.0, 0.5) / 4.1565925, 1.0, 1e-7);
    EXPECT_NEAR(factor(5.0, 0.5) / 1.0055438, 1.0, 1e-7);
    // without friction: E*/t for long waves, a half-space for short ones
    EXPECT_NEAR(factor(1e-3, 0.3, Base::frictionless) * 0.5e-3, 1.0, 1e-6);
    EXPECT_EQ(factor(400.0, 0.3, Base::frictionless), 1.0);
}

/// Stiffness of a layer t = 1 by the stress function φ = (A ch + B sh + C z ch + D z sh) cos qx, ch = cosh qz, at unit
/// pressure on z = 1: four boundary conditions, solved as they stand.
double stiffness_by_stress_function(double q, double nu, Base base) {
    const double shear_modulus = 0.5 * (1.0 - nu);  // E* = 1
    const auto terms = [&](double z) {
        const double ch = std::cosh(q * z), sh = std::sinh(q * z);
        // φ, φ', φ'', φ''' of the four terms
        return (Eigen::Matrix4d() << ch, sh, z * ch, z * sh,                                           //
                q * sh, q * ch, ch + q * z * sh, sh + q * z * ch,                                      //
                q * q * ch, q * q * sh, 2.0 * q * sh + q * q * z * ch, 2.0 * q * ch + q * q * z * sh,  //
                q * q * q * sh, q * q * q * ch, q * q * (3.0 * ch + q * z * sh), q * q * (3.0 * sh + q * z * ch))
            .finished();
    };
    // σ_zz = −q² φ, τ ∝ φ', 2Gq u_x = −((1 − ν) φ'' + ν q² φ), 2Gq² u_z = (1 − ν) φ''' − (2 − ν) q² φ'
    const auto along = [&](const Eigen::Matrix4d& t) { return ((1.0 - nu) * t.row(2) + nu * q * q * t.row(0)).eval(); };
    const auto normal = [&](const Eigen::Matrix4d& t) {
        return ((1.0 - nu) * t.row(3) - (2.0 - nu) * q * q * t.row(1)).eval();
    };
    const Eigen::Matrix4d top = terms(1.0), bottom = terms(0.0);
    Eigen::Matrix4d conditions;
    conditions << -q * q * top.row(0), top.row(1), normal(bottom), base == Base::bonded ? along(bottom) : bottom.row(1);
    const Eigen::Vector4d coefficients = conditions.fullPivLu().solve(Eigen::Vector4d(-1.0, 0.0, 0.0, 0.0));
    return -2.0 * shear_modulus * q * q / normal(top).dot(coefficients);
}

TEST(Stiffness, OfALayerSolvesTheBoundaryConditions) {
    for (const Base base : {Base::bonded, Base::frictionless})
        for (const double nu : {-0.5, 0.0, 0.3, 0.49, 0.5})
            for (const double q : {0.3, 1.0, 3.0})
                EXPECT_NEAR(stiffness(q, {.contact_modulus = 1.0, .layer = Layer{1.0, nu, base}}) /
                                stiffness_by_stress_function(q, nu, base),
                            1.0, 1e-10)
                    << q << ' ' << nu;
}

}  // namespace
}  // namespace setae::half_space::elastic_operator_test
