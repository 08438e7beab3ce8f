// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/core/estimate.hpp"
#include "setae/core/quantity.hpp"

/// Containers of contact.engineering: a ZIP of measured files and an index that describes each of them. The types
/// contain only data of the index; open() of channel.hpp reads the heights. An empty text or list is equivalent to a
/// missing one. Unknown fields are kept in `extra`, JSON text of an object, and written unchanged. Source:
/// SurfaceTopography 1.27.1, Container/IO/Schema.py; TopoBank, manager/container_schema.py and export_zip.py.
namespace setae::formats {

struct ContainerAuthor {
    std::string name, orcid, extra;
    bool operator==(const ContainerAuthor&) const = default;
};

/// A number or word assigned to a surface, such as its hardness.
struct ContainerProperty {
    std::string name;
    std::optional<std::variant<double, std::string>> value;
    std::string unit, extra;
    bool operator==(const ContainerProperty&) const = default;
};

struct ContainerPublication {
    std::string url, license, authors, date, doi_url, doi_state, extra;
    std::optional<std::size_t> version;
    bool operator==(const ContainerPublication&) const = default;
};

struct ContainerLength {
    std::optional<double> value;
    std::string unit, extra;
    std::string text;  ///< "10 ± 2 nm", instead of value and unit
    bool operator==(const ContainerLength&) const = default;

    /// [m]; empty without value or unit. @throws InvalidArgument for a unit that is no length, and for a text that is
    /// no length > 0 with ± and unit.
    [[nodiscard]] std::optional<Estimate> estimate() const;
    [[nodiscard]] std::optional<double> metres() const;
};

struct ContainerInstrument {
    std::string name;
    std::string type;  ///< "contact-based", "microscope-based" or "undefined"
    struct Parameters {
        std::optional<ContainerLength> tip_radius, resolution;
        std::optional<ContainerLength> tip_radius_standard_error;  ///< only in setae
        std::string height_calibration, lateral_calibration;       ///< only in setae: ratio of true to stated value,
                                                                   ///< "1.00 ± 0.02"
        std::string extra;
        bool operator==(const Parameters&) const = default;
    };
    std::optional<Parameters> parameters;
    std::string extra;
    bool operator==(const ContainerInstrument&) const = default;
};

/// One measurement. Sizes and scale are those of the index, in its unit.
struct ContainerTopography {
    std::string name;
    struct Datafile {
        std::string original;  ///< name of the member with the original data, or its description
        std::string source;    ///< key of setae only: original file of the instrument, if `original` is an export
        std::optional<std::size_t> source_channel;  ///< of the source, counted from 0
        std::string squeezed;  ///< name of the NetCDF file with the same heights scaled, filled and levelled
        std::string extra;
        bool operator==(const Datafile&) const = default;
    } datafile;
    std::optional<std::size_t> data_source;  ///< channel of the original, counted from 0
    struct Channel {
        std::string name;
        std::optional<std::size_t> occurrence;  ///< number among several channels with this name, counted from 0
        std::string extra;
        bool operator==(const Channel&) const = default;
    };
    std::optional<Channel> channel;  ///< key of the newest TopoBank, instead of data_source
    std::vector<double> size;        ///< [unit]
    std::string unit;
    std::optional<double> height_scale;  ///< factor to the numbers of the original if the file contains no scale
    std::optional<bool> has_undefined_data;
    std::optional<double> undefined_data_fraction;
    std::string fill_undefined_data_mode;  ///< "do-not-fill", "harmonic"
    std::string detrend_mode;              ///< "center", "height", "curvature"
    std::optional<bool> is_periodic;
    std::optional<ContainerAuthor> created_by;
    std::string measurement_date;  ///< 2016-02-15
    std::string description;
    std::vector<std::string> tags;
    std::optional<ContainerInstrument> instrument;
    std::string extra;
    bool operator==(const ContainerTopography&) const = default;
};

/// A surface and its measurements; contact.engineering calls it a digital surface twin.
struct ContainerSurface {
    std::string name;
    std::string category;  ///< "exp", "sim", "dum"
    std::optional<ContainerAuthor> created_by;
    std::string description;
    std::vector<std::string> tags;
    std::optional<bool> is_published;
    std::optional<ContainerPublication> publication;
    std::vector<ContainerProperty> properties;
    std::vector<ContainerTopography> topographies;
    std::string extra;
    bool operator==(const ContainerSurface&) const = default;
};

struct Container {
    std::map<std::string, std::string> versions;  ///< versions of the programs that wrote it
    std::vector<ContainerSurface> surfaces;
    std::string created_at;
    std::string extra;
    bool operator==(const Container&) const = default;
};

/// Generation of the index of a container.
enum class ContainerGeneration {
    yaml,      ///< A: only meta.yml, up to TopoBank 1.63; keys creator, creation_time
    both,      ///< B: index.json with the keys of A, next to meta.yml
    json,      ///< C: index.json with created_by, created_at; written by setae. Also the layout of the latest TopoBank
               ///< development version, with "measurements" of a "kind" and their "metadata"
    skeleton,  ///< as SurfaceTopography writes: only processed copies, almost no fields
};
[[nodiscard]] std::string describe(ContainerGeneration generation);

struct ContainerFile {
    Container container;
    ContainerGeneration generation = ContainerGeneration::json;
    std::vector<std::string> members;  ///< names of the members of the archive, without the index
    std::vector<Alert> alerts;         ///< UNKNOWN_FIELD (kept), MALFORMED_FIELD (kept, not interpreted)
};

/// The index of a container: index.json, otherwise meta.yml, whose tags are neither executed nor constructed.
/// @throws FileError; FormatError for an incomplete ZIP archive, without an index or with an index that does not parse.
[[nodiscard]] ContainerFile read_container(const bytes::Source& source);

/// A member of a container, expanded when read. @throws FormatError if there is no member with this name.
[[nodiscard]] bytes::Source container_member(const bytes::Source& source, const std::string& name);

/// A member to be written; its bytes are requested when it is written, one member at a time.
struct ContainerMember {
    std::string name;
    std::function<bytes::Source()> content;
};

/// Writes a container of generation C: index.json, meta.yml with the same content for older programs, README.txt unless
/// a member has this name, and the members stored in order. The file is written under a temporary name, then renamed;
/// the same input gives the same bytes.
/// @throws FileError if it cannot be written; InvalidArgument for two members with one name or a name that leads out of
/// the archive; exceptions of a member's content.
void write_container(const std::string& path, const Container& container, const std::vector<ContainerMember>& members);

/// Violations of the schema of contact.engineering: code NOT_IN_SCHEMA, the place in the index, and the problem.
[[nodiscard]] std::vector<Alert> schema_violations(const Container& container);

/// Every difference between two containers, index and members, one per line: "surfaces/0/topographies/1/height_scale:
/// 0.5 became absent", "member a.txt: differs". Keys of older generations count as those of generation C.
/// @throws as read_container.
[[nodiscard]] std::vector<std::string> container_differences(const bytes::Source& before, const bytes::Source& after);

}  // namespace setae::formats
