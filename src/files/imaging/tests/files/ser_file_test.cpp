// SPDX-License-Identifier: GPL-3.0-or-later
#include "electron_files.hpp"
#include "micrograph_checks.hpp"
#include "recordings.hpp"

namespace setae::imaging::tests::ser_file_test {
namespace {

TEST(SerFile, ReadsEveryNumberTypeInEitherVersion) {
    const Bytes little;
    for (const int version : {0x0210, 0x0220})
        for (const int type : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}) {
            SCOPED_TRACE(testing::Message() << "version " << version << " type " << type);
            SerFile file{.version = version, .type = type};
            for (const std::uint64_t i : {4, 5, 6, 1, 2, 3}) {
                const auto real = static_cast<double>(i);
                const int bytes[] = {1, 2, 4, 1, 2, 4};
                if (type <= 6) file.pixels += little.whole(i, bytes[type - 1]);
                else if (type == 7) file.pixels += little.real32(static_cast<float>(real));
                else if (type == 8) file.pixels += little.real64(real);
                else if (type == 9)
                    file.pixels +=
                        little.real32(static_cast<float>(0.6 * real)) + little.real32(static_cast<float>(0.8 * real));
                else file.pixels += little.real64(-0.6 * real) + little.real64(0.8 * real);
            }
            const auto micrograph = read_bytes(file.bytes());
            expect_common_picture(micrograph, 1e-6f);
            expect_pixel_size(micrograph, 0.5e-9, 0.25e-9);
            EXPECT_TRUE(has_alert(micrograph, "UNTESTED_FORMAT"));
            EXPECT_EQ(has_alert(micrograph, "COMPLEX_MAGNITUDE"), type >= 9);
        }
}

TEST(SerFile, ReadsTheRequestedImage) {
    auto file = ser_file(0x0220);
    file.images = 3;
    EXPECT_TRUE(has_alert(read_bytes(file.bytes()), "SEVERAL_IMAGES"));
    expect_common_picture(read_bytes(file.bytes(), {.image = "2"}));
    EXPECT_THROW((void)read_bytes(file.bytes(), {.image = "3"}), InvalidArgument);
}

TEST(SerFile, RefusesSpectraAndUnknownTypes) {
    auto file = ser_file();
    file.kind = 0x4120;
    expect_refusal(file.bytes(), "spectra");
    file = ser_file();
    file.type = 11;
    expect_refusal(file.bytes(), "type 11");
}

TEST(SerFile, ReadsMicroscopeAndTimeFromTheEmiFile) {
    const Folder folder;
    write_bytes(folder / "foil_1.ser", ser_file().bytes());
    EXPECT_EQ(read_micrograph(folder / "foil_1.ser").instrument, "");
    const std::string xml =
        "<ObjectInfo><AcquireDate>Tue Oct 3 2017</AcquireDate><ExperimentalDescription><Root><Data><Label>Microscope</Label><Value>Tecnai 200 kV</Value><Unit/></Data>"
        "<Data><Label>High tension</Label><Value>200</Value><Unit>kV</Unit></Data></Root></ExperimentalDescription></ObjectInfo>";
    write_bytes(folder / "foil.emi", std::string("JK\0\2", 4) + xml + std::string(9, '\7'));
    const auto micrograph = read_micrograph(folder / "foil_1.ser");
    EXPECT_EQ(micrograph.instrument, "Tecnai 200 kV");
    EXPECT_EQ(micrograph.acquisition_time, "Tue Oct 3 2017");
    EXPECT_EQ(micrograph.attributes.at("voltage"), "200 kV");
    write_bytes(folder / "foil.emi", "<ObjectInfo> without end");
    EXPECT_EQ(read_micrograph(folder / "foil_1.ser").instrument, "");
}

}  // namespace
}  // namespace setae::imaging::tests::ser_file_test
