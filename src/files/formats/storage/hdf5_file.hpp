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

/// An HDF5 file open for reading, on disk or in memory. Only content of this file is read: links, values and virtual
/// datasets in other files are not followed. The number of objects, the depth and the length of texts are bounded.
///
/// HDF5 1.10 checks little of the structure of a file. Signature, version and end of file are therefore checked before
/// it opens the file, and setae reads values itself, by their places in the file or chunk by chunk.
class Hdf5File {
public:
    /// @throws FormatError for bytes that are no HDF5, are truncated, or that the library refuses.
    explicit Hdf5File(const bytes::Source& source);

    /// Paths of all datasets, such as "/group/height", groups' members by name.
    [[nodiscard]] std::vector<std::string> datasets() const;
    /// Names of the members of a group, sorted; empty if there is no such group.
    [[nodiscard]] std::vector<std::string> members(const std::string& group) const;
    /// A dataset of integers or floats; empty if there is none at that path, or its values are no plain numbers. A
    /// dataset that the library cannot open has a refusal and no shape.
    /// @throws FormatError for a dataset larger than its file can contain.
    [[nodiscard]] std::optional<StoredArray> array(const std::string& path) const;
    /// The only number of a dataset; empty if there is no dataset at that path, or it has several values or none.
    [[nodiscard]] std::optional<double> number(const std::string& path) const;
    /// Texts and numbers in the attributes of an object, "/" for the file; the first one of several texts.
    [[nodiscard]] Attributes attributes(const std::string& path) const;
    /// The first record that an object has as attribute.
    [[nodiscard]] std::optional<Hdf5Record> record_attribute(const std::string& path, const std::string& name) const;
    /// The records of a dataset; empty if there is none at that path or its values are no records.
    [[nodiscard]] std::vector<Hdf5Record> records(const std::string& path) const;

private:
    bytes::Source source_;
    std::shared_ptr<const bytes::Hdf5Handle> file_;
};

}  // namespace setae::formats
