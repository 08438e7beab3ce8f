// SPDX-License-Identifier: GPL-3.0-or-later
#include "emd_file.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <hdf5.h>
#include <nlohmann/json.hpp>

#include "micrograph_building.hpp"
#include "setae/bytes/hdf5_handle.hpp"
#include "setae/bytes/json_text.hpp"
#include "setae/bytes/rehearsal.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"

namespace setae::imaging {
namespace {

constexpr int deepest_emd_group = 8;
constexpr std::size_t max_members = 10'000;
constexpr std::uint64_t max_metadata = 1 << 20, longest_emd_text = 1 << 12;
constexpr std::uint64_t cache_bytes_per_pixel = 16;  // of a chunk, against max_pixels

using Handle = bytes::Hdf5Handle;

bool exists(hid_t place, const std::string& name) {
    return H5Lexists(place, name.c_str(), H5P_DEFAULT) > 0 && H5Oexists_by_name(place, name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<hsize_t> sides_of(hid_t data) { return bytes::hdf5_extents(Handle(H5Dget_space(data), &H5Sclose)); }

/// Text of an attribute, of fixed or variable length; empty if there is none.
std::string text_attribute(hid_t object, const char* name) {
    if (H5Aexists(object, name) <= 0) return {};
    const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), &H5Aclose);
    if (!attribute) return {};
    const Handle type(H5Aget_type(attribute), &H5Tclose), space(H5Aget_space(attribute), &H5Sclose);
    if (!type || !space || H5Tget_class(type) != H5T_STRING || H5Sget_simple_extent_npoints(space) != 1) return {};
    if (H5Tis_variable_str(type) > 0) {
        char* text = nullptr;
        if (H5Aread(attribute, type, &text) < 0 || !text) return {};
        auto copied = bytes::field_text(text);
        H5free_memory(text);
        return copied;
    }
    std::string text(std::min<std::size_t>(H5Tget_size(type), longest_emd_text), '\0');
    if (text.size() < H5Tget_size(type) || H5Aread(attribute, type, text.data()) < 0) return {};
    return bytes::field_text(text);
}

/// First two numbers of a dimension's positions.
std::optional<double> step_of(hid_t group, const std::string& name) {
    if (!exists(group, name)) return std::nullopt;
    const Handle data(H5Dopen2(group, name.c_str(), H5P_DEFAULT), &H5Dclose);
    if (!data) return std::nullopt;
    const auto sides = sides_of(data);
    if (sides.size() != 1 || sides[0] < 2) return std::nullopt;
    const Handle space(H5Dget_space(data), &H5Sclose);
    const hsize_t start = 0, count = 2;
    const Handle memory(H5Screate_simple(1, &count, nullptr), &H5Sclose);
    double positions[2]{};
    if (H5Sselect_hyperslab(space, H5S_SELECT_SET, &start, nullptr, &count, nullptr) < 0 ||
        H5Dread(data, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, positions) < 0)
        return std::nullopt;
    return positions[1] - positions[0];
}

/// "[n_m]" in EMD units, without brackets and the lines between prefix and unit.
std::string emd_unit(std::string unit) {
    std::erase_if(unit, [](char c) { return c == '[' || c == ']' || c == '_'; });
    return unit;
}

/// Names of the members of a group, sorted.
std::vector<std::string> members_of(hid_t group) {
    std::vector<std::string> names;
    H5G_info_t info;
    if (H5Gget_info(group, &info) < 0) return names;
    for (hsize_t i = 0; i < std::min<hsize_t>(info.nlinks, max_members); ++i) {
        const auto length = H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, nullptr, 0, H5P_DEFAULT);
        if (length <= 0 || static_cast<std::uint64_t>(length) > longest_emd_text) continue;
        std::string name(static_cast<std::size_t>(length) + 1, '\0');
        H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), name.size(), H5P_DEFAULT);
        name.pop_back();
        names.push_back(std::move(name));
    }
    return names;
}

bool is_ncem_image(hid_t group) {
    if (H5Aexists(group, "emd_group_type") <= 0 || !exists(group, "data")) return false;
    const Handle attribute(H5Aopen(group, "emd_group_type", H5P_DEFAULT), &H5Aclose);
    const Handle space(H5Aget_space(attribute), &H5Sclose), type(H5Aget_type(attribute), &H5Tclose);
    int value = 0;
    return space && type && H5Tget_class(type) == H5T_INTEGER && H5Sget_simple_extent_npoints(space) == 1 &&
           H5Aread(attribute, H5T_NATIVE_INT, &value) >= 0 && value == 1;
}

/// Paths of groups that hold an image in NCEM's layout.
void find_ncem_images(hid_t group, const std::string& path, int depth, std::vector<std::string>& found,
                      std::size_t& visited) {
    if (is_ncem_image(group)) found.push_back(path);
    if (depth > deepest_emd_group) return;
    for (const auto& name : members_of(group)) {
        if (++visited > max_members) return;
        if (!exists(group, name)) continue;
        const Handle member(H5Oopen(group, name.c_str(), H5P_DEFAULT), &H5Oclose);
        if (member && H5Iget_type(member) == H5I_GROUP)
            find_ncem_images(member, path + "/" + name, depth + 1, found, visited);
    }
}

struct Plane {
    std::size_t row_axis, column_axis;
};

/// Grey levels of the first plane of a dataset. @throws FormatError.
FramePixels plane_of(const bytes::Source& file, hid_t data, const std::vector<hsize_t>& sides, Plane plane,
                     const MicrographOptions& options) {
    const auto damaged = [&](const std::string& what) { return FormatError(file.name, {.offset = 0}, what); };
    const auto size = picture_size(file, 0, sides[plane.column_axis], sides[plane.row_axis], options);
    const Handle type(H5Dget_type(data), &H5Tclose);
    const auto kind = H5Tget_class(type);
    if (kind != H5T_INTEGER && kind != H5T_FLOAT)
        throw damaged("the pixels are not plain numbers; convert complex or coloured images to real ones");
    const Handle properties(H5Dget_create_plist(data), &H5Pclose);
    if (H5Pget_external_count(properties) > 0 || H5Pget_layout(properties) == H5D_VIRTUAL)
        throw damaged("the pixels are in other files; copy them into one file");
    if (H5Pget_layout(properties) == H5D_CHUNKED) {
        std::vector<hsize_t> chunk(sides.size());
        H5Pget_chunk(properties, static_cast<int>(chunk.size()), chunk.data());
        double bytes = static_cast<double>(H5Tget_size(type));
        for (const auto side : chunk) bytes *= static_cast<double>(side);
        if (bytes > static_cast<double>(cache_bytes_per_pixel) * static_cast<double>(options.max_pixels))
            throw damaged(fmt::format(
                "the pixels are packed in pieces of {:.3g} bytes; export the image as a separate file", bytes));
    } else if (H5Dget_storage_size(data) > file.size) {
        throw damaged("more pixels than the file has bytes; it is truncated or damaged");
    }
    const Handle space(H5Dget_space(data), &H5Sclose);
    const std::vector<hsize_t> start(sides.size(), 0);
    std::vector<hsize_t> count(sides.size(), 1);
    count[plane.row_axis] = sides[plane.row_axis];
    count[plane.column_axis] = sides[plane.column_axis];
    if (H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) < 0)
        throw damaged("HDF5 cannot select a plane of the image; the file is damaged");
    const hsize_t numbers = sides[plane.row_axis] * sides[plane.column_axis];
    const Handle memory(H5Screate_simple(1, &numbers, nullptr), &H5Sclose);
    FramePixels pixels(size.height, size.width);
    if (H5Dread(data, H5T_NATIVE_FLOAT, memory, space, H5P_DEFAULT, pixels.data()) < 0)
        throw damaged("HDF5 cannot read the pixels; the file is truncated or damaged");
    return pixels;
}

void note_planes(Micrograph& micrograph, const std::vector<hsize_t>& sides, Plane plane) {
    double planes = 1;
    for (std::size_t axis = 0; axis < sides.size(); ++axis)
        if (axis != plane.row_axis && axis != plane.column_axis) planes *= static_cast<double>(sides[axis]);
    if (planes > 1)
        add_alert(micrograph, "STACK",
                  fmt::format("the image is a stack of {:g} planes; the first plane is read", planes),
                  "to use another plane, save it as a separate file");
}

void read_ncem(const bytes::Source& file, hid_t group, Micrograph& micrograph, const MicrographOptions& options) {
    const Handle data(H5Dopen2(group, "data", H5P_DEFAULT), &H5Dclose);
    if (!data)
        throw FormatError(file.name, {.offset = 0}, "the data of an image are not a dataset; the file is damaged");
    const auto sides = sides_of(data);
    std::vector<AxisScale> axes;
    for (std::size_t axis = 0; axis < sides.size(); ++axis) {
        const auto name = fmt::format("dim{}", axis + 1);
        const auto step = step_of(group, name);
        std::string unit;
        if (step) {
            const Handle dimension(H5Dopen2(group, name.c_str(), H5P_DEFAULT), &H5Dclose);
            unit = emd_unit(text_attribute(dimension, "units"));
        }
        axes.push_back({step.value_or(0), unit});
        if (is_energy(unit))
            throw FormatError(
                file.name, {.offset = 0},
                fmt::format("axis {} is an energy in {}: a spectrum, not a picture; choose the file with the image",
                            axis, unit));
    }
    if (sides.size() < 2)
        throw FormatError(
            file.name, {.offset = 0},
            "numbers along one axis: a spectrum or a line, not a picture; choose the file with the image");
    const Plane plane{sides.size() - 2, sides.size() - 1};
    micrograph.pixels = plane_of(file, data, sides, plane, options);
    note_planes(micrograph, sides, plane);
    set_pixel_size(micrograph, axes[plane.column_axis], axes[plane.row_axis], "EMD dimensions");
}

/// Velox metadata of the first frame: a column of bytes with JSON.
nlohmann::json velox_metadata(hid_t image) {
    if (!exists(image, "Metadata")) return nullptr;
    const Handle data(H5Dopen2(image, "Metadata", H5P_DEFAULT), &H5Dclose);
    if (!data) return nullptr;
    const auto sides = sides_of(data);
    if (sides.size() != 2 || sides[0] == 0 || sides[1] == 0 || sides[0] > max_metadata) return nullptr;
    const Handle space(H5Dget_space(data), &H5Sclose);
    const hsize_t start[] = {0, 0}, count[] = {sides[0], 1};
    const Handle memory(H5Screate_simple(1, count, nullptr), &H5Sclose);
    std::string text(sides[0], '\0');
    if (H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr) < 0 ||
        H5Dread(data, H5T_NATIVE_UCHAR, memory, space, H5P_DEFAULT, text.data()) < 0)
        return nullptr;
    return bytes::json_or_null(text.substr(0, text.find('\0')));
}

/// The value at a path of JSON as text; empty if there is none.
std::string json_text(const nlohmann::json& json, const std::string& path) {
    const nlohmann::json::json_pointer pointer(path);
    if (json.is_discarded() || !json.contains(pointer)) return {};
    const auto& value = json.at(pointer);
    return value.is_string() ? value.get<std::string>() : value.is_number() ? value.dump() : std::string();
}

void read_velox(const bytes::Source& file, hid_t image, Micrograph& micrograph, const MicrographOptions& options) {
    const Handle data(H5Dopen2(image, "Data", H5P_DEFAULT), &H5Dclose);
    if (!data) throw FormatError(file.name, {.offset = 0}, "Data of an image is not a dataset; the file is damaged");
    const auto sides = sides_of(data);
    if (sides.size() < 2)
        throw FormatError(
            file.name, {.offset = 0},
            "numbers along one axis: a spectrum or a line, not a picture; choose the file with the image");
    const Plane plane{0, 1};  // frames along the last axis
    micrograph.pixels = plane_of(file, data, sides, plane, options);
    note_planes(micrograph, sides, plane);
    const auto metadata = velox_metadata(image);
    const auto width = number_of(json_text(metadata, "/BinaryResult/PixelSize/width")),
               height = number_of(json_text(metadata, "/BinaryResult/PixelSize/height"));
    if (width && height)
        set_pixel_size(micrograph, {*width, json_text(metadata, "/BinaryResult/PixelUnitX")},
                       {*height, json_text(metadata, "/BinaryResult/PixelUnitY")}, "Velox metadata");
    micrograph.instrument = json_text(metadata, "/Instrument/InstrumentClass");
    micrograph.acquisition_time = json_text(metadata, "/Acquisition/AcquisitionStartDatetime/DateTime");
    for (const auto& [name, path, unit] : {std::tuple{"voltage", "/Optics/AccelerationVoltage", " V"},
                                           {"magnification", "/Optics/NominalMagnification", ""},
                                           {"detector", "/BinaryResult/Detector", ""}})
        if (const auto text = json_text(metadata, path); !text.empty()) micrograph.attributes[name] = text + unit;
}

/// An image of a file, or its replacement.
struct EmdEntry {
    std::string path;
    ImageEntry shown;
    bool complex = false;
};

bool is_reciprocal(const std::string& unit) {
    return unit.find("1/") != std::string::npos || unit.find("^-1") != std::string::npos ||
           unit.find("-1") != std::string::npos;
}

/// Whether a dataset contains records, the storage of complex numbers.
bool holds_records(hid_t group, const char* name) {
    if (!exists(group, name)) return false;
    const Handle data(H5Dopen2(group, name, H5P_DEFAULT), &H5Dclose);
    if (!data) return false;
    const Handle type(H5Dget_type(data), &H5Tclose);
    return type && H5Tget_class(type) == H5T_COMPOUND;
}

std::string last_part(const std::string& path) { return path.substr(path.rfind('/') + 1); }

EmdEntry velox_entry(hid_t root, const std::string& path, const char* kind) {
    EmdEntry entry{.path = path, .shown = {.kind = kind}};
    const Handle group(H5Oopen(root, path.c_str(), H5P_DEFAULT), &H5Oclose);
    if (!group || H5Iget_type(group) != H5I_GROUP) return entry;
    const auto metadata = velox_metadata(group);
    entry.shown.title = json_text(metadata, "/BinaryResult/Detector");
    const bool reciprocal = is_reciprocal(json_text(metadata, "/BinaryResult/PixelUnitX"));
    entry.complex = holds_records(group, "Data");
    if (entry.shown.is_picture() && (reciprocal || entry.complex)) entry.shown.kind = "Fourier transform";
    return entry;
}

/// Images first, then spectra, each by the name of its group.
std::vector<EmdEntry> velox_entries(hid_t root) {
    struct Kind {
        const char *group, *kind;
    };
    static constexpr Kind kinds[] = {{"/Data/Image", "image"},
                                     {"/Data/SpectrumImage", "spectrum image"},
                                     {"/Data/SpectrumStream", "spectrum image"},
                                     {"/Data/Spectrum", "spectrum"}};
    std::vector<EmdEntry> entries;
    for (const auto& [path, kind] : kinds) {
        if (!exists(root, path)) continue;
        const Handle group(H5Oopen(root, path, H5P_DEFAULT), &H5Oclose);
        if (!group || H5Iget_type(group) != H5I_GROUP) continue;
        for (const auto& name : members_of(group))
            if (exists(group, name) && exists(root, fmt::format("{}/{}/Data", path, name)))
                entries.push_back(velox_entry(root, fmt::format("{}/{}", path, name), kind));
    }
    return entries;
}

EmdEntry ncem_entry(hid_t root, const std::string& path) {
    EmdEntry entry{.path = path, .shown = {.title = last_part(path)}};
    const Handle group(H5Oopen(root, path.empty() ? "/" : path.c_str(), H5P_DEFAULT), &H5Oclose);
    const Handle data(group ? H5Dopen2(group, "data", H5P_DEFAULT) : -1, &H5Dclose);
    if (!data) return entry;
    const auto sides = sides_of(data);
    std::size_t extended = 0;
    bool energy = false, reciprocal = false;
    for (std::size_t axis = 0; axis < sides.size(); ++axis) {
        extended += sides[axis] > 1 ? 1 : 0;
        const auto name = fmt::format("dim{}", axis + 1);
        if (!exists(group, name)) continue;
        const Handle dimension(H5Dopen2(group, name.c_str(), H5P_DEFAULT), &H5Dclose);
        const auto unit = dimension ? emd_unit(text_attribute(dimension, "units")) : std::string();
        energy = energy || is_energy(unit);
        reciprocal = reciprocal || is_reciprocal(unit);
    }
    entry.complex = holds_records(group, "data");
    if (energy || extended < 2) entry.shown.kind = extended > 1 ? "spectrum image" : "spectrum";
    else if (reciprocal || entry.complex) entry.shown.kind = "Fourier transform";
    return entry;
}

std::vector<EmdEntry> ncem_entries(hid_t root) {
    const Handle group(H5Oopen(root, "/", H5P_DEFAULT), &H5Oclose);
    std::vector<std::string> paths;
    std::size_t visited = 0;
    find_ncem_images(group, "", 0, paths, visited);
    std::vector<EmdEntry> entries;
    for (const auto& path : paths) entries.push_back(ncem_entry(root, path));
    return entries;
}

Micrograph read_image(const bytes::Source& file, const MicrographOptions& options) {
    auto micrograph = unread_micrograph(file, "emd");
    const auto root = bytes::opened_hdf5(file);
    auto entries = velox_entries(root);
    const bool is_velox = !entries.empty();
    if (!is_velox) entries = ncem_entries(root);
    if (entries.empty())
        throw FormatError(file.name, {.offset = 0},
                          "an HDF5 file without an image in the layout of EMD (emd_group_type or Data/Image)");
    std::vector<ImageEntry> shown;
    for (const auto& entry : entries) shown.push_back(entry.shown);
    const auto& chosen = entries[choose_image(micrograph, std::move(shown), options)];
    const bool real_transform =
        chosen.shown.kind == "Fourier transform" && !chosen.complex;  // a warning reports its units
    if (!chosen.shown.is_picture() && !real_transform)
        throw FormatError(
            file.name, {.offset = 0},
            fmt::format(
                "{} '{}' is a {}, not a picture{}", chosen.path, chosen.shown.title, chosen.shown.kind,
                entries.size() > 1 ? "; choose another image of the file" : "; choose the file with the image"));
    const Handle image(H5Oopen(root, chosen.path.empty() ? "/" : chosen.path.c_str(), H5P_DEFAULT), &H5Oclose);
    if (!image || H5Iget_type(image) != H5I_GROUP)
        throw FormatError(file.name, {.offset = 0}, fmt::format("{} is not a group; the file is damaged", chosen.path));
    if (is_velox) read_velox(file, image, micrograph, options);
    else read_ncem(file, image, micrograph, options);
    add_alert(micrograph, "UNTESTED_FORMAT",
              "EMD is read according to its description and was not tested on an instrument file",
              "compare picture and pixel size with those of another program");
    return micrograph;
}

}  // namespace

bool is_hdf5(std::string_view head) { return head.starts_with("\x89HDF\r\n\x1A\n"); }

Micrograph read_emd(const bytes::Source& file, const MicrographOptions& options) {
    const bytes::Hdf5Session session;
    bytes::rehearse(file.name, "HDF5", [&] { (void)read_image(file, options); });
    return read_image(file, options);
}

}  // namespace setae::imaging
