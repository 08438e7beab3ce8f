// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/pipeline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "record_number.hpp"
#include "setae/core/errors.hpp"
#include "setae/processing/step_text.hpp"

namespace setae::processing::pipeline_test {
namespace {

using topography::HeightMap;
using topography::Measurement;

HeightMap waves() {
    HeightMap map{Array2D(200, 150), {2e-6, 1.5e-6}};
    for (Index i = 0; i < 200; ++i)
        for (Index j = 0; j < 150; ++j)
            map.heights(i, j) =
                1e-8 * std::sin(0.21 * static_cast<double>(i)) * std::sin(0.17 * static_cast<double>(j));
    return map;
}

Pipeline pipeline_of(std::initializer_list<const char*> steps) {
    Pipeline pipeline;
    for (const char* step : steps) pipeline.entries.push_back({step_from_text(step)});
    return pipeline;
}

TEST(Pipeline, OfTiltedStripedSpikyDataRecoversSqWithinOnePercent) {
    const auto truth = waves();
    auto measured = truth;
    std::mt19937 engine(3);
    std::normal_distribution<double> normal;
    for (Index j = 0; j < 150; ++j) measured.heights.col(j) += 4e-8 * normal(engine);
    for (Index i = 0; i < 200; ++i)
        for (Index j = 0; j < 150; ++j)
            measured.heights(i, j) +=
                0.07 * 1e-8 * static_cast<double>(i) - 0.02 * 1e-8 * static_cast<double>(j) + 5e-11 * normal(engine);
    for (int k = 0; k < 20; ++k)
        measured.heights(static_cast<Index>(engine() % 200), static_cast<Index>(engine() % 150)) += 2e-7;
    const auto result =
        processing::apply(pipeline_of({"align_rows method=polynomial degree=1", "despike", "level_plane"}), measured);
    EXPECT_NEAR(rms_of(std::get<HeightMap>(result.measurement).heights) / rms_of(truth.heights), 1.0, 0.01);
    ASSERT_EQ(result.records.size(), 3u);
    EXPECT_NEAR(number_of(result.records[2], "areal_rms_height"),
                rms_of(std::get<HeightMap>(result.measurement).heights), 1e-20);
    EXPECT_EQ(topography::metadata(result.measurement).attributes.at("pipeline"),
              "align_rows method=polynomial | despike | level_plane");
}

TEST(Pipeline, SkipsDisabledSteps) {
    auto pipeline = pipeline_of({"transpose", "flip"});
    EXPECT_FALSE(pipeline.empty());
    pipeline.entries[0].on = false;
    const auto result = processing::apply(pipeline, waves());
    EXPECT_EQ(std::get<HeightMap>(result.measurement).heights.rows(), 200);
    EXPECT_EQ(result.records.size(), 1u);
    pipeline.entries[1].on = false;
    EXPECT_TRUE(pipeline.empty());
    EXPECT_TRUE(
        (std::get<HeightMap>(processing::apply(pipeline, waves()).measurement).heights == waves().heights).all());
}

TEST(Pipeline, RecordsEarlierSteps) {
    auto first = processing::apply(pipeline_of({"level_plane"}), waves());
    const auto second = processing::apply(pipeline_of({"flip direction=y"}), std::move(first.measurement));
    EXPECT_EQ(topography::metadata(second.measurement).attributes.at("pipeline"), "level_plane | flip direction=y");
}

TEST(Pipeline, EqualsItsStepsInSequence) {
    const auto together =
        apply(pipeline_of({"level_polynomial degree=3", "remove_scars", "crop cut_left=5"}), waves(), {}, {2});
    Measurement alone = waves();
    alone = processing::apply(LevelPolynomial{.degree = 3}, std::move(alone)).measurement;
    alone = processing::apply(RemoveScars{}, std::move(alone)).measurement;
    alone = processing::apply(Crop{.cut_left = 5}, std::move(alone)).measurement;
    EXPECT_TRUE((std::get<HeightMap>(together.measurement).heights == std::get<HeightMap>(alone).heights).all());
}

TEST(Pipeline, LoadsTheFilesNamedBySteps) {
    const auto pipeline = pipeline_of({"subtract_map file=\"other map.nc\" channel=topo"});
    std::string asked;
    const auto load = [&](const std::string& file, const std::string& channel) -> Measurement {
        asked = file + " " + channel;
        auto other = waves();
        other.heights -= 1e-6;
        return other;
    };
    const auto result = processing::apply(pipeline, waves(), load);
    EXPECT_EQ(asked, "other map.nc topo");
    EXPECT_LT((std::get<HeightMap>(result.measurement).heights - 1e-6).abs().maxCoeff(), 1e-20);
    EXPECT_THROW((void)processing::apply(pipeline, waves()), InvalidArgument);
}

TEST(StepText, ReadsBackWhatItWrites) {
    for (const std::string line :
         {"level_plane", "level_polynomial degree=3 degree_y=1", "align_rows method=median_of_differences direction=y",
          "despike threshold=5.5 reach=3 replace_by=undefined",
          "mask_out region=\"include heights above 20 nm grow 2; exclude rectangle 1 um to 2 um\"",
          "crop x_from=\"1 um\" x_to=\"2.5 um\"", "quarter_turns turns=-1", "remove_scars high=0.8 sign=negative",
          "gaussian_filter cutoff=\"8 um\" keep=short_waves", "rotate angle=\"30 deg\" crop=true",
          "fourier_cut shortest=\"1 nm\"", "spline_filter cutoff=\"80 um\" tension=0.5 robust=true"}) {
        EXPECT_EQ(text(step_from_text(line)), line);
        EXPECT_EQ(parameters(step_from_text(text(step_from_text(line)))), parameters(step_from_text(line)));
    }
    EXPECT_EQ(text(step_from_text("despike threshold=6 reach=2")), "despike");
}

TEST(StepText, KeepsEveryDigitOfALength) {
    for (const double length :
         {1e-6, 8e-6, 1.23456789012345e-7, 1.0 / 3.0, 2.9999999999999997e-9, 4.7e-13, 12345.678, 0.0}) {
        const auto read = step_from_text(text(Step(Crop{.x_from = length})));
        EXPECT_EQ(std::get<Crop>(read).x_from, length) << text(Step(Crop{.x_from = length}));
    }
    EXPECT_EQ(text(Step(Crop{.x_from = 8e-6})), "crop x_from=\"8 um\"");
}

std::string complaint(const char* line) {
    try {
        (void)step_from_text(line);
    } catch (const InvalidArgument& error) {
        return error.what();
    }
    return "accepted";
}

TEST(StepText, AcceptsBothKindsOfQuotes) {
    const auto expected = text(step_from_text("mask_out region=\"include heights above 20 nm\""));
    EXPECT_EQ(text(step_from_text("mask_out region='include heights above 20 nm'")), expected);
    EXPECT_EQ(text(step_from_text("mask_out 'region=include heights above 20 nm'")), expected);
    const std::string name = "subtract_map file=\"the operator's \\\"best\\\" scan.spm\"";
    EXPECT_EQ(text(step_from_text(name)), name);
}

TEST(StepText, WhenInvalidNamesTheNearestChoice) {
    EXPECT_EQ(complaint("level_plan"),
              "unknown step 'level_plan'; did you mean 'level_plane'?; setae level --explain lists them");
    EXPECT_EQ(
        complaint("despike treshold=5"),
        "unknown parameter 'treshold' of despike; did you mean 'threshold'?; expected one of threshold, reach, replace_by");
    EXPECT_EQ(complaint("transpose turns=1"), "unknown parameter 'turns' of transpose; this step has no parameters");
    EXPECT_EQ(complaint("despike threshold=high"), "threshold: 'high' is not a number");
    EXPECT_EQ(complaint("despike reach=2.5"), "reach: '2.5' is not a whole number");
    EXPECT_EQ(complaint("align_rows method=modal"),
              "method: 'modal' is unknown; expected one of mean, median, median_of_differences, polynomial");
    EXPECT_EQ(complaint("despike threshold"),
              "step 'despike threshold': 'threshold' is no parameter; expected NAME=VALUE");
    EXPECT_EQ(complaint("mask_out region=\"include"), "step 'mask_out region=\"include': a quote is not closed");
    EXPECT_EQ(complaint(" "), "empty step; expected a name, such as level_plane");
    EXPECT_NE(complaint("crop x_from=5").find("x_from: "), std::string::npos);
}

TEST(StepNames, IncludeThoseOfTrends) {
    EXPECT_EQ(name(step_named("mean")), "level_mean");
    EXPECT_EQ(name(step_named("tilt")), "level_plane");
    EXPECT_EQ(text(step_from_text("parabola degree_x=1")), "level_polynomial degree_x=1");
    EXPECT_THROW((void)step_named("none"), InvalidArgument);
}

TEST(StepDescriptions, NameEveryStepAndParameterOnce) {
    const auto descriptions = step_descriptions();
    EXPECT_EQ(descriptions.size(), std::variant_size_v<Step>);
    for (const auto& description : descriptions) {
        EXPECT_EQ(name(step_named(description.name)), description.name);
        EXPECT_FALSE(description.sentence.empty());
        for (const auto& parameter : description.parameters) {
            EXPECT_FALSE(parameter.meaning.empty()) << description.name;
            // the default in documents is read back
            auto step = step_named(description.name);
            if (!parameter.default_value.empty()) {
                EXPECT_NO_THROW(set_parameter(step, {parameter.name, parameter.default_value}))
                    << description.name << " " << parameter.name;
            }
            EXPECT_TRUE(changed_parameters(step).empty()) << description.name;
        }
    }
}

}  // namespace
}  // namespace setae::processing::pipeline_test
