// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include <hdf5.h>

#include "micrograph_files.hpp"

namespace setae::imaging::tests {

/// An EMD made by the HDF5 library in memory.
struct EmdFile {
    bool velox = false;
    hid_t type = H5T_STD_I16LE;                      ///< of the numbers in the file
    std::vector<hsize_t> sides;                      ///< empty: the common picture
    bool packed = false;                             ///< in chunks, deflated; only NCEM layout
    std::string unit_x = "[n_m]", unit_y = "[n_m]";  ///< as fixed text; Velox uses the unit of the first for pixels
    double step_x = 0.5, step_y = 0.25;
    bool pixels_written = true;
    std::optional<std::string> metadata;  ///< Velox JSON; not given: from step, unit and a Titan of 300 kV

    [[nodiscard]] std::string bytes() const {
        const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
        H5Pset_fapl_core(access, 1 << 12, 0);
        const hid_t file = H5Fcreate("emd", H5F_ACC_TRUNC, H5P_DEFAULT, access);
        if (velox) write_velox(file);
        else write_ncem(file);
        H5Fflush(file, H5F_SCOPE_GLOBAL);
        std::string content(static_cast<std::size_t>(H5Fget_file_image(file, nullptr, 0)), '\0');
        H5Fget_file_image(file, content.data(), content.size());
        H5Fclose(file);
        H5Pclose(access);
        return content;
    }

private:
    /// A dataset whose numbers are 1, 2, 3 …, each `repeats` times.
    hid_t dataset(hid_t group, const char* name, const std::vector<hsize_t>& shape, std::size_t repeats) const {
        const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                    properties = H5Pcreate(H5P_DATASET_CREATE);
        if (packed || !pixels_written) {
            auto chunk = shape;
            for (auto& side : chunk) side = std::clamp<hsize_t>(side, 1, 16);
            H5Pset_chunk(properties, static_cast<int>(shape.size()), chunk.data());
        }
        if (packed) H5Pset_deflate(properties, 6);
        const hid_t data = H5Dcreate2(group, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
        if (pixels_written) {
            std::vector<double> values;
            for (std::size_t i = 0;
                 i < std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>()); ++i)
                values.push_back(1.0 + static_cast<double>(i / repeats));
            H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
        }
        H5Sclose(space);
        H5Pclose(properties);
        return data;
    }
    static hid_t group_in(hid_t place, const char* name) {
        return H5Gcreate2(place, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    }
    static void text(hid_t object, const char* name, const std::string& value) {
        const hid_t kind = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
        H5Tset_size(kind, value.size() + 1);
        const hid_t attribute = H5Acreate2(object, name, kind, space, H5P_DEFAULT, H5P_DEFAULT);
        H5Awrite(attribute, kind, value.c_str());
        H5Aclose(attribute);
        H5Sclose(space);
        H5Tclose(kind);
    }
    static void dimension(hid_t group, const std::string& name, double step, const std::string& unit) {
        const hsize_t count = 2;
        const hid_t space = H5Screate_simple(1, &count, nullptr),
                    data =
                        H5Dcreate2(group, name.c_str(), H5T_IEEE_F32LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        const double positions[] = {10, 10 + step};
        H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, positions);
        text(data, "units", unit);
        H5Dclose(data);
        H5Sclose(space);
    }
    void write_ncem(hid_t file) const {
        const hid_t outer = group_in(file, "data"), group = group_in(outer, "image"), space = H5Screate(H5S_SCALAR);
        const hid_t attribute = H5Acreate2(group, "emd_group_type", H5T_STD_I32LE, space, H5P_DEFAULT, H5P_DEFAULT);
        const int one = 1;
        H5Awrite(attribute, H5T_NATIVE_INT, &one);
        const auto shape = sides.empty() ? std::vector<hsize_t>{rows, columns} : sides;
        H5Dclose(dataset(group, "data", shape, 1));
        dimension(group, "dim" + std::to_string(shape.size() - 1), step_y, unit_y);
        dimension(group, "dim" + std::to_string(shape.size()), step_x, unit_x);
        H5Aclose(attribute);
        H5Sclose(space);
        H5Gclose(group);
        H5Gclose(outer);
    }
    void write_velox(hid_t file) const {
        const hid_t outer = group_in(file, "Data"), images = group_in(outer, "Image"),
                    image = group_in(images, "0123abcd");
        H5Dclose(dataset(image, "Data", sides.empty() ? std::vector<hsize_t>{rows, columns, 2} : sides, 2));
        const std::string json = metadata.value_or(
            R"({"BinaryResult": {"PixelSize": {"width": ")" + std::to_string(step_x) + R"(", "height": ")" +
            std::to_string(step_y) + R"("}, "PixelUnitX": ")" + unit_x + R"(", "PixelUnitY": ")" + unit_x +
            R"("}, "Instrument": {"InstrumentClass": "Titan"}, "Optics": {"AccelerationVoltage": "300000"}})");
        const hsize_t shape[] = {json.size() + 5, 1};
        const hid_t space = H5Screate_simple(2, shape, nullptr),
                    data = H5Dcreate2(image, "Metadata", H5T_STD_U8LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        const std::string padded = json + std::string(5, '\0');
        H5Dwrite(data, H5T_NATIVE_UCHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data());
        H5Dclose(data);
        H5Sclose(space);
        H5Gclose(image);
        H5Gclose(images);
        H5Gclose(outer);
    }
};

}  // namespace setae::imaging::tests
