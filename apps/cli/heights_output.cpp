// SPDX-License-Identifier: GPL-3.0-or-later
#include "heights_output.hpp"

#include <iterator>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/io/netcdf.hpp"
#include "setae/io/npy.hpp"
#include "setae/io/profile_file.hpp"
#include "setae/io/table_file.hpp"
#include "setae/io/whole_file.hpp"

namespace setae::cli {
namespace {

Array1D positions(const topography::LineScan& scan) {
    return scan.pixel_size() * Array1D::LinSpaced(scan.heights.size(), 0.0, static_cast<double>(scan.heights.size() - 1));
}

void write_line(const std::string& path, const Array1D& x, const Array1D& h) { io::write_csv(path, {{{"x", "m", x}, {"h", "m", h}}, {}}); }

/// A map as a matrix without header: one line for each x, NaN spelled out, since an empty cell ends some readers.
void write_matrix(const std::string& path, const Array2D& heights) {
    std::string text;
    for (Index i = 0; i < heights.rows(); ++i)
        for (Index j = 0; j < heights.cols(); ++j) fmt::format_to(std::back_inserter(text), "{}{}", heights(i, j), j + 1 < heights.cols() ? ',' : '\n');
    io::write_whole_file(path, text);
}

bool knows_its_trace(const topography::Profile& profile) { return profile.response || profile.standard_error.size() > 0; }

struct CsvWriter {
    std::string path;
    void operator()(const topography::HeightMap& map) const { write_matrix(path, map.heights); }
    void operator()(const topography::LineScan& scan) const { write_line(path, positions(scan), scan.heights); }
    void operator()(const topography::Profile& profile) const {
        if (knows_its_trace(profile))
            io::write_profile(path, profile);
        else
            write_line(path, profile.positions, profile.heights);
    }
};

}  // namespace

void require_heights_ending(const std::string& path) {
    if (!path.ends_with(".npy") && !path.ends_with(".csv") && !path.ends_with(".nc"))
        throw InvalidArgument(fmt::format("{}: cannot tell the format from the name; expected an ending .nc, .npy or .csv", path));
}

void write_heights(const std::string& path, const topography::Measurement& measurement) {
    require_heights_ending(path);
    const auto* profile = std::get_if<topography::Profile>(&measurement);
    if (profile && knows_its_trace(*profile) && !path.ends_with(".csv"))
        throw InvalidArgument(fmt::format("{}: the profile knows the errors or the response of its trace, which such files cannot hold; write it as .csv", path));
    if (path.ends_with(".npy"))
        std::visit([&](const auto& m) { io::write_npy(path, m.heights); }, measurement);
    else if (path.ends_with(".csv"))
        std::visit(CsvWriter{path}, measurement);
    else
        io::write_netcdf(path, measurement);
}

}  // namespace setae::cli
