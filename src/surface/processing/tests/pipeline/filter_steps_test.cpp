// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include "setae/processing/combine_maps.hpp"
#include "setae/processing/fill.hpp"
#include "setae/processing/fourier_cut.hpp"
#include "setae/processing/iso_filter.hpp"
#include "setae/processing/resample.hpp"
#include "setae/processing/rotate.hpp"

namespace setae::processing::filter_steps_test {
namespace {

/// Records the names of the parameters of a step and gives each a value other than its default.
struct Changing {
    std::vector<std::string> names;

    void length(std::string_view name, double& value, std::string_view) {
        names.emplace_back(name);
        value = 2.5;
    }
    void optional_length(std::string_view name, std::optional<double>& value, std::string_view) {
        names.emplace_back(name);
        value = 2.5;
    }
    void number(std::string_view name, double& value, std::string_view) {
        names.emplace_back(name);
        value = 0.25;
    }
    void angle(std::string_view name, double& value, std::string_view) {
        names.emplace_back(name);
        value = 0.25;
    }
    void count(std::string_view name, Index& value, std::string_view) {
        names.emplace_back(name);
        value = 1;
    }
    void flag(std::string_view name, bool& value, std::string_view) {
        names.emplace_back(name);
        value = !value;
    }
    void text(std::string_view name, std::string& value, std::string_view) {
        names.emplace_back(name);
        value = "other";
    }
    template <class Value, std::size_t n>
    void choice(std::string_view name, Value& value, const std::array<Choice<Value>, n>& choices, std::string_view) {
        names.emplace_back(name);
        value = choices.back().value;
    }
};

template <class Step>
std::vector<std::string> parameters() {
    static_assert(std::is_aggregate_v<Step> && std::is_copy_constructible_v<Step>,
                  "a step is a plain value: it is copied, compared and written as its parameters");
    Step step;
    Changing visitor;
    visit_parameters(step, visitor);
    return visitor.names;
}

using Names = std::vector<std::string>;

TEST(FilterSteps, ArePlainValuesWithNamedParameters) {
    // SurfaceTopography's filters hold functions and cannot be pickled
    EXPECT_EQ(parameters<GaussianFilter>(), (Names{"cutoff", "keep", "order"}));
    EXPECT_EQ(parameters<RobustGaussianFilter>(), (Names{"cutoff", "keep", "order"}));
    EXPECT_EQ(parameters<SplineFilter>(), (Names{"cutoff", "keep", "tension", "robust"}));
    EXPECT_EQ(parameters<FourierCut>(), (Names{"shortest", "longest"}));
    EXPECT_EQ(parameters<FillUndefined>(), (Names{"method"}));
    EXPECT_EQ(parameters<Resample>(), (Names{"nx", "ny", "pixel_size", "method"}));
    EXPECT_EQ(parameters<Rotate>(), (Names{"angle", "method", "crop"}));
    EXPECT_EQ(parameters<AddMap>(), (Names{"file", "channel", "align"}));
    EXPECT_EQ(parameters<SubtractMap>(), (Names{"file", "channel", "align"}));
}

TEST(FilterSteps, CanBeChangedByAVisitor) {
    SplineFilter step;
    Changing visitor;
    visit_parameters(step, visitor);
    EXPECT_EQ(step.cutoff, 2.5);
    EXPECT_EQ(step.keep, Kept::short_waves);
    EXPECT_EQ(step.tension, 0.25);
    EXPECT_TRUE(step.robust);
}

TEST(FilterSteps, OfOneMapDoNotChangeAnother) {
    const topography::HeightMap map{Array2D::Random(20, 20), {20.0, 20.0}, false, {}};
    const Array2D before = map.heights;
    (void)apply(GaussianFilter{.cutoff = 5.0, .keep = Kept::short_waves}, map);
    (void)apply(Rotate{.angle = 0.3}, map);
    EXPECT_TRUE((map.heights == before).all());
}

}  // namespace
}  // namespace setae::processing::filter_steps_test
