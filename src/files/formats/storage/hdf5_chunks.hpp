// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hdf5.h>

#include <map>
#include <string>
#include <vector>

#include "setae/bytes/hdf5_handle.hpp"
#include "setae/bytes/source.hpp"

namespace setae::formats {

/// Chunks of a dataset of one or two dimensions, and their filters.
struct Hdf5Chunks {
    std::string path;
    std::vector<hsize_t> extents, chunk;
    std::size_t value_bytes = 0;

    struct Filter {
        H5Z_filter_t id = 0;
        std::size_t first_parameter = 0;
    };
    std::vector<Filter> filters;  ///< in the order in which they were applied
    std::string fill;             ///< bytes of the value of chunks never written

    [[nodiscard]] hsize_t rows() const { return extents[0]; }
    [[nodiscard]] hsize_t columns() const { return extents.size() > 1 ? extents[1] : 1; }
    [[nodiscard]] hsize_t chunk_rows() const { return chunk[0]; }
    [[nodiscard]] hsize_t chunk_columns() const { return chunk.size() > 1 ? chunk[1] : 1; }
};

/// Whether setae implements this filter, with bounds: deflate, shuffle and Fletcher's checksum.
[[nodiscard]] bool unpacks(H5Z_filter_t filter);

/// The values of a dataset in chunks as a contiguous sequence. Rows of chunks are unpacked on request; the last few are
/// kept, so readers of several parts of the file in parallel unpack each chunk once. From one thread at a time.
class ChunkedValues {
public:
    ChunkedValues(const bytes::Source& source, Hdf5Chunks chunks);

    /// @throws FormatError for a chunk that is damaged or expands to more than max_expanded.
    void read(std::uint64_t offset, std::uint64_t count, char* target);

private:
    [[nodiscard]] const std::string& band(std::uint64_t index);
    [[nodiscard]] std::string unpacked_band(std::uint64_t index) const;
    [[nodiscard]] std::string unpacked_piece(std::uint64_t row, std::uint64_t column) const;

    bytes::Source source_;
    Hdf5Chunks chunks_;
    bytes::Hdf5Handle file_, data_;
    std::map<std::uint64_t, std::string> bands_;
    std::vector<std::uint64_t> last_used_;
};

}  // namespace setae::formats
