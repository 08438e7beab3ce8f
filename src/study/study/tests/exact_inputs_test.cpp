// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/exact_inputs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace setae::study::exact_inputs_test {
namespace {

Study study() {
    Study study;
    SurfaceInput surface;
    surface.name = "A";
    surface.measurements.push_back({.file = "a", .instrument = "afm", .tip_radius = Estimate{1e-8, 1e-9}});
    surface.measurements.push_back({.file = "s", .instrument = "stylus", .tip_radius = Estimate{5e-6, 0.0}});
    study.surfaces.push_back(surface);
    ElastomerInput elastomer;
    elastomer.name = "soft";
    elastomer.youngs_modulus = {1e6, 1e4};
    elastomer.surface_energy = {0.025, 0.0};
    elastomer.sphere_radius = Estimate{1e-3, 0.0};
    study.elastomers.push_back(elastomer);
    ExperimentInput loop;
    loop.file = "loop";
    loop.elastomer = "soft";
    loop.force_calibration = {1.0, 0.01};
    study.experiments.push_back(loop);
    return study;
}

std::vector<std::string> words_of(const Study& study) {
    std::vector<std::string> words;
    for (const auto& [what, names] : exact_inputs(study)) {
        words.push_back(what + ":");
        for (const auto& name : names) words.back() += " " + name;
    }
    return words;
}

TEST(ExactInputs, AreInputsWithoutStandardError) {
    EXPECT_EQ(words_of(study()),
              (std::vector<std::string>{"surface energy: soft", "sphere radius: soft",
                                        "calibration of heights and lengths: afm stylus", "tip radius: stylus",
                                        "calibration of displacement and contact radii:"}));
}

TEST(ExactInputs, OfCalibrationsAreListedSeparatelyIfDifferent) {
    auto one = study();
    one.surfaces[0].measurements[0].height_calibration = Estimate{1.0, 0.02};
    const auto words = words_of(one);
    EXPECT_EQ(words[2], "calibration of heights: stylus");
    EXPECT_EQ(words[3], "calibration of lengths: afm stylus");
}

TEST(ExactInputs, IncludeIntegrationLimitsOfTheStudy) {
    auto one = study();
    one.analysis.longest_wavelength = Estimate{1e-4, 1e-5};
    EXPECT_EQ(words_of(one).size(), words_of(study()).size());
    one.analysis.shortest_wavelength = Estimate{1e-9, 0.0};
    EXPECT_EQ(words_of(one)[0], "shortest wavelength:");
}

}  // namespace
}  // namespace setae::study::exact_inputs_test
