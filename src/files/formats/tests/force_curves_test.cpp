// SPDX-License-Identifier: GPL-3.0-or-later
// Files of force curves are refused by every reader of heights, with the command that reads them.
#include <gtest/gtest.h>

#include "error_message.hpp"
#include "import_samples.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::force_curves_test {
namespace {

TEST(ForceCurves, AreNotHeights) {
    const ReadOptions given{.size = {{1e-6, 1e-6}}, .unit = "nm"};
    for (const auto& content : {jpk_text_file(), afm_workshop_file(), igor_force_file("SpringConstant: 0.1\r"),
                                nanoscope_force_file(), jpk_text_file(3)}) {
        const auto message =
            message_of([&] { (void)formats::open(bytes::memory_source("f", content), given).at(0).read(); });
        EXPECT_NE(message.find("force curve"), std::string::npos) << message;
        EXPECT_NE(message.find("`setae jkr fit` reads"), std::string::npos) << message;
    }
}

}  // namespace
}  // namespace setae::formats::tests::force_curves_test
