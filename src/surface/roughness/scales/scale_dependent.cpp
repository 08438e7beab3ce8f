// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/scales/scale_dependent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <variant>

#include <fmt/format.h>

#include "difference_result.hpp"
#include "difference_rows.hpp"
#include "difference_sums.hpp"
#include "polyline_pieces.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/extent.hpp"
#include "setae/fourier/buffer.hpp"

namespace setae::scales {
namespace {

using fourier::Buffer;

constexpr Index block_rows = 32;  ///< rows summed together

/// Differences at one distance: along x or y, or both with their combination.
struct Scale {
    double distance = 0.0;
    double origin = 0.0;
    std::array<std::optional<DifferenceRows>, 2> parts;
    int order = 1;

    [[nodiscard]] Index first_row() const { return most(&DifferenceRows::first_row); }
    [[nodiscard]] Index first_column() const { return most(&DifferenceRows::first_column); }
    [[nodiscard]] Index end_row() const { return least(&DifferenceRows::end_row); }
    [[nodiscard]] Index end_column() const { return least(&DifferenceRows::end_column); }
    [[nodiscard]] Index columns() const { return std::max<Index>(0, end_column() - first_column()); }

    /// Values of a row, in the returned memory; `first` and `second` are work arrays.
    const double* row(Index i, Buffer<double>& first, Buffer<double>& second) const {
        parts[0]->fill(i, first.data());
        double* values = first.data() + first_column() - parts[0]->first_column;
        if (!parts[1]) return values;
        parts[1]->fill(i, second.data());
        const double* others = second.data() + first_column() - parts[1]->first_column;
        const Index n = columns();
        if (order == 1)
            for (Index j = 0; j < n; ++j) values[j] = std::sqrt(values[j] * values[j] + others[j] * others[j]);
        else
            for (Index j = 0; j < n; ++j) values[j] = 0.5 * (values[j] + others[j]);
        return values;
    }

private:
    [[nodiscard]] Index most(Index DifferenceRows::*member) const {
        return std::max(*parts[0].*member, parts[1] ? *parts[1].*member : Index{0});
    }
    [[nodiscard]] Index least(Index DifferenceRows::*member) const {
        return std::min(*parts[0].*member, parts[1] ? *parts[1].*member : *parts[0].*member);
    }
};

/// Heights of a measurement and the direction of differences.
struct Source {
    Field field;
    std::array<double, 2> pixel_size{};
    bool is_line = false;
    Array2D turned;  ///< for Fourier interpolation along x
    const topography::Metadata* metadata = nullptr;

    [[nodiscard]] double step(Along along) const { return along == Along::y ? pixel_size[1] : pixel_size[0]; }
};

void require_fourier(const Source& source, const DifferenceOptions& options) {
    const auto label = topography::label(*source.metadata);
    if (!source.field.periodic)
        throw InvalidArgument(label +
                              ": Fourier interpolation of data that are not periodic; choose linear interpolation");
    if (options.along == Along::both)
        throw InvalidArgument(label +
                              ": Fourier interpolation along both directions at once; compute x and y separately");
    const Eigen::Map<const Array1D> heights(source.field.heights, source.field.rows * source.field.columns);
    if (heights.isNaN().any())
        throw UndefinedDataError(
            label + ": Fourier interpolation of undefined heights; fill them or choose linear interpolation");
}

Source source_of(const topography::HeightMap& map, const DifferenceOptions& options) {
    require_differences(options, map.metadata);
    Source source{{map.heights.data(), map.heights.rows(), map.heights.cols(), 0.0, map.periodic},
                  map.pixel_size(),
                  false,
                  {},
                  &map.metadata};
    if (options.interpolation == Interpolation::fourier) {
        require_fourier(source, options);
        if (options.along == Along::x) {
            source.turned = map.heights.transpose();
            source.field.rows = source.turned.rows();
            source.field.columns = source.turned.cols();
        }
    }
    return source;
}

Source source_of(const topography::LineScan& scan, const DifferenceOptions& options) {
    require_differences(options, scan.metadata);
    if (options.along == Along::y)
        throw InvalidArgument(topography::label(scan.metadata) + ": differences along y of a line; choose x");
    Source source{{scan.heights.data(), 1, scan.heights.size(), 0.0, scan.periodic},
                  {scan.pixel_size(), scan.pixel_size()},
                  true,
                  {},
                  &scan.metadata};
    if (options.interpolation == Interpolation::fourier) require_fourier(source, options);
    return source;
}

DifferenceRows rows_along(const Source& source, Along along, const DifferenceOptions& options, double distance) {
    Field field = source.field;
    field.step = source.step(along);
    if (options.interpolation == Interpolation::fourier) {
        if (source.turned.size() > 0) field.heights = source.turned.data();
        return fourier_differences(field, options.order, distance);
    }
    const bool across = along == Along::x && !source.is_line;
    return linear_differences(field, across ? Running::across_rows : Running::along_columns, options.order, distance);
}

Scale scale_of(const Source& source, const DifferenceOptions& options, double distance) {
    Scale scale;
    scale.distance = distance;
    scale.order = options.order;
    if (options.along == Along::both && !source.is_line) {
        scale.parts[0] = rows_along(source, Along::x, options, distance);
        scale.parts[1] = rows_along(source, Along::y, options, distance);
    } else {
        scale.parts[0] = rows_along(source, source.is_line ? Along::x : options.along, options, distance);
    }
    return scale;
}

Array1D distances_of(const Source& source, const DifferenceOptions& options) {
    if (options.distances) return *options.distances;
    const auto [dx, dy] = source.pixel_size;
    const bool both = options.along == Along::both && !source.is_line;
    const double step = both ? std::max(dx, dy) : source.step(options.along);
    const double size_x = dx * static_cast<double>(source.is_line             ? source.field.columns
                                                   : source.turned.size() > 0 ? source.field.columns
                                                                              : source.field.rows);
    const double size_y = dy * static_cast<double>(source.turned.size() > 0 ? source.field.rows : source.field.columns);
    double size = options.along == Along::y ? size_y : size_x;
    if (both) size = std::min(size_x, size_y);
    if (source.field.periodic) size *= std::min(1.0, 0.5 * options.order) * (1.0 + 1e-9);
    return distances_on_grid(options.grid.bins_per_decade, options.order * step, size);
}

/// Mean of the first row with a defined difference.
double origin_of(const Scale& scale, Buffer<double>& first, Buffer<double>& second) {
    for (Index i = scale.first_row(); i < scale.end_row(); ++i) {
        DifferenceSums sums;
        sums.add(scale.row(i, first, second), scale.columns(), 0.0);
        if (sums.count > 0.0) return sums.powers[0] / sums.count;
    }
    return 0.0;
}

DifferenceStatistics statistics_of_source(const Source& source, const DifferenceOptions& options,
                                          double reliable_from) {
    const Array1D distances = distances_of(source, options);
    const auto scales = extent(distances.size());
    std::vector<Scale> at;
    for (const double distance : distances) at.push_back(scale_of(source, options, distance));
    const std::size_t room = extent(source.field.columns);
    parallel::for_each_index(scales, options.threads, [&](std::size_t s) {
        Buffer<double> first(room), second(room);
        if (at[s].columns() > 0) at[s].origin = origin_of(at[s], first, second);
    });
    const Index blocks = (source.field.rows + block_rows - 1) / block_rows;
    std::vector<DifferenceSums> partial(extent(blocks) * scales);
    parallel::for_each_index(extent(blocks), options.threads, [&](std::size_t block) {
        Buffer<double> first(room), second(room);
        const Index begin = static_cast<Index>(block) * block_rows;
        for (std::size_t s = 0; s < scales; ++s) {
            const Scale& scale = at[s];
            if (scale.columns() == 0) continue;
            auto& sums = partial[block * scales + s];
            for (Index i = std::max(begin, scale.first_row()); i < std::min(begin + block_rows, scale.end_row()); ++i)
                sums.add(scale.row(i, first, second), scale.columns(), scale.origin);
        }
    });
    std::vector<DifferenceMoments> moments;
    for (std::size_t s = 0; s < scales; ++s) {
        DifferenceSums sums;
        for (Index block = 0; block < blocks; ++block) sums.add(partial[extent(block) * scales + s]);
        if (sums.count < static_cast<double>(std::max<Index>(1, options.fewest))) continue;
        moments.push_back({at[s].distance,
                           sums.count,
                           at[s].origin,
                           {sums.powers[0], sums.powers[1], sums.powers[2], sums.powers[3]},
                           sums.minimum,
                           sums.maximum});
    }
    auto result = statistics_of(moments, options, *source.metadata);
    result.reliable_from = reliable_from;
    return result;
}

void hand_over_rows(const Source& source, double distance, const DifferenceOptions& options,
                    const RowConsumer& consume) {
    if (!(distance > 0.0))
        throw InvalidArgument(
            fmt::format("{}: distance {} m; expected positive", topography::label(*source.metadata), distance));
    if (options.along == Along::both)
        throw InvalidArgument(topography::label(*source.metadata) +
                              ": differences by rows along both directions; compute x and y separately");
    const auto rows = rows_along(source, options.along, options, distance);
    if (rows.empty()) return;
    Buffer<double> values(extent(source.field.columns));
    for (Index i = rows.first_row; i < rows.end_row; ++i) {
        rows.fill(i, values.data());
        consume(i, rows.first_column, Eigen::Map<const Array1D>(values.data(), rows.end_column - rows.first_column));
    }
}

}  // namespace

DifferenceStatistics difference_statistics(const topography::HeightMap& map, const DifferenceOptions& options) {
    return statistics_of_source(
        source_of(map, options), options,
        0.5 * options.order * shortest_reliable_wavelength(map, options.reliability, options.threads));
}

DifferenceStatistics difference_statistics(const topography::LineScan& scan, const DifferenceOptions& options) {
    return statistics_of_source(
        source_of(scan, options), options,
        0.5 * options.order * shortest_reliable_wavelength(scan, options.reliability, options.threads));
}

DifferenceStatistics difference_statistics(const topography::Measurement& measurement,
                                           const DifferenceOptions& options) {
    return std::visit([&](const auto& m) { return difference_statistics(m, options); }, measurement);
}

void for_each_row_of_differences(const topography::HeightMap& map, double distance, const DifferenceOptions& options,
                                 const RowConsumer& consume) {
    hand_over_rows(source_of(map, options), distance, options, consume);
}

void for_each_row_of_differences(const topography::LineScan& scan, double distance, const DifferenceOptions& options,
                                 const RowConsumer& consume) {
    hand_over_rows(source_of(scan, options), distance, options, consume);
}

}  // namespace setae::scales
