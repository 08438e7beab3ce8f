// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdf5_chunks.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "setae/bytes/expand.hpp"
#include "setae/bytes/stored_numbers.hpp"
#include "setae/core/errors.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::formats {
namespace {

[[noreturn]] void damaged(const bytes::Source& source, const std::string& path, const std::string& what) {
    throw FormatError(source.name, {}, fmt::format("HDF5: {} of dataset {:.200}; the file is damaged", what, path));
}

/// Sums of pairs of bytes modulo 65535, as in the filter of HDF5: Fletcher 1982.
std::uint32_t fletcher32(std::string_view bytes) {
    constexpr std::size_t pairs_before_overflow = 360;
    std::uint32_t first = 0, second = 0;
    const auto folded = [](std::uint32_t sum) { return (sum & 0xffff) + (sum >> 16); };
    const auto add = [&](std::uint32_t pair) { second += first += pair; };
    const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])); };
    for (std::size_t at = 0; at + 1 < bytes.size();) {
        const auto end = std::min(at + 2 * pairs_before_overflow, bytes.size() / 2 * 2);
        for (; at < end; at += 2) add(byte(at) << 8 | byte(at + 1));
        first = folded(first);
        second = folded(second);
    }
    if (bytes.size() % 2 == 1) {
        add(byte(bytes.size() - 1) << 8);
        first = folded(first);
        second = folded(second);
    }
    return folded(second) << 16 | folded(first);
}

/// The bytes of each value contiguous again; bytes of an incomplete value remain at the end.
std::string unshuffled(const std::string& bytes, std::size_t value_bytes) {
    if (value_bytes < 2) return bytes;
    const auto values = bytes.size() / value_bytes;
    std::string restored(bytes);
    for (std::size_t k = 0; k < value_bytes; ++k)
        for (std::size_t i = 0; i < values; ++i) restored[i * value_bytes + k] = bytes[k * values + i];
    return restored;
}

bytes::Hdf5Handle opened_dataset(hid_t file, const std::string& path) {
    const bytes::Hdf5Session session;
    return {H5Dopen2(file, path.c_str(), H5P_DEFAULT), &H5Dclose};
}

}  // namespace

bool unpacks(H5Z_filter_t filter) {
    return filter == H5Z_FILTER_DEFLATE || filter == H5Z_FILTER_SHUFFLE || filter == H5Z_FILTER_FLETCHER32;
}

ChunkedValues::ChunkedValues(const bytes::Source& source, Hdf5Chunks chunks)
    : source_(source),
      chunks_(std::move(chunks)),
      file_(bytes::opened_hdf5(source)),
      data_(opened_dataset(file_, chunks_.path)) {
    if (!data_) damaged(source_, chunks_.path, "no header");
}

std::string ChunkedValues::unpacked_piece(std::uint64_t row, std::uint64_t column) const {
    const std::vector<hsize_t> both{row * chunks_.chunk_rows(), column * chunks_.chunk_columns()};
    const std::vector<hsize_t> place(both.begin(), both.begin() + static_cast<std::ptrdiff_t>(chunks_.extents.size()));
    const auto expected = chunks_.chunk_rows() * chunks_.chunk_columns() * chunks_.value_bytes;
    hsize_t stored = 0;
    if (H5Dget_chunk_storage_size(data_, place.data(), &stored) < 0 || stored == 0) {
        std::string filled;
        for (hsize_t n = expected / chunks_.value_bytes; n > 0; --n) filled += chunks_.fill;
        return filled;
    }
    if (stored > source_.size) damaged(source_, chunks_.path, fmt::format("a piece of {} bytes", stored));
    std::string bytes(stored, '\0');
    std::uint32_t skipped = 0;
    if (H5Dread_chunk(data_, H5P_DEFAULT, place.data(), &skipped, bytes.data()) < 0)
        damaged(source_, chunks_.path, "an unreadable piece");
    for (auto k = chunks_.filters.size(); k-- > 0;) {
        if (k < 32 && (skipped >> k & 1)) continue;
        const auto& filter = chunks_.filters[k];
        if (filter.id == H5Z_FILTER_DEFLATE) {
            bytes = bytes::inflated(bytes, source_, 0, "HDF5");
        } else if (filter.id == H5Z_FILTER_SHUFFLE) {
            bytes = unshuffled(bytes, filter.first_parameter ? filter.first_parameter : chunks_.value_bytes);
        } else {
            if (bytes.size() < 4) damaged(source_, chunks_.path, "a piece without checksum");
            const auto sum = bytes::load<std::uint32_t>(bytes.data() + bytes.size() - 4, std::endian::little);
            bytes.resize(bytes.size() - 4);
            if (fletcher32(bytes) != sum) damaged(source_, chunks_.path, "a wrong checksum");
        }
    }
    if (bytes.size() != expected)
        damaged(source_, chunks_.path, fmt::format("a piece of {} bytes, expected {}", bytes.size(), expected));
    return bytes;
}

std::string ChunkedValues::unpacked_band(std::uint64_t index) const {
    const bytes::Hdf5Session session;
    const auto first = index * chunks_.chunk_rows(), rows = std::min(chunks_.chunk_rows(), chunks_.rows() - first);
    const auto row_bytes = chunks_.columns() * chunks_.value_bytes;
    std::string values(rows * row_bytes, '\0');
    for (std::uint64_t column = 0; column * chunks_.chunk_columns() < chunks_.columns(); ++column) {
        const auto piece = unpacked_piece(index, column);
        const auto left = column * chunks_.chunk_columns(),
                   width = std::min(chunks_.chunk_columns(), chunks_.columns() - left);
        for (hsize_t row = 0; row < rows; ++row)
            std::memcpy(values.data() + row * row_bytes + left * chunks_.value_bytes,
                        piece.data() + row * chunks_.chunk_columns() * chunks_.value_bytes,
                        width * chunks_.value_bytes);
    }
    return values;
}

const std::string& ChunkedValues::band(std::uint64_t index) {
    const auto max_kept = static_cast<std::size_t>(parallel::Threads{}.resolved()) + 1;
    std::erase(last_used_, index);
    last_used_.push_back(index);
    if (const auto found = bands_.find(index); found != bands_.end()) return found->second;
    if (last_used_.size() > max_kept) {
        bands_.erase(last_used_.front());
        last_used_.erase(last_used_.begin());
    }
    return bands_[index] = unpacked_band(index);
}

void ChunkedValues::read(std::uint64_t offset, std::uint64_t count, char* target) {
    const auto band_bytes = chunks_.chunk_rows() * chunks_.columns() * chunks_.value_bytes;
    while (count > 0) {
        const auto& values = band(offset / band_bytes);
        const std::uint64_t from = offset % band_bytes, taken = std::min<std::uint64_t>(count, values.size() - from);
        std::memcpy(target, values.data() + from, taken);
        target += taken;
        offset += taken;
        count -= taken;
    }
}

}  // namespace setae::formats
