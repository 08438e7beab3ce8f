// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// While one lives no other thread uses HDF5, which may be built without care for threads, and the library does not
/// print. Sessions may stand inside each other, also in a child process that was begun in one.
class Hdf5Session {
public:
    Hdf5Session();
    Hdf5Session(const Hdf5Session&) = delete;
    Hdf5Session& operator=(const Hdf5Session&) = delete;
    ~Hdf5Session();

private:
    H5E_auto2_t reporter_ = nullptr;
    void* reporter_data_ = nullptr;
};

/// An identifier of HDF5, closed with its scope.
struct Hdf5Handle {
    Hdf5Handle(hid_t handle, herr_t (*closer)(hid_t)) : id(handle), close(closer) {}
    Hdf5Handle(Hdf5Handle&& other) noexcept : id(std::exchange(other.id, -1)), close(other.close) {}
    Hdf5Handle& operator=(Hdf5Handle&&) = delete;
    ~Hdf5Handle();
    explicit operator bool() const { return id >= 0; }
    operator hid_t() const { return id; }

    hid_t id;
    herr_t (*close)(hid_t);
};

/// Where the signature of HDF5 stands: at the start, or behind a block of the user's of 512, 1024, 2048 … bytes;
/// nothing where it is not among the bytes given.
[[nodiscard]] std::optional<std::uint64_t> find_hdf5(std::string_view head);

/// @throws FormatError for bytes that are no HDF5, are truncated, or that the library refuses.
[[nodiscard]] Hdf5Handle opened_hdf5(const Source& source);

/// Number of values of extents, times `start`; the largest number there is where it would be more.
[[nodiscard]] std::uint64_t hdf5_product(const std::vector<hsize_t>& extents, std::uint64_t start = 1);

/// Extents of a dataset or attribute's dataspace; of a single value none.
[[nodiscard]] std::vector<hsize_t> hdf5_extents(hid_t space);

}  // namespace setae::bytes
