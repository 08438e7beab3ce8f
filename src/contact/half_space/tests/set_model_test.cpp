// SPDX-License-Identifier: GPL-3.0-or-later
#include "set_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "setae/core/constants.hpp"

namespace setae::half_space {
namespace {

constexpr double modulus = 2e6, nanometre = 1e-9;
constexpr ModelUnits units{.length = 3e-9, .pressure = 1e4};

/// Two thirds of the points at random, gaps of some nanometres there.
struct Given {
    explicit Given(Index points)
        : grid{points, points, 1e-6, 1e-6}, face(points, points), gaps(Array2D::Zero(points, points)) {
        std::mt19937_64 generator(5);
        std::uniform_real_distribution<double> uniform(0.0, 1.0);
        for (Index k = 0; k < face.size(); ++k) {
            face.data()[k] = uniform(generator) < 2.0 / 3.0 ? 1.0 : 0.0;
            gaps.data()[k] = face.data()[k] * nanometre * (1.0 + uniform(generator));
        }
    }
    Grid grid;
    Array2D face, gaps;
};

/// Gaps in the set, less their mean where the load is held.
Array2D centred(const Given& given, const Array2D& gaps, bool load_held) {
    const double mean = load_held ? (given.face * gaps).sum() / given.face.sum() : 0.0;
    return given.face * (gaps - mean);
}

class SetModelOnEdges : public testing::TestWithParam<std::tuple<Edges, bool>> {};

// What the pressures lose closes the gaps, by operators in double; nothing changes outside the set.
TEST_P(SetModelOnEdges, PressureChangeClosesTheGaps) {
    const auto [edges, load_held] = GetParam();
    const Given given(64);
    ElasticOperator response(given.grid, {.contact_modulus = modulus, .layer = {}}, edges, {1}),
        periodic(given.grid, {.contact_modulus = modulus, .layer = {}}, Edges::periodic, {1});
    const auto& preconditioner = edges == Edges::periodic ? response : periodic;
    SetModel model(response, response.compliance(), preconditioner, units, given.face, {1});
    const Array2D residual = centred(given, given.gaps, load_held);
    for (Index i = 0; i < given.face.rows(); ++i) {
        model.face(i) = given.face.row(i).transpose().cast<float>();
        model.residual(i) = (residual.row(i) / units.length).transpose().cast<float>();
    }
    constexpr double reduction = 1e-3;
    const Index iterations = model.reduce({.points = given.face.sum(),
                                           .square = residual.square().sum() / (units.length * units.length),
                                           .load_held = load_held,
                                           .reduction = reduction,
                                           .max_iterations = 200});
    EXPECT_LT(iterations, 60);
    EXPECT_EQ(model.transform_pairs(), 2 * iterations);
    Array2D change(given.face.rows(), given.face.cols()), response_of(given.face.rows(), given.face.cols());
    for (Index i = 0; i < change.rows(); ++i)
        change.row(i) = units.pressure * model.change(i).cast<double>().transpose();
    EXPECT_EQ(((1.0 - given.face) * change).abs().maxCoeff(), 0.0);
    EXPECT_TRUE(!load_held || std::abs(change.sum()) < 1e-5 * change.abs().sum());
    response.displacements(change, response_of);
    const Array2D left = centred(given, given.gaps - response_of, load_held);
    EXPECT_LT(std::sqrt(left.square().sum() / residual.square().sum()), 1.05 * reduction);
    EXPECT_GT(std::sqrt(left.square().sum() / residual.square().sum()), 1e-3 * reduction);
}
INSTANTIATE_TEST_SUITE_P(EveryEdge, SetModelOnEdges,
                         testing::Combine(testing::Values(Edges::periodic, Edges::free, Edges::periodic_along_x),
                                          testing::Bool()));

TEST(SetModel, DoesNothingWithoutResidual) {
    const Given given(16);
    ElasticOperator response(given.grid, {.contact_modulus = modulus, .layer = {}}, Edges::periodic, {1});
    SetModel model(response, response.compliance(), response, units, given.face, {1});
    EXPECT_EQ(model.reduce({.points = 1.0, .square = 0.0}), 0);
    EXPECT_EQ(model.change(0).abs().maxCoeff(), 0.0f);
}

}  // namespace
}  // namespace setae::half_space
