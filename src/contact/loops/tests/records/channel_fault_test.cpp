// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <vector>

#include "setae/loops/channel_fault.hpp"
#include "setae/loops/segments.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::channel_fault_test {
namespace {

/// A record of a stage that comes and goes at one speed.
Loop record(std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    const Loop uneven = tests::SyntheticLoop{.retraction_work = 0.06, .samples = 400}.make();
    Loop loop;
    Index turn = 0;
    const double deepest = uneven.displacement.maxCoeff(&turn), step = deepest / 150.0;
    std::vector<double> force, displacement;
    double next = uneven.displacement[0];
    for (Index i = 0; i <= turn; ++i)
        if (uneven.displacement[i] >= next) {
            force.push_back(uneven.force[i]);
            displacement.push_back(uneven.displacement[i]);
            next += step;
        }
    next = deepest - step;
    for (Index i = turn; i < uneven.force.size(); ++i)
        if (uneven.displacement[i] <= next) {
            force.push_back(uneven.force[i]);
            displacement.push_back(uneven.displacement[i]);
            next -= step;
        }
    const auto n = static_cast<Index>(force.size());
    loop.time = 0.1 * Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1));
    loop.force = tests::with_noise(Eigen::Map<const Array1D>(force.data(), n), 1e-6, generator);
    loop.displacement = Eigen::Map<const Array1D>(displacement.data(), n);
    return loop;
}

std::optional<ChannelFault> fault_of(const Loop& loop) {
    try {
        (void)find_segments(loop);
    } catch (const ChannelFaultError& error) {
        return error.fault();
    } catch (const UndefinedDataError&) {
        return std::nullopt;
    }
    return std::nullopt;
}

TEST(ChannelFault, IsReportedForWrongSignsAndSwappedColumns) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Loop right = record(seed);
        EXPECT_FALSE(fault_of(right)) << seed;
        Loop wrong = right;
        wrong.force *= -1.0;
        EXPECT_EQ(fault_of(wrong), ChannelFault::force_reversed) << seed;
        wrong.displacement *= -1.0;
        EXPECT_EQ(fault_of(wrong), ChannelFault::both_reversed) << seed;
        wrong.force = right.force;
        EXPECT_EQ(fault_of(wrong), ChannelFault::displacement_reversed) << seed;
        wrong = right;
        std::swap(wrong.force, wrong.displacement);
        EXPECT_EQ(fault_of(wrong), ChannelFault::swapped) << seed;
    }
}

TEST(ChannelFault, IsNotReportedForDriftOnly) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        std::mt19937_64 generator(seed);
        Loop loop = record(seed);
        loop.force = tests::with_noise(1e-6 * loop.time, 1e-6, generator);
        EXPECT_THROW((void)find_segments(loop), UndefinedDataError);
        EXPECT_FALSE(fault_of(loop)) << seed;
    }
}

}  // namespace
}  // namespace setae::loops::channel_fault_test
