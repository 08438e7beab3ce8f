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

/// While it exists, no other thread uses HDF5, which may be built without thread safety, and the library prints
/// nothing. Sessions may be nested, also in a child process that was started in one.
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

/// Place of the HDF5 signature: at the start, or after a user block of 512, 1024, 2048 … bytes; empty if it is not
/// among the given bytes.
[[nodiscard]] std::optional<std::uint64_t> find_hdf5(std::string_view head);

/// @throws FormatError for bytes that are no HDF5, are truncated, or that the library refuses.
[[nodiscard]] Hdf5Handle opened_hdf5(const Source& source);

/// Product of extents and `start`; the largest representable number on overflow.
[[nodiscard]] std::uint64_t hdf5_product(const std::vector<hsize_t>& extents, std::uint64_t start = 1);

/// Extents of a dataset or attribute's dataspace; of a single value none.
[[nodiscard]] std::vector<hsize_t> hdf5_extents(hid_t space);

}  // namespace setae::bytes
