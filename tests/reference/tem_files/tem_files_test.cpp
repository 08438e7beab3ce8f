// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include <gtest/gtest.h>
#include <zip.h>

#include "reference_data.hpp"
#include "setae/core/errors.hpp"
#include "setae/imaging/micrograph.hpp"

namespace setae::imaging::tem_files_test {
namespace {

namespace fs = std::filesystem;

/// What another reader finds in a file (README.md). Centres: mean row and column, weighted by grey level.
struct Expected {
    const char *file, *format;
    long width, height;
    double mean, first, last, centre_row, centre_column;
    double pixel_x = 0, pixel_y = 0;  ///< [m]; 0 where the file states none
};

constexpr Expected pictures[] = {
    {"dmTest_float32_nonSquare_diffPixelSize.dm3", "dm3", 128, 64, 63.5, 0, 127, 31.5, 85.0, 1e-9, 2e-10},
    {"dmTest_float32_nonSquare_diffPixelSize.dm4", "dm4", 128, 64, 63.5, 0, 127, 31.5, 85.0, 1e-9, 2e-10},
    {"test-1.dm3", "dm3", 2, 2, 2.5, 1, 4, 0.7, 0.6},
    {"test-1.dm4", "dm4", 2, 2, 2.5, 1, 4, 0.7, 0.6},
    {"test-10.dm3", "dm3", 2, 2, 2.5, 1, 4, 0.7, 0.6},
    {"test-11.dm4", "dm4", 2, 2, 2.5, 1, 4, 0.7, 0.6},
    {"test-2.dm3", "dm3", 2, 2, 2.5, 1, 4, 0.7, 0.6},
    {"test-7.dm4", "dm4", 2, 2, 2.5, 1, 4, 0.7, 0.6},
    {"test_STEM_image.dm3", "dm3", 68, 68, 32655.396842560553, 33121, 32683, 33.48105699422091, 33.52560591059961,
     0.24853801727294922e-9, 0.24853801727294922e-9},
    {"20180529_A9_003.TIF", "tiff", 2240, 1952, 21.919602834089577, 0, 0, 809.5035159835575, 1260.6708597730508},
    {"Case4_D8_007.TIF", "tiff", 2240, 1952, 22.402661647394613, 0, 0, 770.1726879402714, 974.0373355408733},
    {"ExampleImage.tif", "tiff", 512, 512, 121.1115983543396, 113, 86, 260.9417520112135, 243.5191623906804},
    {"olympus_SIS.tif", "tiff", 112, 101, 7999.082213578501, 7046, 7400, 49.66046676058509, 55.002174610776265,
     2.392791775876109e-11, 2.3927917758761087e-11},
    {"test_loading_image_saved_with_DM.tif", "tiff", 68, 68, 3335.3871107266436, 3465, 3319, 33.42797015852473,
     33.45973164458144, 0.16867469251155853e-6, 0.16867469251155853e-6},
    {"test_loading_image_saved_with_imageJ.tif", "tiff", 68, 68, 3335.3871107266436, 3465, 3319, 33.42797015852473,
     33.45973164458144, 0.16867471098853332e-6, 0.16867471098853332e-6},
    {"test_loading_image_saved_with_imageJ_no_scale.tif", "tiff", 68, 68, 3335.3871107266436, 3465, 3319,
     33.42797015852473, 33.45973164458144}};

/// Of members of tiff_FEI_Helios.zip.
constexpr Expected zipped_pictures[] = {
    {"FEI-Helios-Ebeam-16bits.tif", "tiff", 512, 471, 785.0849256900212, 0, 64512, 455.4763734703536, 258.9410844432425,
     3.3724e-6, 3.3724e-6},
    {"FEI-Helios-Ebeam-8bits.tif", "tiff", 512, 471, 3.0667379909766455, 0, 252, 455.4763734703536, 258.9410844432425,
     3.3724e-6, 3.3724e-6},
    {"FEI-Helios-navcam.tif", "tiff", 768, 551, 0, 0, 0, NAN, NAN, 0.202732 / 768, 0.135155 / 512},
    {"FEI-Helios-navcam-with-no-IRBeam.tif", "tiff", 768, 551, 0, 0, 0, NAN, NAN},
    {"FEI-Helios-navcam-with-no-IRBeam-bad-floats.tif", "tiff", 768, 551, 0, 0, 0, NAN, NAN}};

void expect_near_or_both_undefined(double found, double expected, double tolerance) {
    if (std::isnan(expected)) EXPECT_TRUE(std::isnan(found));
    else EXPECT_NEAR(found, expected, tolerance);
}

void expect_as(const Micrograph& micrograph, const Expected& expected) {
    SCOPED_TRACE(expected.file);
    EXPECT_EQ(micrograph.format, expected.format);
    ASSERT_EQ(micrograph.pixels.cols(), expected.width);
    ASSERT_EQ(micrograph.pixels.rows(), expected.height);
    double sum = 0, rows = 0, columns = 0;
    for (long i = 0; i < expected.height; ++i)
        for (long j = 0; j < expected.width; ++j) {
            const double level = static_cast<double>(micrograph.pixels(i, j));
            sum += level;
            rows += static_cast<double>(i) * level;
            columns += static_cast<double>(j) * level;
        }
    EXPECT_NEAR(sum / static_cast<double>(micrograph.pixels.size()), expected.mean, 1e-6 * expected.mean);
    EXPECT_NEAR(static_cast<double>(micrograph.pixels(0, 0)), expected.first, 1e-4);
    EXPECT_NEAR(static_cast<double>(micrograph.pixels(expected.height - 1, expected.width - 1)), expected.last, 1e-4);
    expect_near_or_both_undefined(rows / sum, expected.centre_row, 1e-6 * expected.centre_row);
    expect_near_or_both_undefined(columns / sum, expected.centre_column, 1e-6 * expected.centre_column);
    ASSERT_EQ(micrograph.pixel_size.has_value(), expected.pixel_x > 0);
    if (!micrograph.pixel_size) return;
    EXPECT_NEAR(micrograph.pixel_size->x, expected.pixel_x, 1e-7 * expected.pixel_x);  // scales are 32-bit numbers
    EXPECT_NEAR(micrograph.pixel_size->y, expected.pixel_y, 1e-7 * expected.pixel_y);
}

std::string content_of(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream content;
    content << stream.rdbuf();
    return content.str();
}

std::string member_of(const fs::path& archive, const char* name) {
    int code = 0;
    const std::unique_ptr<zip_t, decltype(&zip_discard)> zip(zip_open(archive.c_str(), ZIP_RDONLY, &code),
                                                             &zip_discard);
    zip_stat_t status;
    if (!zip || zip_stat(zip.get(), name, 0, &status) != 0) return {};
    const std::unique_ptr<zip_file_t, decltype(&zip_fclose)> file(zip_fopen(zip.get(), name, 0), &zip_fclose);
    std::string content(status.size, '\0');
    return file && zip_fread(file.get(), content.data(), content.size()) == static_cast<zip_int64_t>(content.size())
               ? content
               : std::string();
}

/// A file of a test's own, removed with it.
class Copy {
public:
    Copy(const std::string& name, const std::string& content)
        : folder_(fs::temp_directory_path() /
                  (std::string("setae_tem_") + testing::UnitTest::GetInstance()->current_test_info()->name())),
          path_(folder_ / name) {
        fs::create_directories(folder_);
        std::ofstream(path_, std::ios::binary) << content;
    }
    ~Copy() { fs::remove_all(folder_); }
    Copy(const Copy&) = delete;
    Copy& operator=(const Copy&) = delete;
    [[nodiscard]] std::string path() const { return path_.string(); }

private:
    fs::path folder_, path_;
};

TEST(TemFiles, MatchOtherReaders) {
    SETAE_REQUIRE_REFERENCE_DATA(folder, "tem");
    for (const auto& expected : pictures) expect_as(read_micrograph((folder / expected.file).string()), expected);
}

TEST(TemFiles, OfFeiMatchOtherReaders) {
    SETAE_REQUIRE_REFERENCE_DATA(archive, "tem/tiff_FEI_Helios.zip");
    for (const auto& expected : zipped_pictures) {
        const Copy copy(expected.file, member_of(archive, expected.file));
        const auto micrograph = read_micrograph(copy.path());
        expect_as(micrograph, expected);
        EXPECT_EQ(micrograph.instrument, "Helios NanoLab\" 660");
        EXPECT_EQ(!micrograph.alerts.empty(), std::string(expected.file).find("bad-floats") != std::string::npos);
    }
}

TEST(TemFiles, HaveUnitsPerAxisAndMicroscopeMetadata) {
    SETAE_REQUIRE_REFERENCE_DATA(folder, "tem");
    const auto mixed = read_micrograph((folder / "dmTest_float32_nonSquare_diffPixelSize.dm3").string());
    EXPECT_EQ(mixed.unit, "nm, A");
    ASSERT_EQ(mixed.alerts.size(), 1U);
    EXPECT_EQ(mixed.alerts.front().code, "PIXELS_NOT_SQUARE");
    const auto scanned = read_micrograph((folder / "test_STEM_image.dm3").string());
    EXPECT_EQ(scanned.instrument, "FEI Titan");
    EXPECT_EQ(scanned.attributes.at("voltage"), "200000 V");
    EXPECT_EQ(scanned.acquisition_time, "8/8/2016 4:26:37 PM");
    EXPECT_EQ(read_micrograph((folder / "olympus_SIS.tif").string()).attributes.at("magnification"), "600000");
}

TEST(TemFiles, OfSpectraAreRefused) {
    SETAE_REQUIRE_REFERENCE_DATA(folder, "tem");
    for (const auto* name : {"08_carbon.dm3", "test-EELS_spectrum.dm3"}) {
        SCOPED_TRACE(name);
        try {
            (void)read_micrograph((folder / name).string());
            FAIL() << "read";
        } catch (const FormatError& error) {
            EXPECT_NE(std::string(error.what()).find("a spectrum"), std::string::npos) << error.what();
        }
    }
}

TEST(TemFiles, TruncatedAreRefusedUnlessOnlyUnusedTagsAreLost) {
    SETAE_REQUIRE_REFERENCE_DATA(folder, "tem");
    for (const auto& expected : pictures) {
        const auto content = content_of(folder / expected.file);
        for (std::size_t cut = 0; cut < 64; ++cut) {
            const auto length = content.size() * cut / 64;
            const Copy copy(expected.file, content.substr(0, length));
            try {
                expect_as(read_micrograph(copy.path()), expected);
                EXPECT_EQ(std::string(expected.file), "olympus_SIS.tif")
                    << "cut to " << length;  // blocks of its program follow the image
            } catch (const FormatError& error) {
                EXPECT_NE(std::string(error.what()).find("at byte"), std::string::npos) << error.what();
            }
        }
    }
}

}  // namespace
}  // namespace setae::imaging::tem_files_test
