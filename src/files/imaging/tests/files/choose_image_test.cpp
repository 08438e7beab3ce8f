// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/micrograph_building.hpp"
#include "micrograph_checks.hpp"

namespace setae::imaging::tests::choose_image_test {
namespace {

const std::vector<ImageEntry> images{
    {"EDS", "spectrum image"}, {"HAADF", "image"}, {"HAADF", "Fourier transform"}, {"BF", "image"}};

std::size_t chosen(const std::string& image) {
    Micrograph micrograph;
    micrograph.file = "a.emd";
    const auto number = choose_image(micrograph, images, {.image = image});
    EXPECT_EQ(micrograph.image, number);
    EXPECT_EQ(micrograph.images.size(), images.size());
    EXPECT_EQ(micrograph.alerts.at(0).code, "SEVERAL_IMAGES");
    EXPECT_NE(micrograph.alerts.at(0).message.find(
                  "0 'EDS' (spectrum image), 1 'HAADF', 2 'HAADF' (Fourier transform), 3 'BF'"),
              std::string::npos)
        << micrograph.alerts.at(0).message;
    return number;
}

TEST(ChooseImage, AcceptsNumbersAndTitlesAndDefaultsToTheFirst) {
    EXPECT_EQ(chosen(""), 1u);
    EXPECT_EQ(chosen("2"), 2u);
    EXPECT_EQ(chosen("b"), 3u);
}

TEST(ChooseImage, RefusesMissingAndAmbiguousChoices) {
    Micrograph micrograph;
    micrograph.file = "a.emd";
    EXPECT_THROW((void)choose_image(micrograph, images, {.image = "4"}), InvalidArgument);
    EXPECT_THROW((void)choose_image(micrograph, images, {.image = "haadf"}), InvalidArgument);
    EXPECT_EQ(choose_image(micrograph, 1, {}), 0u);
    EXPECT_TRUE(micrograph.alerts.empty());
}

}  // namespace
}  // namespace setae::imaging::tests::choose_image_test
