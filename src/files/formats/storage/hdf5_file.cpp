// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdf5_file.hpp"

#include <hdf5.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>

#include <fmt/format.h>

#include "hdf5_layout.hpp"
#include "setae/bytes/hdf5_handle.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"

namespace setae::formats {
namespace {

constexpr int deepest_group = 16;
constexpr std::size_t max_objects = 10'000, max_hdf5_attributes = 1'000, max_numbers = 4'096, max_records = 100'000;
constexpr std::uint64_t longest_hdf5_text = 1 << 16, max_record_bytes = 1 << 24;

[[noreturn]] void broken_file(const bytes::Source& source, const std::string& what) {
    throw FormatError(source.name, {}, "HDF5: " + what);
}

std::string clean_text(std::string bytes) {
    bytes.resize(std::min(bytes.find('\0'), bytes.size()));
    return std::string(trimmed(bytes::decoded(std::move(bytes), bytes::Encoding::detect)));
}

// ---- content of groups
// -----------------------------------------------------------------------------------------------

herr_t note_member(hid_t, const char* name, const H5L_info_t* link, void* names) {
    auto& found = *static_cast<std::vector<std::string>*>(names);
    if (link->type == H5L_TYPE_HARD && std::strlen(name) < longest_hdf5_text) found.emplace_back(name);
    return found.size() < max_objects ? 0 : 1;
}

std::vector<std::string> members_of(hid_t group) {
    std::vector<std::string> names;
    H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, note_member, &names);
    return names;
}

void find_datasets(hid_t group, const std::string& path, int depth, std::size_t& visited,
                   std::vector<std::string>& found) {
    for (const auto& name : members_of(group)) {
        if (++visited > max_objects) return;
        const bytes::Hdf5Handle member(H5Oopen(group, name.c_str(), H5P_DEFAULT), &H5Oclose);
        const auto type =
            member ? H5Iget_type(member) : H5I_DATASET;  // array() reports objects that the library cannot open
        if (type == H5I_DATASET) found.push_back(path + "/" + name);
        if (type == H5I_GROUP && depth < deepest_group)
            find_datasets(member, path + "/" + name, depth + 1, visited, found);
    }
}

/// The object at a path all of whose links are hard.
bytes::Hdf5Handle opened_object(hid_t file, const std::string& path) {
    bytes::Hdf5Handle object(H5Oopen(file, "/", H5P_DEFAULT), &H5Oclose);
    for (std::size_t at = 0; at < path.size();) {
        const auto end = std::min(path.find('/', at), path.size());
        const auto name = path.substr(at, end - at);
        at = end + 1;
        if (name.empty()) continue;
        H5L_info_t link;
        const bool is_hard = object && H5Iget_type(object) == H5I_GROUP &&
                             H5Lget_info(object, name.c_str(), &link, H5P_DEFAULT) >= 0 && link.type == H5L_TYPE_HARD;
        bytes::Hdf5Handle next(is_hard ? H5Oopen(object, name.c_str(), H5P_DEFAULT) : -1, &H5Oclose);
        std::swap(object.id, next.id);
    }
    return object;
}

/// Whether a group of the file has a hard link at that path, to any object.
bool is_in(hid_t file, const std::string& path) {
    const auto slash = path.rfind('/');
    const auto group = opened_object(file, path.substr(0, slash));
    H5L_info_t link;
    return group && H5Iget_type(group) == H5I_GROUP &&
           H5Lget_info(group, path.substr(slash + 1).c_str(), &link, H5P_DEFAULT) >= 0 && link.type == H5L_TYPE_HARD;
}

// ---- attributes and records -----------------------------------------------------------------------------------------

struct NativeType {
    bytes::Hdf5Handle type;
    std::uint64_t bytes = 0;
};

/// A type in memory. Sizes stated by the file are limited before memory is allocated.
std::optional<NativeType> native(hid_t stored) {
    if (H5Tget_size(stored) > max_record_bytes) return std::nullopt;
    NativeType native{{H5Tget_native_type(stored, H5T_DIR_ASCEND), &H5Tclose}, 0};
    if (!native.type) return std::nullopt;
    native.bytes = H5Tget_size(native.type);
    if (native.bytes == 0 || native.bytes > max_record_bytes) return std::nullopt;
    return native;
}

std::string text_in(const char* value, hid_t type) {
    if (H5Tis_variable_str(type) <= 0)
        return clean_text({value, std::min<std::size_t>(H5Tget_size(type), longest_hdf5_text)});
    const char* text = nullptr;
    std::memcpy(&text, value, sizeof text);
    return text ? clean_text({text, strnlen(text, longest_hdf5_text)}) : std::string{};
}

/// Numbers in memory, converted.
void append_numbers(const char* values, std::size_t count, hid_t type, std::vector<double>& numbers) {
    const auto bytes = H5Tget_size(type);
    if (bytes == 0 || count > max_numbers) return;
    std::string buffer(std::max(bytes, sizeof(double)) * count, '\0');
    std::memcpy(buffer.data(), values, bytes * count);
    if (H5Tconvert(type, H5T_NATIVE_DOUBLE, count, buffer.data(), nullptr, H5P_DEFAULT) < 0) return;
    const auto before = numbers.size();
    numbers.resize(before + count);
    std::memcpy(numbers.data() + before, buffer.data(), count * sizeof(double));
}

bool is_number(H5T_class_t kind) { return kind == H5T_INTEGER || kind == H5T_FLOAT || kind == H5T_ENUM; }

void append_member(const char* value, hid_t type, Hdf5Record& record) {
    const auto kind = H5Tget_class(type);
    if (kind == H5T_STRING) {
        record.texts.push_back(text_in(value, type));
    } else if (is_number(kind)) {
        append_numbers(value, 1, type, record.numbers);
    } else if (kind == H5T_VLEN || kind == H5T_ARRAY) {
        const bytes::Hdf5Handle base(H5Tget_super(type), &H5Tclose);
        if (!base || !is_number(H5Tget_class(base))) return;
        if (kind == H5T_ARRAY)
            return append_numbers(value, H5Tget_size(type) / std::max<std::size_t>(H5Tget_size(base), 1), base,
                                  record.numbers);
        hvl_t list{};
        std::memcpy(&list, value, sizeof list);
        if (list.p) append_numbers(static_cast<const char*>(list.p), list.len, base, record.numbers);
    }
}

Hdf5Record record_in(const char* value, hid_t type) {
    Hdf5Record record;
    for (int k = 0; k < H5Tget_nmembers(type); ++k) {
        const auto member = static_cast<unsigned>(k);
        const bytes::Hdf5Handle member_type(H5Tget_member_type(type, member), &H5Tclose);
        if (member_type) append_member(value + H5Tget_member_offset(type, member), member_type, record);
    }
    return record;
}

/// Values fetched by `read` as `type`, each passed to `take`; memory allocated by the library is freed.
void with_values(hid_t space, const NativeType& type, std::uint64_t count, const std::function<herr_t(void*)>& read,
                 const std::function<void(const char*)>& take) {
    std::string values(count * type.bytes, '\0');
    if (read(values.data()) < 0) return;
    for (std::uint64_t i = 0; i < count; ++i) take(values.data() + i * type.bytes);
    H5Dvlen_reclaim(type.type, space, H5P_DEFAULT, values.data());
}

/// Calls `take` with the type and each value of an attribute of bounded size.
void with_attribute(hid_t object, const std::string& name, const std::function<void(const char*, hid_t)>& take) {
    const bytes::Hdf5Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), &H5Aclose);
    if (!attribute) return;
    const bytes::Hdf5Handle stored(H5Aget_type(attribute), &H5Tclose), space(H5Aget_space(attribute), &H5Sclose);
    const auto type = stored ? native(stored) : std::nullopt;
    const auto points = space ? H5Sget_simple_extent_npoints(space) : -1;
    if (!type || points < 1) return;
    const auto count = static_cast<std::uint64_t>(points);
    if (count > max_numbers || count * type->bytes > max_record_bytes) return;
    with_values(
        space, *type, count, [&](void* values) { return H5Aread(attribute, type->type, values); },
        [&](const char* value) { take(value, type->type); });
}

herr_t note_attribute(hid_t, const char* name, const H5A_info_t*, void* names) {
    auto& found = *static_cast<std::vector<std::string>*>(names);
    found.emplace_back(name);
    return found.size() < max_hdf5_attributes ? 0 : 1;
}

Attributes attributes_of(hid_t object) {
    std::vector<std::string> names;
    H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, note_attribute, &names);
    Attributes attributes;
    for (const auto& name : names) {
        Attribute attribute{name, {}, {}};
        with_attribute(object, name, [&](const char* value, hid_t type) {
            const auto kind = H5Tget_class(type);
            if (kind == H5T_STRING && attribute.text.empty()) attribute.text = text_in(value, type);
            if (is_number(kind)) append_numbers(value, 1, type, attribute.numbers);
        });
        attributes.push_back(std::move(attribute));
    }
    return attributes;
}

/// Whether the chunks of a table are limited in memory, for any stated size: deflate expands one byte to at most a
/// thousand.
bool are_bounded(hid_t data, hid_t properties, std::size_t dimensions) {
    constexpr std::uint64_t max_packed = 1 << 16, max_piece = 1 << 18;
    if (H5Pget_layout(properties) != H5D_CHUNKED)
        return H5Pget_layout(properties) != H5D_VIRTUAL && H5Pget_external_count(properties) == 0;
    std::vector<hsize_t> chunk(dimensions);
    if (H5Pget_chunk(properties, static_cast<int>(chunk.size()), chunk.data()) < 0 ||
        bytes::hdf5_product(chunk) > max_piece)
        return false;
    return H5Pget_nfilters(properties) == 0 || H5Dget_storage_size(data) <= max_packed;
}

}  // namespace

Hdf5File::Hdf5File(const bytes::Source& source)
    : source_(source), file_(std::make_shared<const bytes::Hdf5Handle>(bytes::opened_hdf5(source))) {}

std::vector<std::string> Hdf5File::datasets() const {
    const bytes::Hdf5Session session;
    const bytes::Hdf5Handle root(H5Oopen(*file_, "/", H5P_DEFAULT), &H5Oclose);
    if (!root) broken_file(source_, "no root group; the file is damaged");
    std::vector<std::string> found;
    std::size_t visited = 0;
    find_datasets(root, "", 0, visited, found);
    return found;
}

std::vector<std::string> Hdf5File::members(const std::string& group) const {
    const bytes::Hdf5Session session;
    const auto object = opened_object(*file_, group);
    return object && H5Iget_type(object) == H5I_GROUP ? members_of(object) : std::vector<std::string>{};
}

std::optional<StoredArray> Hdf5File::array(const std::string& path) const {
    const bytes::Hdf5Session session;
    const auto data = opened_object(*file_, path);
    if (!data && is_in(*file_, path)) {
        unsigned major = 0, minor = 0, release = 0;
        H5get_libversion(&major, &minor, &release);
        StoredArray closed{.name = path, .data = source_};
        closed.refusal = fmt::format(
            "HDF5: {:.200} cannot be opened; it is damaged, or written for a version after {}.{}.{}: "
            "h5repack --high=2 makes it older",
            path, major, minor, release);
        return closed;
    }
    if (!data || H5Iget_type(data) != H5I_DATASET) return std::nullopt;
    const bytes::Hdf5Handle type(H5Dget_type(data), &H5Tclose), space(H5Dget_space(data), &H5Sclose),
        properties(H5Dget_create_plist(data), &H5Pclose);
    const auto plain = type ? hdf5_number(type) : std::nullopt;
    if (!plain || !space || !properties) return std::nullopt;
    const auto extents = bytes::hdf5_extents(space);
    StoredArray array;
    array.name = path;
    array.sample = plain->sample;
    array.order = plain->order;
    array.attributes = attributes_of(data);
    array.data = source_;
    for (const auto extent : extents) {
        if (extent > hsize_t{1} << 40)
            broken_file(source_, fmt::format("dataset {:.200} has {} values along a dimension; the file is damaged",
                                             path, extent));
        array.shape.push_back(static_cast<Index>(extent));
    }
    if (!is_map_or_line(array)) return array;
    place_values({source_, path, data, type, properties, extents}, array);
    return array;
}

std::optional<double> Hdf5File::number(const std::string& path) const {
    const bytes::Hdf5Session session;
    const auto data = opened_object(*file_, path);
    if (!data || H5Iget_type(data) != H5I_DATASET) return std::nullopt;
    const bytes::Hdf5Handle type(H5Dget_type(data), &H5Tclose), space(H5Dget_space(data), &H5Sclose),
        properties(H5Dget_create_plist(data), &H5Pclose);
    const bool plain = type && space && properties && hdf5_number(type) && H5Sget_simple_extent_npoints(space) == 1 &&
                       H5Pget_external_count(properties) == 0 && H5Pget_layout(properties) != H5D_VIRTUAL &&
                       are_bounded(data, properties, bytes::hdf5_extents(space).size());
    double value = 0.0;
    if (!plain || H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value) < 0) return std::nullopt;
    return value;
}

Attributes Hdf5File::attributes(const std::string& path) const {
    const bytes::Hdf5Session session;
    const auto object = opened_object(*file_, path);
    return object ? attributes_of(object) : Attributes{};
}

std::optional<Hdf5Record> Hdf5File::record_attribute(const std::string& path, const std::string& name) const {
    const bytes::Hdf5Session session;
    const auto object = opened_object(*file_, path);
    std::optional<Hdf5Record> record;
    if (object)
        with_attribute(object, name, [&](const char* value, hid_t type) {
            if (!record && H5Tget_class(type) == H5T_COMPOUND) record = record_in(value, type);
        });
    return record;
}

std::vector<Hdf5Record> Hdf5File::records(const std::string& path) const {
    const bytes::Hdf5Session session;
    const auto data = opened_object(*file_, path);
    if (!data || H5Iget_type(data) != H5I_DATASET) return {};
    const bytes::Hdf5Handle stored(H5Dget_type(data), &H5Tclose), space(H5Dget_space(data), &H5Sclose);
    if (!stored || !space || H5Tget_class(stored) != H5T_COMPOUND) return {};
    const bytes::Hdf5Handle properties(H5Dget_create_plist(data), &H5Pclose);
    const auto type = native(stored);
    const auto extents = bytes::hdf5_extents(space);
    const auto count = bytes::hdf5_product(extents);
    if (!properties || !are_bounded(data, properties, extents.size()) || !type || count > max_records ||
        count * type->bytes > max_record_bytes)
        return {};
    std::vector<Hdf5Record> records;
    with_values(
        space, *type, count,
        [&](void* values) { return H5Dread(data, type->type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values); },
        [&](const char* value) { records.push_back(record_in(value, type->type)); });
    return records;
}

}  // namespace setae::formats
