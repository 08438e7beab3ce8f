// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/hard_wall.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "setae/contact/hertz.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::half_space::hard_wall_test {
namespace {

Array2D heights_of(const Grid& grid, const std::function<double(double, double)>& height) {
    Array2D map(grid.nx, grid.ny);
    for (Index i = 0; i < grid.nx; ++i)
        for (Index j = 0; j < grid.ny; ++j)
            map(i, j) = height(static_cast<double>(i) * grid.pixel_x(), static_cast<double>(j) * grid.pixel_y());
    return map;
}

/// H = 0.8 between 16 pixels and a quarter of the map, rms slope 0.1 on average, pixels of 1 m, E* = 1 Pa.
HardWall rough(Index points, double load, std::uint64_t seed = 1) {
    const double size = static_cast<double>(points);
    const auto spectrum = spectra::density(spectra::SelfAffine{1.0, 2.0 * pi / (0.25 * size), 0.8, 2.0 * pi / 16.0});
    const synthesis::SurfaceGrid grid{points, points, size, size};
    const double scale = 0.1 / synthesis::expected_roughness(spectrum, grid).rms_slope;
    return {.grid = {points, points, size, size},
            .body = {.contact_modulus = 1.0, .layer = {}},
            .heights = scale * synthesis::random_surface(spectrum, grid, {.key = {seed}}).heights,
            .control = MeanPressure{load * 0.1},
            .hardness = {}};
}

/// A paraboloid of radius R in the middle of the map.
HardWall sphere(Index points, double size, double radius, Edges edges, const Control& control) {
    HardWall problem{.grid = {points, points, size, size},
                     .body = {.contact_modulus = 5.0, .layer = {}},
                     .edges = edges,
                     .heights = {},
                     .control = control,
                     .hardness = {}};
    const double middle = problem.grid.pixel_x() * static_cast<double>(points / 2);
    problem.heights = heights_of(problem.grid, [&](double x, double y) {
        return -(std::pow(x - middle, 2) + std::pow(y - middle, 2)) / (2.0 * radius);
    });
    return problem;
}

void expect_solved(const HardWall& problem, const HardWallContact& contact) {
    EXPECT_EQ(contact.status, SolveStatus::converged);
    EXPECT_LE(contact.certificate.duality_gap, 1e-8);
    EXPECT_LE(contact.certificate.load_error, 1e-12);
    EXPECT_GE(contact.pressures.minCoeff(), 0.0);
    EXPECT_GE(contact.gaps.minCoeff(), 0.0);
    const double scale = contact.pressures.maxCoeff() * problem.heights.abs().maxCoeff();
    EXPECT_LT((contact.pressures * contact.gaps).maxCoeff(), 1e-6 * scale);
}

/// One wave of amplitude h = 0.01 m and wavelength 1 m at a share of the pressure p* = πE*h/λ of full contact: half the
/// width of contact is a, sin²(πa) the share. Westergaard, J. Appl. Mech. 6 (1939) A49; Johnson, Contact Mechanics
/// (1985), ch. 13.
struct Wave {
    static constexpr double amplitude = 0.01, full_pressure = pi * amplitude;
    double share;
    [[nodiscard]] double width() const { return 2.0 / pi * std::asin(std::sqrt(share)); }
    [[nodiscard]] double mean_gap() const { return amplitude * (1.0 - share + share * std::log(share)); }
    [[nodiscard]] double energy() const {
        return amplitude * full_pressure * (0.25 - 0.5 * std::log(share)) * share * share;
    }
    [[nodiscard]] HardWallContact solved(Index points) const {
        const Grid grid{1, points, 1.0, 1.0};
        const HardWall problem{
            .grid = grid,
            .body = {.contact_modulus = 1.0, .layer = {}},
            .heights = heights_of(grid, [&](double, double y) { return amplitude * std::cos(2.0 * pi * y); }),
            .control = MeanPressure{share * full_pressure},
            .hardness = {}};
        const HardWallContact contact = solve(problem, {.tolerance = 1e-10});
        expect_solved(problem, contact);
        return contact;
    }
};

TEST(HardWall, OnOneWaveMatchesWestergaard) {
    for (const double share : {0.3, 0.5, 0.7}) {
        const Wave wave{share};
        const auto contact = wave.solved(512);
        EXPECT_NEAR(contact.mean_gap / (2.0 * Wave::amplitude), wave.mean_gap() / (2.0 * Wave::amplitude), 2e-6)
            << share;
        const double scale = Wave::amplitude * Wave::full_pressure;
        EXPECT_NEAR(contact.stored_energy / scale, wave.energy() / scale, 2e-6) << share;
        EXPECT_NEAR(contact.area.fraction * 512.0, wave.width() * 512.0, 1.0) << share;
        EXPECT_EQ(contact.area.patches, 1);
    }
}

TEST(HardWall, OnOneWaveConvergesWithThePixelSquared) {
    // where the edge lies within its pixel scatters the error: orders are taken over a factor of 32
    for (const double share : {0.1, 0.7}) {
        const Wave wave{share};
        const auto order = [&](double HardWallContact::*value, double exact) {
            return std::log2(std::abs((wave.solved(64).*value - exact) / (wave.solved(2048).*value - exact))) / 5.0;
        };
        EXPECT_GT(order(&HardWallContact::mean_gap, wave.mean_gap()), 1.5);
        EXPECT_GT(order(&HardWallContact::stored_energy, wave.energy()), 1.5);
    }
}

// h = Δ cos cos, two crests a square of side λ: full contact at p* = √2 π E* Δ/λ, and Hertz on each crest, of curvature
// Δ (2π/λ)², under little (Johnson, Greenwood, Higginson, Int. J. Mech. Sci. 27 (1985) 383)
TEST(HardWall, OfAnEggBoxIsHertzianAtLowAndFullAtHighLoad) {
    constexpr Index n = 256;
    constexpr double height = 0.01, full = std::numbers::sqrt2 * pi * height;
    const Array2D heights = Array2D::NullaryExpr(n, n, [](Index i, Index j) {
        return height * std::cos(2.0 * pi * static_cast<double>(i) / n) *
               std::cos(2.0 * pi * static_cast<double>(j) / n);
    });
    const auto at = [&](double pressure) {
        return solve(
            {.grid = {n, n, 1.0, 1.0}, .body = {1.0, {}}, .heights = heights, .control = MeanPressure{pressure}});
    };
    EXPECT_EQ(at(1.001 * full).area.fraction, 1.0);
    const double nearly = at(0.98 * full).area.fraction;
    EXPECT_LT(nearly, 1.0);
    EXPECT_GT(nearly, 0.9);
    constexpr double light = 0.01 * full, crest_radius = 1.0 / (height * 4.0 * pi * pi);
    const double a = std::cbrt(0.75 * 0.5 * light * crest_radius);
    EXPECT_NEAR(at(light).area.corrected_fraction / (2.0 * pi * a * a), 1.0, 0.03);
}

TEST(HardWall, OfASphereIsHertz) {
    // E* = 5, R = 4, F = 7: a = 1.6134286460245437, d = 0.6507879989531481, p0 = 1.2839257217043503
    constexpr double size = 8.0, force = 7.0;
    const auto free = sphere(128, size, 4.0, Edges::free, MeanPressure{force / (size * size)});
    const auto contact = solve(free);
    expect_solved(free, contact);
    EXPECT_NEAR(contact.displacement / 0.6507879989531481, 1.0, 1e-3);
    EXPECT_NEAR(contact.pressures.maxCoeff() / 1.2839257217043503, 1.0, 1e-3);
    EXPECT_NEAR(contact.area.fraction * size * size / (pi * std::pow(1.6134286460245437, 2)), 1.0, 5e-3);
    EXPECT_NEAR(contact.stored_energy / contact::hertz::energy(0.6507879989531481, {4.0, 5.0}), 1.0, 1e-3);
    // pressed as far, it carries as much
    const auto again = solve(sphere(128, size, 4.0, Edges::free, Displacement{contact.displacement}));
    EXPECT_EQ(again.status, SolveStatus::converged);
    EXPECT_NEAR(again.mean_pressure * size * size / force, 1.0, 1e-7);
}

/// Means over loads and places of the sphere within a pixel of the errors of Hertz's contact, relative.
struct HertzErrors {
    double displacement = 0.0, peak = 0.0, area = 0.0, corrected_area = 0.0;
};

HertzErrors hertz_errors(Index points) {
    HertzErrors errors;
    const double size = 5.0;
    for (const double force : {5.0, 6.5, 8.0})
        for (const double shift : {0.0, 0.31}) {
            auto problem = sphere(points, size, 4.0, Edges::free, MeanPressure{force / (size * size)});
            const double middle = problem.grid.pixel_x() * (static_cast<double>(points / 2) + shift);
            problem.heights = heights_of(problem.grid, [&](double x, double y) {
                return -(std::pow(x - middle, 2) + std::pow(y - middle, 2)) / 8.0;
            });
            const auto contact = solve(problem);
            const double radius = contact::hertz::contact_radius(force, {4.0, 5.0}), area = pi * radius * radius;
            // the top of the sphere may lie between pixels
            const double displacement = contact.displacement - problem.heights.maxCoeff();
            errors.displacement += std::abs(displacement * 4.0 / (radius * radius) - 1.0) / 6.0;
            errors.peak += std::abs(contact.pressures.maxCoeff() * area / (1.5 * force) - 1.0) / 6.0;
            errors.area += (contact.area.fraction * size * size / area - 1.0) / 6.0;
            errors.corrected_area += (contact.area.corrected_fraction * size * size / area - 1.0) / 6.0;
        }
    return errors;
}

TEST(HardWall, OfASphereConvergesWithThePixelSquared) {
    const HertzErrors coarse = hertz_errors(16), fine = hertz_errors(128);
    EXPECT_GT(std::log2(coarse.displacement / fine.displacement) / 3.0, 1.7);
    EXPECT_GT(std::log2(coarse.peak / fine.peak) / 3.0, 1.7);
    EXPECT_LT(fine.displacement, 5e-5);
    EXPECT_LT(fine.peak, 5e-5);
    // areas with the pixel; the correction leaves less than half of it
    EXPECT_NEAR(std::log2(coarse.area / fine.area) / 3.0, 1.0, 0.3);
    EXPECT_LT(std::abs(fine.corrected_area), 0.5 * fine.area);
}

TEST(HardWall, CorrectedAreaMatchesFinerPixels) {
    // the same surface, its shortest wave on 8, 16 and 32 pixels
    double area[3], corrected[3], gap[3];
    const auto spectrum = spectra::density(spectra::SelfAffine{1.0, 2.0 * pi / 32.0, 0.8, 2.0 * pi / 8.0});
    for (const Index doubling : {0, 1, 2}) {
        const Index points = 64 << doubling;
        const synthesis::SurfaceGrid grid{points, points, 64.0, 64.0};
        const double scale = 0.1 / synthesis::expected_roughness(spectrum, grid).rms_slope;
        const auto contact = solve({.grid = {points, points, 64.0, 64.0},
                                    .body = {.contact_modulus = 1.0, .layer = {}},
                                    .heights = scale * synthesis::random_surface(spectrum, grid, {.key = {2}}).heights,
                                    .control = MeanPressure{0.005},
                                    .hardness = {}});
        area[doubling] = contact.area.fraction;
        corrected[doubling] = contact.area.corrected_fraction;
        gap[doubling] = contact.mean_gap;
    }
    EXPECT_NEAR(corrected[0] / corrected[2], 1.0, 0.25 * (area[0] / area[2] - 1.0));
    EXPECT_NEAR(corrected[1] / corrected[2], 1.0, 0.01);
    EXPECT_NEAR(gap[0] / gap[2], 1.0, 2e-3);
}

TEST(HardWall, OfASphereInALargePeriodicBoxIsHertz) {
    const auto contact = solve(sphere(512, 32.0, 4.0, Edges::periodic, MeanPressure{7.0 / (32.0 * 32.0)}));
    EXPECT_EQ(contact.status, SolveStatus::converged);
    EXPECT_NEAR(contact.pressures.maxCoeff() / 1.2839257217043503, 1.0, 5e-3);
    EXPECT_NEAR(contact.area.fraction * 1024.0 / (pi * std::pow(1.6134286460245437, 2)), 1.0, 1e-2);
}

TEST(HardWall, OfAFlatPunchHasStiffnessOfTwiceItsRadius) {
    // F/d = 2aE*; the punch's area in pixels stands for a
    const auto stiffness = [](Index points) {
        HardWall problem{.grid = {points, points, 5.0, 5.0},
                         .body = {.contact_modulus = 3.0, .layer = {}},
                         .edges = Edges::free,
                         .heights = {},
                         .control = MeanPressure{1e-3},
                         .hardness = {}};
        const double middle = problem.grid.pixel_x() * 0.5 * static_cast<double>(points - 1);
        problem.heights = heights_of(
            problem.grid, [&](double x, double y) { return std::hypot(x - middle, y - middle) < 2.0 ? 0.0 : -10.0; });
        const auto contact = solve(problem);
        EXPECT_EQ(contact.status, SolveStatus::converged);
        const double radius = std::sqrt(contact.area.fraction * 25.0 / pi);
        const double secant = contact.mean_pressure * 25.0 / contact.displacement;
        EXPECT_NEAR(contact_stiffness(problem, contact) * 25.0 / secant, 1.0, 1e-7);
        return secant / (2.0 * radius * 3.0);
    };
    EXPECT_NEAR(stiffness(127), 1.0, 5e-3);
    EXPECT_NEAR(stiffness(256), 1.0, 5e-3);
}

TEST(HardWall, AreaAndGapMatchAnIndependentSolver) {
    // κ = A h' E*/(p A0) of this spectrum at 512 points: 2.263 (p = 0.05 h'E*), 2.135 (0.1), 1.743 (0.3), 1.354 (0.6)
    // of one surface; mean gaps .90, .58, .165, .029 h_rms
    struct Reference {
        double load, kappa, gap;
    };
    for (const auto& [load, kappa, gap] : {Reference{0.05, 2.263, 0.9013}, {0.3, 1.743, 0.1651}}) {
        double kappas = 0.0, squares = 0.0, gaps = 0.0;
        constexpr int seeds = 4;
        for (int seed = 1; seed <= seeds; ++seed) {
            const auto problem = rough(256, load, static_cast<std::uint64_t>(seed));
            const auto contact = solve(problem);
            expect_solved(problem, contact);
            const double value = contact.area.fraction / load;
            kappas += value / seeds;
            squares += value * value / seeds;
            gaps += contact.mean_gap / std::sqrt(problem.heights.square().mean()) / seeds;
        }
        const double spread = std::sqrt(squares - kappas * kappas);
        EXPECT_NEAR(kappas, kappa, 3.0 * spread) << load;
        EXPECT_NEAR(gaps, gap, 0.15 * gap + 0.02) << load;
    }
}

TEST(HardWall, IsTheSameUnderPressureGapOrDisplacementControl) {
    auto problem = rough(128, 0.1);
    const auto by_pressure = solve(problem);
    problem.control = MeanGap{by_pressure.mean_gap};
    const auto by_gap = solve(problem);
    problem.control = Displacement{by_pressure.displacement};
    const auto by_displacement = solve(problem);
    for (const auto& contact : {by_gap, by_displacement}) {
        EXPECT_EQ(contact.status, SolveStatus::converged);
        EXPECT_LE(contact.certificate.level_error, 1e-8);
        EXPECT_NEAR(contact.mean_pressure / by_pressure.mean_pressure, 1.0, 1e-6);
        EXPECT_NEAR(contact.stored_energy / by_pressure.stored_energy, 1.0, 1e-6);
        EXPECT_NEAR(contact.area.fraction, by_pressure.area.fraction, 1e-3);
    }
}

TEST(HardWall, HasNoHysteresisAfterAHigherLoad) {
    const auto problem = rough(128, 0.05);
    const auto there = solve(rough(128, 0.2)), direct = solve(problem, {.tolerance = 1e-10});
    const auto back = solve(problem, {.tolerance = 1e-10, .start = there.pressures});
    expect_solved(problem, back);
    EXPECT_LT((back.pressures - direct.pressures).abs().maxCoeff(), 1e-6 * direct.pressures.maxCoeff());
    EXPECT_NEAR(back.stored_energy / direct.stored_energy, 1.0, 1e-10);
    EXPECT_EQ(back.area.fraction, direct.area.fraction);
}

TEST(HardWall, StiffnessIsTheSlopeOfLoadOverGap) {
    auto problem = rough(128, 0.1);
    const auto contact = solve(problem);
    constexpr double step = 1e-4;
    problem.control = MeanPressure{0.01 * (1.0 + step)};
    const auto more = solve(problem);
    const double slope = 0.01 * step / (contact.mean_gap - more.mean_gap);
    EXPECT_NEAR(contact_stiffness(problem, contact) / slope, 1.0, 1e-2);
}

TEST(HardWall, IsIndependentOfUnits) {
    auto problem = rough(128, 0.05);
    const auto plain = solve(problem);
    problem.grid.size_x *= 1e-9;
    problem.grid.size_y *= 1e-9;
    problem.heights *= 1e-9;
    problem.body.contact_modulus = 1e9;
    problem.control = MeanPressure{0.005e9};
    const auto scaled = solve(problem);
    EXPECT_LT((scaled.pressures * 1e-9 - plain.pressures).abs().maxCoeff(), 1e-7 * plain.pressures.maxCoeff());
    EXPECT_LT((scaled.gaps * 1e9 - plain.gaps).abs().maxCoeff(), 1e-7 * plain.gaps.maxCoeff());
    EXPECT_EQ(scaled.area.patches, plain.area.patches);
}

TEST(HardWall, GivesTheSameBytesOnAnyNumberOfThreads) {
    const auto problem = rough(256, 0.05);
    const auto one = solve(problem, {.threads = {1}}), two = solve(problem, {.threads = {2}});
    EXPECT_TRUE((one.pressures == two.pressures).all());
    EXPECT_TRUE((one.gaps == two.gaps).all());
    EXPECT_EQ(one.certificate.duality_gap, two.certificate.duality_gap);
}

TEST(HardWall, DoesNotDependOnCoarserGrids) {
    const auto problem = rough(128, 0.1);
    const auto nested = solve(problem), alone = solve(problem, {.nested_grids = false});
    EXPECT_LT((nested.pressures - alone.pressures).abs().maxCoeff(), 1e-5 * alone.pressures.maxCoeff());
    EXPECT_LT((nested.gaps - alone.gaps).abs().maxCoeff(), 1e-6 * alone.gaps.maxCoeff());
}

TEST(HardWall, HandlesOddSidesAndNonSquarePixels) {
    // the same surface with twice the points along y
    const auto height = [](double x, double y) {
        return std::cos(2.0 * pi * x) + 0.5 * std::cos(2.0 * pi * (y - x)) + 0.3 * std::sin(4.0 * pi * y);
    };
    const auto solved = [&](Index nx, Index ny) {
        const Grid grid{nx, ny, 1.0, 1.0};
        const HardWall problem{.grid = grid,
                               .body = {.contact_modulus = 1.0, .layer = {}},
                               .heights = heights_of(grid, height),
                               .control = MeanPressure{1.0},
                               .hardness = {}};
        const auto contact = solve(problem);
        expect_solved(problem, contact);
        return contact;
    };
    const auto odd = solved(135, 81), even = solved(128, 256);
    EXPECT_NEAR(odd.mean_gap / even.mean_gap, 1.0, 2e-3);
    EXPECT_NEAR(odd.stored_energy / even.stored_energy, 1.0, 2e-3);
    EXPECT_NEAR(odd.area.corrected_fraction / even.area.corrected_fraction, 1.0, 2e-2);
}

TEST(HardWall, PressureIsLimitedByTheHardness) {
    auto problem = rough(128, 0.1);
    problem.hardness = 0.03;  // 0.3 h'E*; the elastic peak is higher
    ASSERT_GT(solve(rough(128, 0.1)).pressures.maxCoeff(), 0.05);
    const auto contact = solve(problem);
    EXPECT_EQ(contact.status, SolveStatus::converged);
    EXPECT_LE(contact.pressures.maxCoeff(), 0.03);
    EXPECT_NEAR(contact.mean_pressure / 0.01, 1.0, 1e-12);
    EXPECT_GT(contact.flowing_area, 0.0);
    EXPECT_GT(contact.deepest_dent, 0.0);
    EXPECT_GE(contact.area.fraction, 0.01 / 0.03);
    // far above every pressure it changes nothing
    problem.hardness = 10.0;
    const auto hard = solve(problem), elastic = solve(rough(128, 0.1));
    EXPECT_NEAR(hard.mean_gap / elastic.mean_gap, 1.0, 1e-7);
    EXPECT_EQ(hard.flowing_area, 0.0);
}

TEST(HardWall, ConvergesOnWhiteNoise) {
    // neighbouring pixels are independent: guesses of the set fail, and the careful mode must finish
    for (const double load : {0.02, 0.2, 0.5}) {
        HardWall problem{.grid = {128, 128, 128.0, 128.0},
                         .body = {.contact_modulus = 1.0, .layer = {}},
                         .heights = Array2D(128, 128),
                         .control = MeanPressure{load},
                         .hardness = {}};
        Eigen::Map<Array1D>(problem.heights.data(), 128 * 128) = numerics::normal_numbers({7}, 0, 128 * 128);
        const auto contact = solve(problem);
        expect_solved(problem, contact);
    }
}

TEST(HardWall, FullContactHasTheEnergyOfTheSurface) {
    auto problem = rough(128, 3.0);
    const auto contact = solve(problem);
    expect_solved(problem, contact);
    EXPECT_EQ(contact.area.fraction, 1.0);
    EXPECT_EQ(contact.area.perimeter, 0.0);
    EXPECT_LT(contact.mean_gap, 1e-7 * problem.heights.maxCoeff());
    ElasticOperator response(problem.grid, problem.body);
    EXPECT_NEAR(contact.stored_energy / response.energy_of_displacements(problem.heights), 1.0, 1e-7);
    EXPECT_TRUE(std::isinf(contact_stiffness(problem, contact)));
}

TEST(HardWall, OfAFlatIsFullContact) {
    HardWall problem{.grid = {16, 16, 1.0, 1.0},
                     .body = {.contact_modulus = 1.0, .layer = Layer{.thickness = 0.1, .poisson_ratio = 0.3}},
                     .heights = Array2D::Zero(16, 16),
                     .control = MeanPressure{0.01},
                     .hardness = {}};
    const auto contact = solve(problem);
    EXPECT_EQ(contact.status, SolveStatus::converged);
    EXPECT_LT((contact.pressures / 0.01 - 1.0).abs().maxCoeff(), 1e-12);
    const double k = stiffness(0.0, problem.body);
    EXPECT_NEAR(contact.displacement * k / 0.01, 1.0, 1e-12);
    EXPECT_NEAR(contact.stored_energy * 2.0 * k / 1e-4, 1.0, 1e-12);
    EXPECT_NEAR(contact_stiffness(problem, contact) / k, 1.0, 1e-12);
}

TEST(HardWall, OfALayerFollowsTheDisplacementOfItsBase) {
    auto problem = rough(128, 0.1);
    problem.body.layer = Layer{.thickness = 10.0, .poisson_ratio = 0.4};
    const auto by_pressure = solve(problem);
    expect_solved(problem, by_pressure);
    problem.control = Displacement{by_pressure.displacement};
    const auto by_displacement = solve(problem);
    EXPECT_NEAR(by_displacement.mean_pressure / by_pressure.mean_pressure, 1.0, 1e-6);
    problem.control = MeanGap{by_pressure.mean_gap};
    const auto by_gap = solve(problem);
    EXPECT_NEAR(by_gap.mean_pressure / by_pressure.mean_pressure, 1.0, 1e-6);
    EXPECT_NEAR(by_gap.displacement / by_pressure.displacement, 1.0, 1e-6);
    EXPECT_NEAR(by_gap.stored_energy / by_pressure.stored_energy, 1.0, 1e-6);
    problem.body.layer->poisson_ratio = 0.5;
    problem.control = MeanPressure{0.01};
    const auto incompressible = solve(problem);
    expect_solved(problem, incompressible);
    EXPECT_EQ(incompressible.mean_displacement, MeanDisplacement::blocked);
    EXPECT_GT(incompressible.mean_gap, by_pressure.mean_gap);
}

TEST(HardWall, WithoutContactHasNoPressure) {
    auto problem = rough(128, 0.1);
    problem.control = Displacement{-1.0};
    const auto contact = solve(problem);
    EXPECT_EQ(contact.status, SolveStatus::converged);
    EXPECT_EQ(contact.mean_pressure, 0.0);
    EXPECT_NEAR(contact.gaps.minCoeff(), 1.0, 1e-12);
    EXPECT_EQ(contact_stiffness(problem, contact), 0.0);
}

TEST(HardWall, WithTooFewIterationsIsNotConverged) {
    const auto contact = solve(rough(128, 0.1), {.max_iterations = 2, .nested_grids = false});
    EXPECT_EQ(contact.status, SolveStatus::not_converged);
    EXPECT_GT(contact.certificate.duality_gap, 1e-8);
}

TEST(HardWall, RefusesProblemsWithoutSolution) {
    const auto refused = [](const std::function<void(HardWall&)>& spoil) {
        auto problem = rough(128, 0.1);
        spoil(problem);
        EXPECT_THROW((void)solve(problem), InvalidArgument);
    };
    refused([](HardWall& p) { p.hardness = 0.005; });
    refused([](HardWall& p) { p.hardness = -1.0; });
    refused([](HardWall& p) { p.heights(3, 4) = std::numeric_limits<double>::quiet_NaN(); });
    refused([](HardWall& p) { p.control = MeanPressure{0.0}; });
    refused([](HardWall& p) { p.control = MeanGap{0.0}; });
    refused([](HardWall& p) { p.control = Displacement{100.0}; });
    refused([](HardWall& p) { p.edges = Edges::free; });  // touches the rim
    refused([](HardWall& p) {
        p.edges = Edges::free;
        p.control = MeanGap{1.0};
    });
    refused([](HardWall& p) { p.heights.resize(128, 127); });
    refused([](HardWall& p) { p.body.contact_modulus = 0.0; });
    EXPECT_THROW((void)solve(rough(128, 0.1), {.start = Array2D::Zero(128, 128)}), InvalidArgument);
    EXPECT_THROW((void)solve(rough(128, 0.1), {.start = Array2D::Ones(64, 128)}), InvalidArgument);
}

}  // namespace
}  // namespace setae::half_space::hard_wall_test
