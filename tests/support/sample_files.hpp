// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>
#include <zip.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace setae::tests {

/// A folder of its own that goes away with the test.
class TemporaryFolder {
public:
    TemporaryFolder() {
        static std::atomic<int> counter{0};
        folder_ = std::filesystem::temp_directory_path() / fmt::format("setae_io_{}_{}", getpid(), counter++);
        std::filesystem::create_directories(folder_);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
    /// Writes a file and returns its path.
    std::string write(const std::string& name, std::string_view content) const {
        std::ofstream(path(name), std::ios::binary) << content;
        return path(name);
    }

private:
    std::filesystem::path folder_;
};

/// Members of a ZIP archive, in order.
using Members = std::vector<std::pair<std::string, std::string>>;
[[nodiscard]] inline std::string zip_archive(const Members& members) {
    zip_error_t error;
    zip_error_init(&error);
    auto* buffer = zip_source_buffer_create(nullptr, 0, 0, &error);
    zip_source_keep(buffer);
    auto* archive = zip_open_from_source(buffer, ZIP_TRUNCATE, &error);
    for (const auto& [name, content] : members) {
        auto* source = zip_source_buffer(archive, content.data(), content.size(), 0);
        if (zip_file_add(archive, name.c_str(), source, ZIP_FL_OVERWRITE) < 0) zip_source_free(source);
    }
    if (zip_close(archive) != 0) throw std::runtime_error("sample archive cannot be written");
    zip_stat_t stat;
    zip_source_stat(buffer, &stat);
    std::string bytes(stat.size, '\0');
    zip_source_open(buffer);
    const auto got = zip_source_read(buffer, bytes.data(), bytes.size());
    if (got != static_cast<zip_int64_t>(bytes.size())) throw std::runtime_error("sample archive cannot be read back");
    zip_source_close(buffer);
    zip_source_free(buffer);
    return bytes;
}

/// Little-endian bytes of values.
template <class Value>
[[nodiscard]] std::string bytes_of(const std::vector<Value>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
}

inline std::string image_section(const std::string& name, const std::string& scale, int nx, int ny, int bytes,
                                 int offset) {
    return fmt::format(
        "\\*Ciao image list\r\n\\Data offset: {}\r\n\\Data length: {}\r\n\\Bytes/pixel: {}\r\n\\Samps/line: {}\r\n"
        "\\Number of lines: {}\r\n\\Scan Size: 500 250 nm\r\n\\@2:Image Data: S [{}] \"{}\"\r\n\\@2:Z scale: {}\r\n",
        offset, nx * ny * bytes, bytes, nx, ny, name, name, scale);
}

template <class Integer>
std::string ramp(int nx, int ny) {
    std::vector<Integer> values;
    for (int row = 0; row < ny; ++row)
        for (int i = 0; i < nx; ++i) values.push_back(static_cast<Integer>(10 * i + row));
    return bytes_of(values);
}

/// A Nanoscope file of one height image: raw(i, row) = 10 i + row for nx × ny values of 2 or 4 bytes, rows from the
/// bottom; 500 × 250 nm, hard value 2 V, sensitivity 20 nm/V; behind it a phase image.
[[nodiscard]] inline std::string nanoscope_file(int nx, int ny, int bytes) {
    constexpr int header_bytes = 4096;
    const int image_bytes = nx * ny * bytes;
    std::string header =
        "\\*File list\r\n\\Version: 0x07200000\r\n\\Date: 09:57:48 AM Tue Jan 12 2016\r\n\\*Equipment list\r\n"
        "\\Description: Dimension V\r\n\\*Scanner list\r\n\\@Sens. Zsens: V 20.00000 nm/V\r\n\\*Ciao scan list\r\n"
        "\\@Sens. Phase: V 1.000000 \r\n";
    header += image_section("Height", "V [Sens. Zsens] (0.0000305 V/LSB) 2.000000 V", nx, ny, bytes, header_bytes);
    header +=
        image_section("Phase", "V [Sens. Phase] (0.0003 V/LSB) 20.00000 V", nx, ny, bytes, header_bytes + image_bytes);
    header += "\\*File list end\r\n\x1a";
    header.resize(header_bytes, '\0');
    const auto image = bytes == 2 ? ramp<std::int16_t>(nx, ny) : ramp<std::int32_t>(nx, ny);
    return header + image + image;
}

/// main.xml of an X3P file; the last two are the inner XML of the dimensions and of the link or list of points.
[[nodiscard]] inline std::string x3p_document(const std::string& feature, const std::string& axis_x,
                                              const std::string& axis_z, const std::string& dimensions,
                                              const std::string& points) {
    return fmt::format(R"(<?xml version="1.0" encoding="UTF-8"?>
<p:ISO5436_2 xmlns:p="http://www.opengps.eu/2008/ISO5436_2"><Record1><Revision>ISO5436 - 2000</Revision>
<FeatureType>{}</FeatureType><Axes><CX>{}</CX>
<CY><AxisType>I</AxisType><DataType>D</DataType><Increment>2e-6</Increment></CY><CZ>{}</CZ></Axes></Record1>
<Record2><Date>2020-01-02</Date><Instrument><Manufacturer>M</Manufacturer><Model>Scope</Model></Instrument></Record2>
<Record3>{}{}</Record3></p:ISO5436_2>)",
                       feature, axis_x, axis_z, dimensions, points);
}

/// A container with index.json of a text line scan (scale 2 in the index), a Nanoscope image (the index repeats a
/// scale) and a damaged one between them.
[[nodiscard]] inline std::string container_file() {
    const std::string index = R"({"versions": {}, "surfaces": [{"name": "wafer", "topographies": [
{"name": "line", "datafile": {"original": "line.txt"}, "unit": "um", "size": [4.0], "height_scale": 2.0, "detrend_mode": "curvature",
 "is_periodic": true, "instrument": {"name": "P", "type": "contact-based", "parameters": {"tip_radius": {"value": 5.0, "unit": "um"}}}},
{"name": "damaged", "datafile": {"original": "damaged.di"}, "unit": "nm", "size": [500.0, 250.0]},
{"name": "image", "datafile": {"original": "image.di"}, "data_source": 0, "unit": "nm", "size": [500.0, 250.0],
 "height_scale": 0.0006103515625, "detrend_mode": "height"}]}]})";
    const auto image = nanoscope_file(4, 3, 2);
    return zip_archive({{"index.json", index},
                        {"line.txt", "0 1\n1 3\n2 2\n3 5\n"},
                        {"damaged.di", image.substr(0, 4100)},
                        {"image.di", image}});
}

}  // namespace setae::tests
