// SPDX-License-Identifier: GPL-3.0-or-later
// What a pair's means cost with the number of its loops.
#include <gtest/gtest.h>

#include <algorithm>

#include <fmt/format.h>

#include "allocated_bytes.hpp"
#include "loop_files.hpp"
#include "results/pairs.hpp"
#include "setae/loops/analysis.hpp"
#include "setae/loops/loop.hpp"
#include "setae/study/study_result.hpp"

namespace setae::study::growth_test {
namespace {

/// A study of one pair with copies of a loop, the work of each another.
StudyResult of_loops(int n) {
    static const auto analysis = [] {
        loops::LensAndCounterBody bodies;
        bodies.radius = loop_files::sphere_radius;
        bodies.counter_youngs_modulus = 1e18;
        return loops::analyse(loops::loop_from_table(loop_files::loop(30e-3, 60e-3, 5e-6)), bodies, {});
    }();
    StudyResult result;
    result.surfaces.resize(1);
    result.surfaces[0].name = "A";
    result.elastomers.resize(1);
    result.elastomers[0].input.name = "E";
    result.elastomers[0].modulus_from_loops = true;
    for (int i = 0; i < n; ++i) {
        ExperimentResult loop;
        loop.input.file = fmt::format("l{}.csv", i);
        loop.input.surface = "A";
        loop.input.elastomer = "E";
        loop.bodies.radius = loop_files::sphere_radius;
        loop.bodies.counter_youngs_modulus = 1e18;
        loop.analysis = analysis;
        loop.analysis->corrected = {};  // nothing of a mean needs the record
        result.experiments.push_back(std::move(loop));
    }
    return result;
}

TEST(PairOfManyLoops, UsesMemoryInProportionToLoops) {
    double before = 0.0;
    for (const int n : {10, 100, 1000}) {
        const auto result = of_loops(n);
        const double bytes = tests::bytes_of([&] { EXPECT_EQ(measured_pairs(result).front().experiments, n); });
        if (before > 0.0) {
            EXPECT_LT(tests::exponent(n / 10, before, n, bytes), 1.1) << n;
        }
        before = bytes;
    }
}

}  // namespace
}  // namespace setae::study::growth_test
