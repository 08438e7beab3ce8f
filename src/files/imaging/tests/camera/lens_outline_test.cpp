// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include <unistd.h>

#include "setae/core/errors.hpp"
#include "setae/imaging/lens_outline.hpp"
#include "setae/imaging/png_writer.hpp"

namespace setae::imaging::lens_outline_test {
namespace {

class SidePicture : public testing::Test {
protected:
    void TearDown() override { std::filesystem::remove(path_); }

    /// A dark cap of a sphere before bright light: 320 × 200 pixels, its radius 400 of them, its apex at (150.3, 40.6).
    void draw() {
        constexpr double radius = 400.0, apex_x = 150.3, apex_y = 40.6, blur = 1.2;
        std::mt19937_64 engine(5);
        std::normal_distribution<double> normal;
        cv::Mat picture(200, 320, CV_8UC1);
        for (int row = 0; row < picture.rows; ++row)
            for (int column = 0; column < picture.cols; ++column) {
                const double outside = std::hypot(column - apex_x, row - apex_y - radius) - radius;
                const double covered = 0.5 * std::erfc(outside / (blur * std::sqrt(2.0)));
                picture.at<unsigned char>(row, column) =
                    cv::saturate_cast<unsigned char>(std::lround(210.0 - 170.0 * covered + 3.0 * normal(engine)));
            }
        std::ofstream(path_, std::ios::binary) << png_of(picture);
    }

    std::string path_ =
        (std::filesystem::temp_directory_path() / ("setae_side_" + std::to_string(::getpid()) + ".png")).string();
};

TEST_F(SidePicture, GivesTheOutlineToAFractionOfAPixel) {
    draw();
    ASSERT_TRUE(is_picture(path_));
    constexpr double pixel = 2e-6;
    const auto outline = lens_outline(path_, pixel);
    ASSERT_GT(outline.x.size(), 280);
    // distances from the drawn circle, whose centre is below the picture
    const Array1D from_circle =
        ((outline.x / pixel - 150.3).square() + (199.0 - outline.z / pixel - 440.6).square()).sqrt() - 400.0;
    EXPECT_LT(std::abs(from_circle.mean()), 0.02);
    EXPECT_LT(std::sqrt(from_circle.square().mean()), 0.15);
    EXPECT_NEAR(outline.edge_width / pixel, 1.2, 0.3);
}

TEST_F(SidePicture, RequiresAPixelSize) {
    draw();
    EXPECT_THROW((void)lens_outline(path_), UndefinedDataError);
}

TEST_F(SidePicture, IsDistinguishedFromATableByContent) {
    std::ofstream(path_) << "x [mm],z [um]\n0,1\n";
    EXPECT_FALSE(is_picture(path_));
}

}  // namespace
}  // namespace setae::imaging::lens_outline_test
