// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hdf5.h>

#include <bit>
#include <optional>
#include <string>
#include <vector>

#include "stored_array.hpp"

namespace setae::formats {

/// Integers and floats as processors have them.
struct Hdf5Number {
    Sample sample;
    std::endian order;
};

/// The numbers of a type; nothing for any other type.
[[nodiscard]] std::optional<Hdf5Number> hdf5_number(hid_t type);

/// An open dataset and what is read of it to find its values.
struct Hdf5Dataset {
    const bytes::Source& source;
    const std::string& path;
    hid_t data, type, properties;
    const std::vector<hsize_t>& extents;
};

/// Tells an array where its values lie: in the file, in pieces that are unpacked when asked for, or in the dataset's
/// header; or why they cannot be read: values in other files or datasets, never written, packed with filters that setae
/// does not unpack, or so many that the bytes there are cannot have been them.
/// @throws FormatError for a damaged dataset.
void place_values(const Hdf5Dataset& dataset, StoredArray& array);

}  // namespace setae::formats
