// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/bearings.hpp"

#include <set>

#include <gtest/gtest.h>

#include "setae/output/alert_kinds.hpp"
#include "setae/output/verdict.hpp"

namespace setae::output::bearings_test {
namespace {

using study::StudyResult;

bool says(const StudyResult& result, const std::string& part) {
    for (const auto& sentence : verdict(result).limits)
        if (sentence.find(part) != std::string::npos) return true;
    return false;
}

TEST(WarningEffects, CoverEveryKindOfWarningExceptListedOnes) {
    // failures, reconstructions and Eq. 7 below 0 have sentences of their own
    const std::set<std::string> elsewhere{"LIKELIHOOD_FAILED", "FILES_LEFT_OUT", "RECONSTRUCTION", "EMPTY_STUDY",
                                          "WILL_NOT_CONFORM"};
    // what was done, or how a file is made
    const std::set<std::string> informing{"UNIT_PREFIX",        "SIZE_BETWEEN_POINTS", "FORCE_CURVES_NOT_READ",
                                          "MALFORMED_FIELD",    "NOT_IN_SCHEMA",       "UNKNOWN_FIELD",
                                          "NAME_MISSING",       "LARGE_MAP",           "BAD_NUMBER",
                                          "PIXELS_NOT_SQUARE",  "COMPLEX_MAGNITUDE",   "SEVERAL_IMAGES",
                                          "SIZE_NOT_STATED",    "SHEET_CHOSEN",        "STACK",
                                          "CLOSED_OUTLINE",     "CONTOUR_STEPS",       "TIP_CUTOFF",
                                          "SPECTRUM_CONVERTED", "FILTER_CUTOFF",       "RAL_UNDEFINED",
                                          "SAL_UNDEFINED",      "STR_UNDEFINED",       "STD_WITHOUT_DIRECTION",
                                          "THIN_LAYER",         "COLUMN_UNUSED"};
    std::set<std::string> kinds, bearing;
    for (const auto& kind : alert_kinds()) kinds.insert(kind.code);
    for (const auto& [codes, sentence] : bearings()) {
        EXPECT_NE(std::string(sentence).find("{}"), std::string::npos) << sentence;
        for (const auto code : codes) {
            EXPECT_TRUE(bearing.insert(std::string(code)).second) << code << " stands twice";
            EXPECT_TRUE(kinds.contains(std::string(code))) << code << " is no kind of alert";
        }
    }
    for (const auto& code : kinds)
        EXPECT_EQ(static_cast<int>(bearing.contains(code)) + static_cast<int>(elsewhere.contains(code)) +
                      static_cast<int>(informing.contains(code)),
                  1)
            << code << ": add a sentence to verdict/bearings.cpp, or its code here if it limits no conclusion";
}

TEST(WarningEffects, NameAFewMeasurementsOrTheirSurface) {
    StudyResult result;
    result.surfaces.push_back({.name = "A"});
    auto& measurements = result.surfaces.front().measurements;
    const auto add = [&](const std::string& file) {
        auto& m = measurements.emplace_back();
        m.file = "scans/" + file;
        m.alerts = {{"SPIKES", m.file + " (h)", "", ""}};
    };
    for (const char* file : {"1.csv", "2.csv", "3.csv"}) add(file);
    EXPECT_TRUE(says(result, "Heights of 1.csv, 2.csv and 3.csv contain artefacts"));
    add("4.csv");
    EXPECT_TRUE(says(result, "Heights of A contain artefacts"));
}

}  // namespace
}  // namespace setae::output::bearings_test
