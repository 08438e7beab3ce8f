// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hdf5.h>

#include <bit>
#include <optional>
#include <string>
#include <vector>

#include "stored_array.hpp"

namespace setae::formats {

/// Integers and floats in native formats.
struct Hdf5Number {
    Sample sample;
    std::endian order;
};

/// The numbers of a type; empty for any other type.
[[nodiscard]] std::optional<Hdf5Number> hdf5_number(hid_t type);

/// An open dataset and the information needed to locate its values.
struct Hdf5Dataset {
    const bytes::Source& source;
    const std::string& path;
    hid_t data, type, properties;
    const std::vector<hsize_t>& extents;
};

/// Sets the places of the values of an array: in the file, in chunks that are unpacked on request, or in the header of
/// the dataset; or the reason why they cannot be read: values in other files or datasets, never written, with
/// unsupported filters, or too many for the size of the file.
/// @throws FormatError for a damaged dataset.
void place_values(const Hdf5Dataset& dataset, StoredArray& array);

}  // namespace setae::formats
