// SPDX-License-Identifier: GPL-3.0-or-later
// HDF5 and the formats based on it: additions to the tests of all formats.
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "error_message.hpp"
#include "format_samples.hpp"
#include "hdf5_builder.hpp"
#include "sample_files.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/channel.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::hdf5_test {
namespace {

using topography::HeightMap;
using namespace tests;

const ReadOptions given{.size = {{6e-6, 4e-6}}, .unit = "nm"};

std::vector<Channel> channels_of(const std::string& content, const ReadOptions& options = given) {
    return open(bytes::memory_source("sample", content), options);
}

std::vector<std::string> names_of(const std::vector<Channel>& channels) {
    std::vector<std::string> names;
    for (const auto& channel : channels) names.push_back(channel.info.name);
    return names;
}

std::vector<double> numbers(std::size_t count) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<double>(i);
    return values;
}

TEST(Hdf5, EveryMapAndLineOfEveryGroupIsAChannel) {
    Hdf5Builder file;
    file.dataset("/map", H5T_IEEE_F32LE, {3, 4}, numbers(12)).dataset("/deep/er/line", H5T_STD_I8LE, {5}, numbers(5));
    file.dataset("/cube", H5T_IEEE_F64LE, {2, 2, 2}, numbers(8)).dataset("/one", H5T_IEEE_F64LE, {1, 1}, {1.0});
    EXPECT_EQ(names_of(channels_of(file.bytes())), (std::vector<std::string>{"deep/er/line", "map"}));
}

TEST(Hdf5, GivenSizeOfTheMapIsNotUsedForLines) {
    Hdf5Builder file;
    file.dataset("/line", H5T_STD_I8LE, {5}, numbers(5)).dataset("/map", H5T_IEEE_F32LE, {3, 4}, numbers(12));
    const auto channels = channels_of(file.bytes());
    EXPECT_EQ(missing(channels.at(0).info)[0], "size");
    EXPECT_DOUBLE_EQ(std::get<HeightMap>(channels.at(1).read()).size[1], 4e-6);
}

TEST(Hdf5, UnitOfAnAttributeIsUsed) {  // SurfaceTopography reads no unit
    Hdf5Builder file;
    file.dataset("/a", H5T_IEEE_F64LE, {2, 3}, numbers(6)).attribute("/a", "unit", std::string("um"));
    file.dataset("/b", H5T_IEEE_F64LE, {2, 3}, numbers(6)).variable_text("/b", "units", "V");
    const auto channels = channels_of(file.bytes(), {.size = {{2e-6, 3e-6}}, .unit = {}});
    EXPECT_DOUBLE_EQ(std::get<HeightMap>(channels.at(0).read()).heights(1, 2), 5e-6);
    EXPECT_FALSE(channels.at(1).info.is_height);
    EXPECT_EQ(channels[1].info.unit, "V");
}

TEST(Hdf5, StepsOfAnAttributeGiveTheSize) {  // SurfaceTopography reads no size
    Hdf5Builder file;
    file.dataset("/a", H5T_IEEE_F64LE, {2, 3}, numbers(6))
        .attribute("/a", "element_size_um", std::vector<double>{9.0, 0.5, 0.25});
    const auto channel = channels_of(file.bytes(), {.size = {}, .unit = "nm"}).at(0);
    EXPECT_DOUBLE_EQ(channel.info.size.at(0), 1e-6);
    EXPECT_DOUBLE_EQ(channel.info.size.at(1), 0.75e-6);
}

TEST(Hdf5, InvalidStepsAreNamedAndAffectTheirMapOnly) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (const double step : {-0.5, 0.0, 1e-300, 1e300, infinite, std::nan("")}) {
        Hdf5Builder file;
        file.dataset("/a", H5T_IEEE_F64LE, {2, 3}, numbers(6))
            .attribute("/a", "element_size_um", std::vector<double>{step, step})
            .attribute("/a", "unit", std::string("nm"));
        file.dataset("/b", H5T_IEEE_F64LE, {2, 3}, numbers(6))
            .attribute("/b", "element_size_um", std::vector<double>{0.5, 0.5})
            .attribute("/b", "unit", std::string("nm"));
        const auto channels = channels_of(file.bytes(), {});
        ASSERT_EQ(channels.size(), 2u) << step;
        ASSERT_FALSE(channels[0].info.alerts.empty()) << step;
        EXPECT_EQ(channels[0].info.alerts[0].code, "SIZE_NOT_STATED");
        EXPECT_EQ(missing(channels[0].info)[0], "size");
        EXPECT_NE(message_of([&] { (void)channels[0].read(); }).find("size"), std::string::npos);
        EXPECT_DOUBLE_EQ(std::get<HeightMap>(channels[1].read()).size[0], 1e-6);
    }
}

TEST(Hdf5, WithoutSizeAndUnitIsListed) {
    Hdf5Builder file;
    file.dataset("/a", H5T_IEEE_F64LE, {2, 3}, numbers(6));
    const auto channel = channels_of(file.bytes(), {}).at(0);
    EXPECT_EQ(missing(channel.info)[0], "size");
    EXPECT_THROW((void)channel.read(), InvalidArgument);
}

TEST(Hdf5, ChunksNeverWrittenHaveTheFillValue) {
    Hdf5Builder file;
    file.dataset("/a", H5T_STD_I16LE, {4, 5}, {}, {.chunk = {2, 2}, .fill = 7.0});
    EXPECT_TRUE((std::get<HeightMap>(channels_of(file.bytes()).at(0).read()).heights == 7.0 * units::nm).all());
}

TEST(Hdf5, ValuesNeverWrittenAreListedAndRefused) {
    Hdf5Builder file;
    file.dataset("/a", H5T_STD_I16LE, {4, 5}, {}).dataset("/b", H5T_STD_I16LE, {4, 5}, numbers(20));
    const auto channels = channels_of(file.bytes());
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].info.alerts.at(0).code, "UNREADABLE_ARRAY");
    EXPECT_NE(message_of([&] { (void)channels[0].read(); }).find("never written"), std::string::npos);
    EXPECT_EQ(std::get<HeightMap>(channels[1].read()).heights(3, 4), 19.0 * units::nm);
}

TEST(Hdf5, DatasetThatTheLibraryCannotOpenIsReported) {
    Hdf5Builder file({.newest = true});
    file.dataset("/a", H5T_STD_I16LE, {4, 5}, numbers(20)).dataset("/b", H5T_STD_I16LE, {4, 5}, numbers(20));
    auto content = file.bytes();
    content[content.rfind("OHDR") + 12] ^= 1;  // its checksum then shows the damage of the header
    const auto channels = channels_of(content);
    ASSERT_EQ(channels.size(), 2u);
    const std::size_t damaged = channels[0].info.alerts.empty() ? 1 : 0;
    EXPECT_EQ(channels[damaged].info.alerts.at(0).code, "UNREADABLE_ARRAY");
    EXPECT_NE(message_of([&] { (void)channels[damaged].read(); }).find("cannot be opened"), std::string::npos);
    EXPECT_EQ(std::get<HeightMap>(channels[1 - damaged].read()).heights(3, 4), 19.0 * units::nm);
}

TEST(Hdf5, InconsistentHeapsAreRefusedBeforeTheLibraryReadsThem) {
    Hdf5Builder file;
    file.dataset("/a", H5T_STD_I16LE, {4, 5}, numbers(20)).variable_text("/a", "note", "a text of variable length");
    const auto content = file.bytes();
    const auto heap = content.find("GCOL");
    ASSERT_NE(heap, std::string::npos);
    EXPECT_EQ(channels_of(content).size(), 1u);
    for (const std::size_t byte :
         {8, 10, 24, 26, 56 + 8, 56 + 9}) {  // of the size of the heap, of the text, of the free space after it
        auto damaged = content;
        damaged[heap + byte] ^= 0x40;
        EXPECT_NE(message_of([&] { (void)channels_of(damaged); }).find("a heap"), std::string::npos) << byte;
    }
}

TEST(Hdf5, UnsupportedFiltersAreNamedWithARemedy) {
    Hdf5Builder file;
    file.dataset("/a", H5T_STD_I16LE, {4, 5}, numbers(20), {.chunk = {2, 2}, .n_bit = true});
    const auto channel = channels_of(file.bytes()).at(0);
    const auto message = message_of([&] { (void)channel.read(); });
    EXPECT_NE(message.find("filter 5"), std::string::npos) << message;
    EXPECT_NE(message.find("h5repack"), std::string::npos) << message;
}

TEST(Hdf5, ExternalLinksAreNotFollowed) {
    const TemporaryFolder folder;
    Hdf5Builder other;
    other.dataset("/secret", H5T_IEEE_F64LE, {2, 3}, numbers(6));
    const auto other_path = folder.write("other.h5", other.bytes());
    folder.write("raw.bin", std::string(48, 'x'));
    Hdf5Builder file;
    file.dataset("/own", H5T_IEEE_F64LE, {2, 3}, numbers(6))
        .external_link("/away", other_path, "/secret")
        .soft_link("/same", "/own");
    file.external_dataset("/raw", {2, 3}, folder.path("raw.bin"));
    const auto channels = open(folder.write("file.h5", file.bytes()), given);
    EXPECT_EQ(names_of(channels), (std::vector<std::string>{"own", "raw"}));
    EXPECT_NE(message_of([&] { (void)channels.at(1).read(); }).find("other files"), std::string::npos);
}

TEST(Hdf5, GroupsThatContainThemselvesTerminate) {
    Hdf5Builder file;
    file.dataset("/group/map", H5T_IEEE_F64LE, {2, 3}, numbers(6)).hard_link("/group/again", "/group");
    const auto channels = channels_of(file.bytes());
    EXPECT_GE(channels.size(), 1u);
    EXPECT_LE(channels.size(), 32u);
}

TEST(Hdf5, DecompressionBombsAreRefused) {
    constexpr hsize_t side = 4096;
    Hdf5Builder file;
    file.dataset("/bomb", H5T_IEEE_F64LE, {side, side}, std::vector<double>(side * side, 1.0),
                 {.chunk = {side, side}, .deflated = true});
    file.dataset("/map", H5T_IEEE_F64LE, {2, 3}, numbers(6));
    const auto content = file.bytes();
    ASSERT_LT(content.size(), side * side * 8 / 100);
    const auto channels = channels_of(content);
    ASSERT_EQ(channels.size(), 2u);  // adjacent data are read
    EXPECT_NE(message_of([&] { (void)channels[0].read(); }).find("it is damaged, or a map of one value"),
              std::string::npos);
    EXPECT_EQ(std::get<HeightMap>(channels[1].read()).heights(1, 2), 5.0 * units::nm);
}

TEST(Hdf5, DamagedChunksAreRefused) {
    Hdf5Builder file;
    file.dataset("/a", H5T_IEEE_F64LE, {8, 8}, numbers(64), {.chunk = {8, 8}, .summed = true});
    auto content = file.bytes();
    const double value = 37.0;
    const auto at = content.find(std::string(reinterpret_cast<const char*>(&value), sizeof value));
    ASSERT_NE(at, std::string::npos);
    content[at + 6] ^= 1;
    const auto channel = channels_of(content).at(0);
    EXPECT_NE(message_of([&] { (void)channel.read(); }).find("wrong checksum"), std::string::npos);
}

TEST(Hdf5, IsReadEquallyFromDiskAndMemory) {
    const TemporaryFolder folder;
    for (const auto& sample : hdf5_samples()) {
        const auto on_disk = open(folder.write("a.h5", sample.content), sample.options).at(sample.channel).read();
        const auto in_memory = channels_of(sample.content, sample.options).at(sample.channel).read();
        const auto from_disk = topography::all_heights(on_disk), from_memory = topography::all_heights(in_memory);
        EXPECT_TRUE((from_disk.isNaN() == from_memory.isNaN()).all() &&
                    (from_disk.isNaN() || from_disk == from_memory).all())
            << sample.name;
    }
}

TEST(Hdf5, LargeCompressedMapsAreReadInChunks) {
    constexpr hsize_t nx = 700, ny = 600;
    auto values = numbers(nx * ny);
    for (auto& value : values) value = std::fmod(value * 7919.0, 65521.0);
    Hdf5Builder file;
    file.dataset("/a", H5T_STD_U16LE, {nx, ny}, values, {.chunk = {50, 70}, .shuffled = true, .deflated = true});
    const auto map = std::get<HeightMap>(channels_of(file.bytes()).at(0).read());
    for (Index i = 0; i < static_cast<Index>(nx); ++i)
        for (Index j = 0; j < static_cast<Index>(ny); ++j)
            ASSERT_DOUBLE_EQ(map.heights(i, j),
                             values[static_cast<std::size_t>(i) * ny + static_cast<std::size_t>(j)] * units::nm)
                << i << ' ' << j;
}

// ---- DATX -----------------------------------------------------------------------------------------------------------

TEST(Datx, ListsSurfaceFirstAndIntensityWithoutHeights) {
    const auto channels = channels_of(datx_samples().front().content, {});
    EXPECT_EQ(names_of(channels), (std::vector<std::string>{"Surface", "Intensity"}));
    EXPECT_TRUE(channels[0].info.is_height);
    EXPECT_FALSE(channels[1].info.is_height);
    EXPECT_EQ(channels[0].info.metadata.instrument.name, "NewView 9000");
    EXPECT_EQ(channels[0].info.metadata.attributes.at("serial_number"), "4711");
}

TEST(Datx, ConverterOfXBelongsToColumns) {  // earlier readers gave a map of 4 rows and 6 columns 4 points along x
    const auto channel = channels_of(datx_samples().front().content, {}).at(0);
    EXPECT_EQ(channel.info.shape, (std::vector<Index>{6, 4}));
    EXPECT_DOUBLE_EQ(channel.info.size.at(0), 6 * 0.2e-6);
    EXPECT_DOUBLE_EQ(channel.info.size.at(1), 4 * 0.3e-6);
}

TEST(Datx, ConvertsFringesToHalfWavelengths) {  // which SurfaceTopography refuses
    const auto map = std::get<HeightMap>(channels_of(datx_samples().at(1).content, {}).at(0).read());
    EXPECT_DOUBLE_EQ(map.heights(0, 0), 632.8e-9 * 0.5 * 1.25);
    EXPECT_TRUE(std::isnan(map.heights(2, 3)));
}

Hdf5Builder& surface(Hdf5Builder& file, const std::string& unit) {
    return file.group("/MetaData")
        .dataset("/Data/Surface/{1}", H5T_IEEE_F32LE, {2, 3}, numbers(6))
        .attribute("/Data/Surface/{1}", "Unit", unit);
}

TEST(Datx, WithoutConvertersTheSizeIsReportedMissing) {
    Hdf5Builder file;
    const auto channel = channels_of(surface(file, "MicroMeters").bytes(), {}).at(0);
    EXPECT_EQ(channel.info.format, "datx");
    EXPECT_EQ(missing(channel.info)[0], "size");
    EXPECT_EQ(channel.info.unit, "µm");
}

TEST(Datx, UnitsThatDisagreeGiveAWarning) {
    Hdf5Builder file;
    surface(file, "NanoMeters").converter("/Data/Surface/{1}", "Z Converter", {"HeightCat", "MicroMeters", {0.0, 1.0}});
    EXPECT_EQ(channels_of(file.bytes(), {}).at(0).info.alerts.at(0).code, "UNIT_MISMATCH");
}

TEST(Datx, ChannelWithAnotherUnitThanLengthIsNotAHeight) {
    Hdf5Builder file;
    EXPECT_FALSE(channels_of(surface(file, "Radians").bytes(), {}).at(0).info.is_height);
}

// ---- JPK ------------------------------------------------------------------------------------------------------------

TEST(JpkHdf5, EachFrameIsAChannel) {
    const auto channels = channels_of(jpk_hdf5_samples().at(1).content, {});
    EXPECT_EQ(names_of(channels), (std::vector<std::string>{"height (retrace), frame 0", "height (retrace), frame 1",
                                                            "height (retrace), frame 2"}));
    const double step =
        std::get<HeightMap>(channels[1].read()).heights(2, 1) - std::get<HeightMap>(channels[0].read()).heights(2, 1);
    EXPECT_NEAR(step, 2e-6, 1e-20);
    EXPECT_EQ(channels[0].info.metadata.attributes.at("lines_a_second"), "128");
}

TEST(JpkHdf5, MetresAreAssumedWithAWarning) {
    EXPECT_EQ(channels_of(jpk_hdf5_samples().at(0).content, {}).at(0).info.alerts.at(0).code, "UNIT_ASSUMED");
}

TEST(JpkHdf5, OtherChannelsAreListedOnly) {
    Hdf5Builder file;
    file.dataset("/Measurement_000/Channel_000/Phase", H5T_IEEE_F64LE, {6, 1}, numbers(6));
    file.attribute("/Measurement_000/Channel_000", "channel.name", std::string("phase"));
    file.attribute("/Measurement_000", "position-pattern.grid.ilength", std::vector<double>{3});
    const auto channel = channels_of(file.bytes(), {}).at(0);
    EXPECT_EQ(channel.info.name, "phase (trace)");
    EXPECT_EQ(channel.info.shape, (std::vector<Index>{3, 2}));
    EXPECT_FALSE(channel.info.is_height);
}

TEST(JpkHdf5, PixelsThatDoNotFormLinesAreRefused) {
    Hdf5Builder file;
    file.dataset("/Measurement_000/Channel_000/Height", H5T_IEEE_F64LE, {7, 1}, numbers(7));
    file.attribute("/Measurement_000/Channel_000", "channel.name", std::string("height"));
    file.attribute("/Measurement_000", "position-pattern.grid.ilength", std::vector<double>{3});
    EXPECT_NE(message_of([&] { (void)channels_of(file.bytes(), {}); }).find("do not form lines of 3"),
              std::string::npos);
}

// ---- data that are unlikely to be heights
// ------------------------------------------------------------------------------

/// Why the only array of a file is not read as heights.
std::string why(const std::string& path, hid_t type, const std::vector<hsize_t>& extents,
                const std::vector<double>& values, bool beside = false) {
    Hdf5Builder file;
    for (std::size_t slash = path.find('/', 1); slash != std::string::npos; slash = path.find('/', slash + 1))
        file.group(path.substr(0, slash));
    file.dataset(path, type, extents, values);
    if (beside) file.dataset("/zz_map", H5T_IEEE_F64LE, {2, 2}, {1, 3, 2, 4});
    const auto channels = channels_of(file.bytes());
    EXPECT_EQ(channels[0].info.is_height, channels[0].info.not_heights.empty());
    return channels[0].info.not_heights;
}

std::vector<double> values_of(std::size_t count, const std::function<double(std::size_t)>& value) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = value(i);
    return values;
}

TEST(Hdf5, IndicesPositionsPicturesAndTablesAreNotHeights) {
    const auto rough = [](std::size_t i) { return static_cast<double>((7 * i * i) % 31); };
    EXPECT_EQ(why("/data", H5T_IEEE_F64LE, {6, 8}, values_of(48, rough)), "");
    EXPECT_EQ(why("/line", H5T_IEEE_F64LE, {40}, values_of(40, rough)), "");
    EXPECT_NE(why("/line", H5T_IEEE_F64LE, {40}, values_of(40, rough), true).find("one dimension"), std::string::npos);
    EXPECT_NE(
        why("/index", H5T_STD_I64LE, {40}, values_of(40, [](std::size_t i) { return 2.0 * static_cast<double>(i); }))
            .find("an index"),
        std::string::npos);
    EXPECT_NE(why("/x", H5T_IEEE_F64LE, {40}, values_of(40, [](std::size_t i) { return 0.3 * static_cast<double>(i); }))
                  .find("positions"),
              std::string::npos);
    EXPECT_NE(why("/preview", H5T_STD_U8LE, {6, 8}, values_of(48, rough)).find("8 bits"), std::string::npos);
    EXPECT_NE(why("/counts", H5T_STD_I32LE, {6, 8}, values_of(48, rough)).find("whole numbers"), std::string::npos);
    EXPECT_NE(why("/points", H5T_IEEE_F64LE, {40, 3}, values_of(120, rough)).find("a table of 3 columns"),
              std::string::npos);
    EXPECT_NE(
        why("/grid_x", H5T_IEEE_F64LE, {6, 8}, values_of(48, [](std::size_t i) { return static_cast<double>(i % 8); }))
            .find("coordinates"),
        std::string::npos);
    EXPECT_NE(
        why("/grid_y", H5T_IEEE_F64LE, {6, 8}, values_of(48, [](std::size_t i) { return static_cast<double>(i / 8); }))
            .find("coordinates"),
        std::string::npos);
    for (const char* name : {"/fft", "/psd", "/power spectrum", "/correlation", "/layer/weights"})
        EXPECT_NE(why(name, H5T_IEEE_F64LE, {6, 8}, values_of(48, rough)).find("its name means"), std::string::npos);
    EXPECT_NE(why("/ids", H5T_IEEE_F64LE, {6, 8}, values_of(48, [](std::size_t i) { return static_cast<double>(i); }))
                  .find("an index"),
              std::string::npos);
    EXPECT_NE(why("/t/_i_t/sorted", H5T_IEEE_F64LE, {6, 8}, values_of(48, rough)).find("PyTables"), std::string::npos);
    EXPECT_EQ(why("/height", H5T_STD_I32LE, {6, 8}, values_of(48, rough)), "") << "named so";
}

TEST(Hdf5, DoubtfulArraysAreReadWhenChosen) {
    Hdf5Builder file;
    file.dataset("/counts", H5T_STD_I32LE, {3, 2}, {1, 2, 3, 5, 4, 6});
    const auto channels = channels_of(file.bytes());
    EXPECT_FALSE(channels[0].info.is_height);
    EXPECT_DOUBLE_EQ(std::get<HeightMap>(channels[0].read()).heights(1, 1), 5e-9);
    EXPECT_THROW((void)chosen_channels("f", channels, std::nullopt), InvalidArgument);
}

TEST(Hdf5, FilesOfElectronMicroscopyAreNotArrays) {
    Hdf5Builder velox, ncem;
    velox.group("/Data").group("/Data/Image").group("/Data/Image/1");
    velox.dataset("/Data/Image/1/Metadata", H5T_STD_U8LE, {60, 1}, numbers(60));
    ncem.group("/data").group("/data/image").attribute("/data/image", "emd_group_type", std::vector<double>{1.0});
    ncem.dataset("/data/image/data", H5T_IEEE_F64LE, {3, 2}, numbers(6));
    for (const auto& content : {velox.bytes(), ncem.bytes()})
        EXPECT_NE(message_of([&] { (void)channels_of(content); }).find("an EMD file of electron microscopy"),
                  std::string::npos);
}

}  // namespace
}  // namespace setae::formats::hdf5_test
