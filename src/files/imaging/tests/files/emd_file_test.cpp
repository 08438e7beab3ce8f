// SPDX-License-Identifier: GPL-3.0-or-later
#include "emd_files.hpp"
#include "micrograph_checks.hpp"
#include "recordings.hpp"

namespace setae::imaging::tests::emd_file_test {
namespace {

TEST(EmdFile, ReadsEveryNumberTypeInTheNcemLayout) {
    for (const hid_t type : {H5T_STD_I8LE, H5T_STD_U8LE, H5T_STD_I16BE, H5T_STD_U16LE, H5T_STD_I32LE, H5T_STD_U32BE,
                             H5T_STD_I64LE, H5T_STD_U64LE, H5T_IEEE_F32BE, H5T_IEEE_F64LE}) {
        const auto micrograph = read_bytes(EmdFile{.type = type}.bytes());
        expect_common_picture(micrograph);
        expect_pixel_size(micrograph, 0.5e-9, 0.25e-9);
        EXPECT_TRUE(has_alert(micrograph, "UNTESTED_FORMAT"));
    }
    expect_common_picture(read_bytes(EmdFile{.packed = true}.bytes()));
}

TEST(EmdFile, ReadsTheVeloxLayout) {
    const auto micrograph = read_bytes(EmdFile{.velox = true, .unit_x = "m", .step_x = 0.5, .step_y = 0.25}.bytes());
    expect_common_picture(micrograph);
    expect_pixel_size(micrograph, 0.5, 0.25);
    EXPECT_TRUE(has_alert(micrograph, "STACK"));
    EXPECT_EQ(micrograph.instrument, "Titan");
    EXPECT_EQ(micrograph.attributes.at("voltage"), "300000 V");
}

TEST(EmdFile, IsReadEquallyFromDiskAndMemory) {
    const Folder folder;
    write_bytes(folder / "image.emd", EmdFile{}.bytes());
    expect_common_picture(read_micrograph(folder / "image.emd"));
}

TEST(EmdFile, GivesEachAxisItsOwnUnit) {
    const auto micrograph = read_bytes(EmdFile{.unit_x = "[n_m]", .unit_y = "[u_m]"}.bytes());
    expect_pixel_size(micrograph, 0.5e-9, 0.25e-6);
    EXPECT_EQ(micrograph.unit, "nm, um");
    EXPECT_TRUE(has_alert(read_bytes(EmdFile{.unit_x = "[n_m^-1]", .unit_y = "[n_m^-1]"}.bytes()), "RECIPROCAL_UNITS"));
}

TEST(EmdFile, ReadsTheFirstPlaneOfAStackAndRefusesSpectra) {
    const auto stack = read_bytes(EmdFile{.sides = {4, rows, columns}}.bytes());
    expect_common_picture(stack);
    EXPECT_TRUE(has_alert(stack, "STACK"));
    expect_refusal(EmdFile{.unit_x = "[eV]"}.bytes(), "a spectrum");
    expect_refusal(EmdFile{.sides = {1, 9}}.bytes(), "a spectrum");
}

TEST(EmdFile, RefusesHugePicturesBeforeTheirPixelsAreRead) {
    expect_refusal(EmdFile{.velox = true, .sides = {30000, 30000, 1}, .pixels_written = false}.bytes(),
                   "30000 × 30000 pixels");
    expect_refusal(EmdFile{.sides = {30000, 30000}, .pixels_written = false}.bytes(), "30000 × 30000 pixels");
}

TEST(EmdFile, RefusesHdf5OfOtherLayout) {
    auto bytes = EmdFile{}.bytes();
    for (auto at = bytes.find("emd_group"); at != std::string::npos; at = bytes.find("emd_group")) bytes[at] = 'x';
    expect_refusal(bytes, "without an image in the layout of EMD");
}

}  // namespace
}  // namespace setae::imaging::tests::emd_file_test
