// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"
#include "stored_array.hpp"

namespace setae::bytes {
struct Hdf5Handle;
}

namespace setae::formats {

/// A record of a compound type, its members in order: the texts, and all numbers of the others.
struct Hdf5Record {
    std::vector<std::string> texts;
    std::vector<double> numbers;
};

/// An HDF5 file open for reading, on disk or in memory. Only what stands in the file itself is seen: links, values and
/// virtual datasets that lead elsewhere are not followed. Numbers of objects, depth and length of texts are bounded.
///
/// HDF5 1.10 checks little of a file's structure: what can be is checked before it sees the file (signature, version,
/// end of file), and values are read by setae itself, by their places in the file or piece by piece.
class Hdf5File {
public:
    /// @throws FormatError for bytes that are no HDF5, are truncated, or that the library refuses.
    explicit Hdf5File(const bytes::Source& source);

    /// Paths of all datasets, such as "/group/height", groups' members by name.
    [[nodiscard]] std::vector<std::string> datasets() const;
    /// Names of what a group holds, sorted; nothing where there is no such group.
    [[nodiscard]] std::vector<std::string> members(const std::string& group) const;
    /// A dataset of integers or floats; nothing where there is none of that path, or its values are no plain numbers.
    /// What the library cannot open has a refusal and no shape.
    /// @throws FormatError for one that announces more than its file can hold.
    [[nodiscard]] std::optional<StoredArray> array(const std::string& path) const;
    /// The one number of a dataset; nothing where there is none of that path, or more values, or none of a number.
    [[nodiscard]] std::optional<double> number(const std::string& path) const;
    /// Texts and numbers that an object, "/" for the file, has as attributes; of several texts the first.
    [[nodiscard]] Attributes attributes(const std::string& path) const;
    /// The first record that an object has as attribute.
    [[nodiscard]] std::optional<Hdf5Record> record_attribute(const std::string& path, const std::string& name) const;
    /// The records of a dataset; empty where there is none of that path or its values are no records.
    [[nodiscard]] std::vector<Hdf5Record> records(const std::string& path) const;

private:
    bytes::Source source_;
    std::shared_ptr<const bytes::Hdf5Handle> file_;
};

}  // namespace setae::formats
