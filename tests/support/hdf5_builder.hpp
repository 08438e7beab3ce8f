// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::tests {

/// Puts an HDF5 file together with the library itself: groups, datasets and attributes by path. It stands on disk while
/// it is made: in memory the library marks newer files as being written for ever.
class Hdf5Builder {
public:
    struct Options {
        bool newest = false;     ///< the newest structures that the library knows, instead of the oldest
        hsize_t user_block = 0;  ///< bytes before the file, a power of 2 from 512
    };
    struct Layout {
        std::vector<hsize_t> chunk = {};  ///< pieces; empty: all values side by side
        bool compact = false;
        bool shuffled = false, deflated = false, summed = false, n_bit = false;
        double fill = 0.0;
    };
    /// Values of a compound attribute: category, unit, parameters.
    struct Converter {
        std::string category, unit;
        std::vector<double> parameters;
    };

    Hdf5Builder() : Hdf5Builder(Options{}) {}
    explicit Hdf5Builder(const Options& options) {
        const Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose), creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
        if (options.newest) H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
        if (options.user_block) H5Pset_userblock(creation, options.user_block);
        static std::atomic<int> counter{0};
        path_ = (std::filesystem::temp_directory_path() /
                 ("setae_sample_" + std::to_string(getpid()) + "_" + std::to_string(counter++) + ".h5"))
                    .string();
        file_ = H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, creation, access);
        require(file_ >= 0);
    }
    Hdf5Builder(const Hdf5Builder&) = delete;
    Hdf5Builder& operator=(const Hdf5Builder&) = delete;
    ~Hdf5Builder() {
        if (file_ >= 0) H5Fclose(file_);
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }

    Hdf5Builder& group(const std::string& path) {
        const Id made(H5Gcreate2(file_, path.c_str(), making(), H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
        return *this;
    }
    /// Values in the order of their indices, the last fastest, converted to `type`; none: announced, never written.
    Hdf5Builder& dataset(const std::string& path, hid_t type, const std::vector<hsize_t>& extents,
                         const std::vector<double>& values) {
        return dataset(path, type, extents, values, Layout{});
    }
    Hdf5Builder& dataset(const std::string& path, hid_t type, const std::vector<hsize_t>& extents,
                         const std::vector<double>& values, const Layout& layout) {
        const Id properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
        H5Pset_fill_value(properties, H5T_NATIVE_DOUBLE, &layout.fill);
        if (layout.compact) H5Pset_layout(properties, H5D_COMPACT);
        if (!layout.chunk.empty()) H5Pset_chunk(properties, static_cast<int>(layout.chunk.size()), layout.chunk.data());
        if (layout.n_bit) H5Pset_nbit(properties);
        if (layout.shuffled) H5Pset_shuffle(properties);
        if (layout.deflated) H5Pset_deflate(properties, 6);
        if (layout.summed) H5Pset_fletcher32(properties);
        const std::vector<hsize_t> unlimited(extents.size(), H5S_UNLIMITED);
        const Id space(H5Screate_simple(static_cast<int>(extents.size()), extents.data(),
                                        layout.chunk.empty() ? nullptr : unlimited.data()),
                       H5Sclose);
        const Id data(H5Dcreate2(file_, path.c_str(), type, space, making(), properties, H5P_DEFAULT), H5Dclose);
        if (!values.empty() && data >= 0)
            H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
        return *this;
    }
    /// A table of texts of fixed width, as compound records.
    Hdf5Builder& text_table(const std::string& path, const std::vector<std::vector<std::string>>& rows,
                            std::size_t width) {
        const std::size_t columns = rows.empty() ? 1 : rows.front().size();
        const Id text(H5Tcopy(H5T_C_S1), H5Tclose), record(H5Tcreate(H5T_COMPOUND, columns * width), H5Tclose);
        H5Tset_size(text, width);
        for (std::size_t k = 0; k < columns; ++k)
            H5Tinsert(record, std::string(1, static_cast<char>('A' + k)).c_str(), k * width, text);
        std::string bytes;
        for (const auto& row : rows)
            for (const auto& cell : row) bytes += cell + std::string(width - std::min(width, cell.size()), '\0');
        const hsize_t count = rows.size();
        const Id space(H5Screate_simple(1, &count, nullptr), H5Sclose);
        const Id data(H5Dcreate2(file_, path.c_str(), record, space, making(), H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
        if (data >= 0 && count > 0) H5Dwrite(data, record, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data());
        return *this;
    }
    Hdf5Builder& attribute(const std::string& path, const std::string& name, const std::string& text) {
        const Id type(H5Tcopy(H5T_C_S1), H5Tclose);
        H5Tset_size(type, text.size() + 1);
        return attribute_of(path, name, type, 1, text.c_str());
    }
    /// A text of variable length, as h5py writes them.
    Hdf5Builder& variable_text(const std::string& path, const std::string& name, const std::string& text) {
        const Id type(H5Tcopy(H5T_C_S1), H5Tclose);
        H5Tset_size(type, H5T_VARIABLE);
        H5Tset_cset(type, H5T_CSET_UTF8);
        const char* characters = text.c_str();
        return attribute_of(path, name, type, 1, &characters);
    }
    Hdf5Builder& attribute(const std::string& path, const std::string& name, const std::vector<double>& numbers) {
        return attribute_of(path, name, H5T_NATIVE_DOUBLE, numbers.size(), numbers.data());
    }
    Hdf5Builder& converter(const std::string& path, const std::string& name, const Converter& converter) {
        struct Record {
            const char *category, *unit;
            hvl_t parameters;
        } record{converter.category.c_str(),
                 converter.unit.c_str(),
                 {converter.parameters.size(), const_cast<double*>(converter.parameters.data())}};
        const Id text(H5Tcopy(H5T_C_S1), H5Tclose), numbers(H5Tvlen_create(H5T_NATIVE_DOUBLE), H5Tclose),
            type(H5Tcreate(H5T_COMPOUND, sizeof(Record)), H5Tclose);
        H5Tset_size(text, H5T_VARIABLE);
        H5Tinsert(type, "Category", HOFFSET(Record, category), text);
        H5Tinsert(type, "BaseUnit", HOFFSET(Record, unit), text);
        H5Tinsert(type, "Parameters", HOFFSET(Record, parameters), numbers);
        return attribute_of(path, name, type, 1, &record);
    }
    /// A link in the file, or into another one.
    Hdf5Builder& soft_link(const std::string& path, const std::string& target) {
        H5Lcreate_soft(target.c_str(), file_, path.c_str(), making(), H5P_DEFAULT);
        return *this;
    }
    Hdf5Builder& external_link(const std::string& path, const std::string& file, const std::string& target) {
        H5Lcreate_external(file.c_str(), target.c_str(), file_, path.c_str(), making(), H5P_DEFAULT);
        return *this;
    }
    Hdf5Builder& hard_link(const std::string& path, const std::string& target) {
        H5Lcreate_hard(file_, target.c_str(), file_, path.c_str(), making(), H5P_DEFAULT);
        return *this;
    }
    /// A dataset whose values lie in another file.
    Hdf5Builder& external_dataset(const std::string& path, const std::vector<hsize_t>& extents,
                                  const std::string& file) {
        const Id properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
        H5Pset_external(properties, file.c_str(), 0, H5F_UNLIMITED);
        const Id space(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), H5Sclose);
        const Id data(H5Dcreate2(file_, path.c_str(), H5T_IEEE_F64LE, space, making(), properties, H5P_DEFAULT),
                      H5Dclose);
        return *this;
    }

    /// The finished file; nothing can be added afterwards.
    [[nodiscard]] std::string bytes() {
        require(H5Fclose(std::exchange(file_, -1)) >= 0);
        std::ifstream file(path_, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

private:
    /// An identifier that closes itself.
    class Id {
    public:
        Id(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
        Id(const Id&) = delete;
        Id& operator=(const Id&) = delete;
        ~Id() {
            if (id_ >= 0) close_(id_);
        }
        operator hid_t() const { return id_; }

    private:
        hid_t id_;
        herr_t (*close_)(hid_t);
    };

    static void require(bool works) {
        if (!works) throw std::runtime_error("sample HDF5 cannot be made");
    }
    /// Groups on the way to an object are made with it.
    static hid_t making() {
        static const hid_t properties = [] {
            const hid_t made = H5Pcreate(H5P_LINK_CREATE);
            H5Pset_create_intermediate_group(made, 1);
            return made;
        }();
        return properties;
    }
    Hdf5Builder& attribute_of(const std::string& path, const std::string& name, hid_t type, hsize_t count,
                              const void* values) {
        const Id object(H5Oopen(file_, path.c_str(), H5P_DEFAULT), H5Oclose);
        const Id space(H5Screate_simple(1, &count, nullptr), H5Sclose);
        const Id made(object >= 0 ? H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT) : -1,
                      H5Aclose);
        if (made >= 0 && count > 0) H5Awrite(made, type, values);
        return *this;
    }

    std::string path_;
    hid_t file_ = -1;
};

/// The values of a map in the order h(x, y), y fast; or line after line from the top.
[[nodiscard]] inline std::vector<double> first_index_x(const Array2D& map) {
    return {map.data(), map.data() + map.size()};
}
[[nodiscard]] inline std::vector<double> first_index_y(const Array2D& map) {
    const Array2D turned = map.transpose();
    return first_index_x(turned);
}

}  // namespace setae::tests
