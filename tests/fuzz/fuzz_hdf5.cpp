// SPDX-License-Identifier: GPL-3.0-or-later
// Formats of topographies that are HDF5, with their content given by bytes.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "fuzz_heights.hpp"
#include "hdf5_builder.hpp"
#include "setae/bytes/rehearsal.hpp"
#include "setae/formats/format.hpp"

using namespace setae;

namespace {

constexpr std::size_t max_written = 4096, max_attributes = 24;

/// Takes numbers and lines from the front of a description.
class Description {
public:
    explicit Description(std::string_view bytes) : bytes_(bytes) {}

    [[nodiscard]] bool empty() const { return bytes_.empty(); }
    unsigned next() {
        if (bytes_.empty()) return 0;
        const auto value = static_cast<unsigned char>(bytes_.front());
        bytes_.remove_prefix(1);
        return value;
    }
    std::string line() {
        const auto end = std::min(bytes_.find('\n'), bytes_.size());
        const std::string text(bytes_.substr(0, end));
        bytes_.remove_prefix(std::min(end + 1, bytes_.size()));
        return text.substr(0, text.find('\0'));
    }
    /// A number that may be small, huge, negative, or none.
    double number() {
        const auto kind = next();
        switch (kind) {
            case 250: return std::nan("");
            case 251: return 1.7976931348623157e308;
            case 252: return -1.0;
            case 253: return 1e-300;
            case 254: return 1e12;
            case 255: return INFINITY;
            default: return kind;
        }
    }

private:
    std::string_view bytes_;
};

/// Where a format expects its heights, and the objects on the way whose attributes it reads.
struct Place {
    std::string data;
    std::vector<std::string> objects;
};

const std::vector<Place>& places() {
    static const std::vector<Place> known{
        {"/group/map", {"/group/map", "/"}},
        {"/heights", {"/heights", "/x", "/y", "/mask", "/"}},
        {"/Data/Surface/{1}", {"/Data/Surface/{1}", "/Attributes/{2}", "/"}},
        {"/Measurement_000/Channel_000/Height",
         {"/Measurement_000", "/Measurement_000/Channel_000", "/Measurement_000/Channel_000/Height"}},
        {"/matrix", {"/matrix", "/"}}};
    return known;
}

constexpr const char* names[] = {"unit",
                                 "units",
                                 "length",
                                 "periodic",
                                 "json",
                                 "_FillValue",
                                 "scale_factor",
                                 "element_size_um",
                                 "Unit",
                                 "No Data",
                                 "X Converter",
                                 "Y Converter",
                                 "position-pattern.grid.ilength",
                                 "position-pattern.grid.jlength",
                                 "position-pattern.grid.ulength",
                                 "position-pattern.grid.vlength",
                                 "net-encoder.scaling.multiplier",
                                 "MATLAB_class",
                                 "MATLAB_empty",
                                 "channel.name",
                                 "retrace",
                                 "NAME",
                                 "_NCProperties",
                                 "Wavelength",
                                 "Z Converter",
                                 "add_offset",
                                 "net-encoder.scaling.unit.unit",
                                 "timing-settings.scanRate",
                                 "System Type"};

void add_attribute(tests::Hdf5Builder& file, const Place& place, Description& described) {
    const std::string name = names[described.next() % std::size(names)];
    const auto kind = described.next();
    const auto& object = place.objects[kind / 8 % place.objects.size()];
    switch (kind % 8) {
        case 0: file.attribute(object, name, described.line()); break;
        case 1: file.attribute(object, name, std::vector<double>{described.number()}); break;
        case 2: file.variable_text(object, name, described.line()); break;
        case 3:
            file.attribute(object, name,
                           std::vector<double>{described.number(), described.number(), described.number()});
            break;
        case 4: file.attribute(object, name, std::vector<double>{}); break;
        default:
            file.converter(object, name,
                           {kind % 8 == 5 ? "LateralCat" : described.line(),
                            kind % 8 == 6 ? described.line() : "Pixels",
                            {described.number(), described.number()}});
    }
}

std::string hdf5_file(Description described) {
    const hid_t types[] = {H5T_STD_I8LE,   H5T_STD_U16BE, H5T_STD_I32LE,   H5T_STD_U64LE,  H5T_STD_I32BE,
                           H5T_IEEE_F32LE, H5T_C_S1,      H5T_STD_REF_OBJ, H5T_IEEE_F32BE, H5T_IEEE_F64LE};
    const auto format = described.next() % places().size();
    const auto& place = places()[format];
    const auto structures = described.next();
    const bool matlab = format == 4;
    tests::Hdf5Builder file(
        {.newest = (structures & 1) != 0, .user_block = matlab || structures & 2 ? hsize_t{512} : 0});
    const auto type = types[described.next() % std::size(types)];
    std::vector<hsize_t> sides(1 + (described.next() + 3) % 4);
    hsize_t numbers = 1;
    for (auto& side : sides) {
        side = described.next();
        numbers *= side;
    }
    if (structures & 4) sides.front() *= 1'000'000;
    tests::Hdf5Builder::Layout layout;
    const auto packing = described.next(), chunk = described.next();
    if (packing & 1) layout.compact = true;
    if (packing & 2) layout.chunk.assign(sides.size(), 1 + chunk % 16);
    layout.shuffled = packing & 4;
    layout.deflated = packing & 8;
    layout.summed = packing & 16;
    if (layout.chunk.empty()) layout.shuffled = layout.deflated = layout.summed = false;
    const bool written = !(structures & 4) && numbers <= max_written && H5Tget_class(type) <= H5T_FLOAT;
    std::vector<double> values(written ? numbers : 0);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>((7 * i + chunk) % 101);
    file.dataset(place.data, type, sides, values, layout);
    if (format == 1) {
        for (const auto& [name, extent] : {std::pair{"/x", sides.front()}, {"/y", sides.back()}})
            if (structures & 8 && extent <= values.size())
                file.dataset(name, H5T_IEEE_F64LE, {extent},
                             std::vector<double>(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(extent)));
        if (structures & 16) file.dataset("/mask", H5T_STD_I8LE, sides, values, layout);
    }
    if (format == 2) {
        file.text_table("/MetaData",
                        {{"Root", "Measurement", described.line()}, {"a", "Surface", "b"}, {"b", "Path", place.data}},
                        1 + structures % 64);
        file.group("/Attributes/{2}");
    }
    for (std::size_t k = 0; k < max_attributes && !described.empty(); ++k) add_attribute(file, place, described);
    auto bytes = file.bytes();
    if (matlab) bytes.replace(0, 19, "MATLAB 7.3 MAT-file");
    return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    bytes::disable_rehearsals();
    const auto source = bytes::memory_source("input", hdf5_file(Description(fuzz::text_of(data, size))));
    try {
        for (const auto& channel : formats::open(source, fuzz::given)) fuzz::read_heights(channel);
    } catch (const Error&) {
    }
    return 0;
}
