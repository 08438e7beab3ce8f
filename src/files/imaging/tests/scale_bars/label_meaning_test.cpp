// SPDX-License-Identifier: GPL-3.0-or-later
#include "scale_bars/label_meaning.hpp"

#include <string>

#include <gtest/gtest.h>

namespace setae::imaging::tests::label_meaning_test {
namespace {

TEST(LabelMeaning, IsALengthInTheUnitsOfMicroscopes) {
    EXPECT_DOUBLE_EQ(meaning_of_label("200nm").length.value_or(0), 200e-9);
    EXPECT_DOUBLE_EQ(meaning_of_label("0.5 \u00b5m").length.value_or(0), 0.5e-6);
    EXPECT_DOUBLE_EQ(meaning_of_label("0,5\u03bcm").length.value_or(0), 0.5e-6);
    EXPECT_DOUBLE_EQ(meaning_of_label("2.5um").length.value_or(0), 2.5e-6);
    EXPECT_DOUBLE_EQ(meaning_of_label("20\u00c5").length.value_or(0), 20e-10);
    EXPECT_DOUBLE_EQ(meaning_of_label("5A").length.value_or(0), 5e-10);
    EXPECT_DOUBLE_EQ(meaning_of_label("250pm").length.value_or(0), 250e-12);
    EXPECT_DOUBLE_EQ(meaning_of_label("0.1mm").length.value_or(0), 1e-4);
    EXPECT_EQ(meaning_of_label("0,5um").text, "0.5 µm");
    EXPECT_EQ(meaning_of_label("5A").text, "5 Å");
}

TEST(LabelMeaning, IsEmptyForUnusualOrMalformedNumbers) {
    for (const auto* text : {"3nm", "51nm", "05um", "101nm", "0nm", ".5um", "5.0.1nm", "-5nm", "5", "nm", "5 kV", "5n",
                             "", "1e5nm", "5 nmnm"}) {
        const auto meaning = meaning_of_label(text);
        EXPECT_FALSE(meaning.length) << text;
        EXPECT_NE(meaning.fault, "") << text;
    }
}

TEST(LabelMeaning, OfReciprocalLengthsIsReportedAsDiffractionPattern) {
    for (const auto* text : {"5 1/nm", "51/nm", "10/nm", "2nm-1"}) {
        const auto meaning = meaning_of_label(text);
        EXPECT_FALSE(meaning.length) << text;
        EXPECT_NE(meaning.fault.find("diffraction pattern"), std::string::npos) << text;
    }
}

}  // namespace
}  // namespace setae::imaging::tests::label_meaning_test
