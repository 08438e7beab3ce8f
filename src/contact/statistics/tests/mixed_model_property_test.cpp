// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "nested_design.hpp"
#include "restricted_likelihood.hpp"
#include "setae/statistics/mixed_model.hpp"
#include "simulated_replicates.hpp"

namespace mixed_model_property_test {

using namespace setae;
using namespace setae::statistics;

SimulatedReplicates any_plan() {
    return {.surfaces = *rc::gen::inRange(1, 4),
            .lenses = *rc::gen::inRange(1, 5),
            .spots = *rc::gen::inRange(1, 4),
            .repeats = *rc::gen::inRange(1, 4),
            .between_lenses = *rc::gen::element(0.0, 3.0),
            .fit_error = *rc::gen::element(0.0, 1.0, 5.0),
            .dropped = *rc::gen::element(0.0, 0.4),
            .seed = static_cast<unsigned>(*rc::gen::inRange(0, 10000))};
}

void check(const char* property, const std::function<void()>& body) { EXPECT_TRUE(rc::check(property, body)); }

TEST(MixedModelProperty, LikelihoodIsMaximalAtTheVariances) {
    check("the likelihood falls on every side of its maximum", [] {
        const auto data = simulated(any_plan());
        std::vector<std::size_t> rows(data.rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i;
        const auto design = nested_design(data, rows);
        if (design.levels.empty()) return;
        const auto top = maximise_restricted_likelihood(design);
        RC_ASSERT(top.converged);
        const double scale = top.variances.sum() + design.known_variance.mean();
        for (Index k = 0; k < top.variances.size(); ++k)
            for (const double share : {-0.5, -0.01, 0.01, 0.1, 1.0}) {
                Array1D other = top.variances;
                other[k] += share * (share < 0.0 ? other[k] : scale);
                if (other.sum() + design.known_variance.minCoeff() > 0.0 &&
                    (other.tail(1)[0] > 0.0 || design.known_variance.minCoeff() > 0.0))
                    RC_ASSERT(log_restricted_likelihood(design, other) <= top.log_likelihood + 1e-7);
            }
    });
}

TEST(MixedModelProperty, IntervalsContainTheirMeans) {
    check("intervals of mean and prediction", [] {
        const auto data = simulated(any_plan());
        const auto model = mixed_model(data, {.influence = false});
        for (const auto& surface : model.surfaces) {
            RC_ASSERT(std::isfinite(surface.mean.value));
            if (!surface.mean.uncertain()) continue;
            RC_ASSERT(surface.mean.interval->lower < surface.mean.value &&
                      surface.mean.value < surface.mean.interval->upper);
            if (surface.prediction) RC_ASSERT(surface.prediction->upper > surface.mean.value);
        }
    });
}

TEST(MixedModelProperty, AConstantShiftsMeansOnly) {
    check("adding a constant", [] {
        const auto data = simulated(any_plan());
        auto moved = data;
        for (auto& row : moved.rows) row.value += 1000.0;
        const auto a = mixed_model(data, {.influence = false}), b = mixed_model(moved, {.influence = false});
        for (std::size_t s = 0; s < a.surfaces.size(); ++s) {
            RC_ASSERT(std::abs(b.surfaces[s].mean.value - a.surfaces[s].mean.value - 1000.0) < 1e-4);
            if (a.surfaces[s].mean.uncertain())
                RC_ASSERT(std::abs(b.surfaces[s].mean.standard_error / a.surfaces[s].mean.standard_error - 1.0) < 1e-3);
        }
    });
}

}  // namespace mixed_model_property_test
