// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdf5_layout.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "hdf5_chunks.hpp"
#include "on_demand.hpp"
#include "setae/bytes/expand.hpp"
#include "setae/bytes/hdf5_handle.hpp"
#include "setae/core/errors.hpp"

namespace setae::formats {
namespace {

constexpr std::uint64_t max_compact_bytes = 1 << 16;

[[noreturn]] void broken_layout(const bytes::Source& source, const std::string& what) {
    throw FormatError(source.name, {}, "HDF5: " + what);
}

void refuse_elsewhere(StoredArray& array, const char* where) {
    array.refusal =
        fmt::format("HDF5: the values of {:.200} are {}; copy them into one file with h5repack", array.name, where);
}

/// Few values are stored in the header of the dataset.
void place_compact(const Hdf5Dataset& dataset, std::uint64_t bytes, StoredArray& array) {
    if (bytes > max_compact_bytes)
        broken_layout(dataset.source, fmt::format("dataset {:.200} has {} bytes in its header; the file is damaged",
                                                  dataset.path, bytes));
    std::string values(bytes, '\0');
    if (H5Dread(dataset.data, dataset.type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
        broken_layout(dataset.source, fmt::format("dataset {:.200} cannot be read; the file is damaged", dataset.path));
    array.data = bytes::memory_source(dataset.source.name, std::move(values));
}

void place_contiguous(const Hdf5Dataset& dataset, StoredArray& array) {
    if (H5Pget_external_count(dataset.properties) > 0) return refuse_elsewhere(array, "in other files");
    const auto offset = H5Dget_offset(dataset.data);
    if (offset == HADDR_UNDEF) {
        array.refusal =
            fmt::format("HDF5: dataset {:.200} was announced, but its values were never written", dataset.path);
        return;
    }
    array.data = dataset.source;
    array.offset = offset;
}

std::string fill_value(const Hdf5Dataset& dataset, std::size_t bytes) {
    std::string fill(bytes, '\0');
    H5D_fill_value_t state = H5D_FILL_VALUE_UNDEFINED;
    if (H5Pfill_value_defined(dataset.properties, &state) >= 0 && state != H5D_FILL_VALUE_UNDEFINED)
        H5Pget_fill_value(dataset.properties, dataset.type, fill.data());
    return fill;
}

/// Values in chunks: refused if the stored bytes are too few, otherwise read through ChunkedValues.
void place_chunked(const Hdf5Dataset& dataset, std::uint64_t bytes, StoredArray& array) {
    Hdf5Chunks chunks{dataset.path,
                      dataset.extents,
                      std::vector<hsize_t>(dataset.extents.size()),
                      static_cast<std::size_t>(bytes_of(array.sample)),
                      {},
                      {}};
    if (H5Pget_chunk(dataset.properties, static_cast<int>(chunks.chunk.size()), chunks.chunk.data()) < 0 ||
        bytes::hdf5_product(chunks.chunk) == 0)
        broken_layout(dataset.source,
                      fmt::format("dataset {:.200} has pieces of size 0; the file is damaged", dataset.path));
    for (int k = 0; k < H5Pget_nfilters(dataset.properties); ++k) {
        unsigned flags = 0, parameter = 0;
        std::size_t parameters = 1;
        const auto id = H5Pget_filter2(dataset.properties, static_cast<unsigned>(k), &flags, &parameters, &parameter, 0,
                                       nullptr, nullptr);
        if (!unpacks(id)) {
            array.refusal = fmt::format(
                "HDF5: dataset {:.200} is packed with filter {}, which is not supported; repack the file with "
                "h5repack -f GZIP=4",
                dataset.path, static_cast<int>(id));
            return;
        }
        chunks.filters.push_back({id, parameters > 0 ? parameter : 0});
    }
    const auto stored = std::min<std::uint64_t>(H5Dget_storage_size(dataset.data), dataset.source.size);
    const auto most = bytes::max_expanded(stored), piece_bytes = bytes::hdf5_product(chunks.chunk, chunks.value_bytes);
    if (bytes > most || piece_bytes > most) {
        array.refusal = fmt::format(
            "HDF5: dataset {:.200} of {} bytes in pieces of {} has {} bytes in the file; it is damaged, or a map of one value",
            dataset.path, bytes, piece_bytes, stored);
        return;
    }
    std::uint64_t pieces = 1;
    for (std::size_t k = 0; k < chunks.chunk.size(); ++k)
        pieces *= (dataset.extents[k] + chunks.chunk[k] - 1) / chunks.chunk[k];
    if (pieces > dataset.source.size / 8 + 4096) {
        array.refusal = fmt::format(
            "HDF5: dataset {:.200} is divided into {} pieces, more than the file can contain; it is damaged",
            dataset.path, pieces);
        return;
    }
    chunks.fill = fill_value(dataset, chunks.value_bytes);

    struct Guarded {
        std::mutex guard;
        ChunkedValues values;
        Guarded(const bytes::Source& source, const Hdf5Chunks& chunks) : values(source, chunks) {}
    };
    const auto values = std::make_shared<OnDemand<Guarded>>(
        [source = dataset.source, chunks] { return std::make_shared<Guarded>(source, chunks); });
    array.data = {
        dataset.source.name,
        bytes,
        {},
        [values, name = dataset.source.name, size = bytes](std::uint64_t offset, std::uint64_t count, char* target) {
            if (offset > size || count > size - offset)
                throw FormatError(name, {}, "HDF5: values beyond the end of their dataset");
            const auto kept = values->hold();
            const std::lock_guard lock(kept->guard);
            kept->values.read(offset, count, target);
        }};
    array.hold = [values] { return values->hold(); };
}

}  // namespace

std::optional<Hdf5Number> hdf5_number(hid_t type) {
    const struct {
        hid_t little, big;
        Sample sample;
    } known[] = {{H5T_STD_I8LE, H5T_STD_I8BE, Sample::int8},        {H5T_STD_U8LE, H5T_STD_U8BE, Sample::uint8},
                 {H5T_STD_I16LE, H5T_STD_I16BE, Sample::int16},     {H5T_STD_U16LE, H5T_STD_U16BE, Sample::uint16},
                 {H5T_STD_I32LE, H5T_STD_I32BE, Sample::int32},     {H5T_STD_U32LE, H5T_STD_U32BE, Sample::uint32},
                 {H5T_STD_I64LE, H5T_STD_I64BE, Sample::int64},     {H5T_STD_U64LE, H5T_STD_U64BE, Sample::uint64},
                 {H5T_IEEE_F32LE, H5T_IEEE_F32BE, Sample::float32}, {H5T_IEEE_F64LE, H5T_IEEE_F64BE, Sample::float64}};
    for (const auto& one : known) {
        if (H5Tequal(type, one.little) > 0) return Hdf5Number{one.sample, std::endian::little};
        if (H5Tequal(type, one.big) > 0) return Hdf5Number{one.sample, std::endian::big};
    }
    return std::nullopt;
}

void place_values(const Hdf5Dataset& dataset, StoredArray& array) {
    const auto bytes = bytes::hdf5_product(dataset.extents, bytes_of(array.sample));
    if (bytes == std::numeric_limits<std::uint64_t>::max())
        broken_layout(dataset.source,
                      fmt::format("dataset {:.200} announces too many values; the file is damaged", dataset.path));
    switch (H5Pget_layout(dataset.properties)) {
        case H5D_COMPACT: return place_compact(dataset, bytes, array);
        case H5D_CONTIGUOUS: return place_contiguous(dataset, array);
        case H5D_CHUNKED: return place_chunked(dataset, bytes, array);
        default: refuse_elsewhere(array, "in other datasets");
    }
}

}  // namespace setae::formats
