// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/texture/profile_parameters.hpp"
#include "profile_parts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "parameter_rows.hpp"
#include "profile_lines.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/sample_mean.hpp"
#include "setae/texture/height_parameters.hpp"
#include "setae/topography/line_scans.hpp"
#include "spatial_parameters.hpp"

namespace setae::texture {
namespace {

/// Parameters of a part of a profile.
struct Stretch {
    HeightParameters heights;
    ProfileElements elements;
    ProfileSlopes slopes;
};

/// A value of each section.
Array1D values_of(const std::vector<Stretch>& sections, const std::function<double(const Stretch&)>& value) {
    Array1D values(static_cast<Index>(sections.size()));
    for (Index k = 0; k < values.size(); ++k) values[k] = value(sections[static_cast<std::size_t>(k)]);
    return values;
}

Estimate mean_over_sections(const Array1D& values) { return sample_mean(values, "sections"); }

double line_size(const MeasurementView& line) {
    const auto* scan = line.as<topography::LineScan>();
    return scan ? scan->size : line.as<topography::Profile>()->size();
}

bool has_undefined(const MeasurementView& line) {
    return line.visit([](const auto& m) { return m.heights.isNaN().any(); });
}

Stretch stretch(const MeasurementView& line, double mean_line, double section_length, double total_height,
                const Discrimination& discrimination, parallel::Threads threads) {
    Stretch result{height_parameters(line, threads, mean_line),
                   {undefined, undefined, undefined, undefined, 0},
                   profile_slopes(line)};
    if (!has_undefined(line))
        result.elements =
            profile_elements(line, discrimination.height * (total_height > 0.0 ? total_height : result.heights.Sz),
                             discrimination.length * section_length, mean_line);
    return result;
}

char letter_of(ProfileKind kind) {
    return kind == ProfileKind::primary ? 'P' : kind == ProfileKind::waviness ? 'W' : 'R';
}

/// Ral, or the reason for its absence.
void add_autocorrelation_length(ParameterRows& rows, const MeasurementView& line, double Rq) {
    const auto* scan = line.as<topography::LineScan>();
    if (scan && Rq > 0.0) rows.add("Ral", {autocorrelation_length(*scan)});
    else
        rows.add("Ral", {undefined},
                 {{"RAL_UNDEFINED", topography::label(line.metadata()),
                   scan ? "all heights are equal" : "an autocorrelation needs equal steps, and this is a polyline",
                   scan ? "check that the right channel was read and that the instrument was in contact"
                        : "resample the polyline"}});
}

/// Rows of the material ratio curve.
void add_curve(ParameterRows& rows, const MeasurementView& line, const ProfileOptions& options, double mean_line,
               parallel::Threads threads) {
    auto ratios = options.ratios;
    ratios.inverse = options.material_ratio;
    ratios.height = mean_line + options.material_height;
    const auto curve = functional_parameters(line, ratios, options.between, threads);
    rows.add("Rmr(c)", {curve.Smr});
    rows.add("Rmc(p)", {curve.Smc - mean_line});
    rows.add("Rdc", {curve.Sdc});
    rows.add("Rk", {curve.Sk});
    rows.add("Rpk", {curve.Spk});
    rows.add("Rvk", {curve.Svk});
    rows.add("Rmrk1", {curve.Smrk1});
    rows.add("Rmrk2", {curve.Smrk2});
    rows.add("Rak1", {curve.Sak1});
    rows.add("Rak2", {curve.Sak2});
    rows.add("Rpkx", {curve.Spkx});
    rows.add("Rvkx", {curve.Svkx});
    rows.add("Rvmp", {curve.Vmp});
    rows.add("Rvmc", {curve.Vmc});
    rows.add("Rvvc", {curve.Vvc});
    rows.add("Rvvv", {curve.Vvv});
}

ProfileOptions with_default_filters(ProfileOptions options, const MeasurementView& line, parallel::Threads threads) {
    const auto setting = default_setting(line, threads);
    options.filters.l_filter = options.filters.l_filter.value_or(setting.section_length);
    options.filters.s_filter = options.filters.s_filter.value_or(setting.s_filter);
    return options;
}

/// Mean of one row over all lines.
Quantity mean_of_row(const std::vector<std::vector<TextureParameter>>& lines, std::size_t row) {
    auto quantity = lines.front()[row].quantity;
    std::vector<double> values;
    quantity.n = 0;
    for (const auto& line : lines) {
        const auto& own = line[row].quantity;
        *quantity.n += own.n.value_or(0);
        if (std::isnan(own.estimate.value)) continue;
        if (values.empty()) quantity.alerts = own.alerts;
        values.push_back(own.estimate.value);
    }
    if (values.empty()) return quantity;
    const auto count = static_cast<double>(values.size());
    const Eigen::Map<const Array1D> all(values.data(), std::ssize(values));
    quantity.estimate = {.value = all.mean()};
    if (values.size() < 2) return quantity;
    quantity.estimate.standard_error = std::sqrt((all - all.mean()).square().sum() / (count * (count - 1.0)));
    quantity.estimate.method = "scan lines";
    return quantity;
}

}  // namespace

std::vector<TextureParameter> profile_parameters(const MeasurementView& line, const ProfileOptions& given,
                                                 parallel::Threads threads) {
    require_line(line);
    const auto options = given.default_filters ? with_default_filters(given, line, threads) : given;
    const auto own = filtered(line, options.filters, options.kind, threads);
    const MeasurementView view = own ? MeasurementView(*own) : line;
    const double size = line_size(view);
    const double section_length = options.section_length.value_or(options.filters.l_filter.value_or(size));
    const double mean_line = options.mean_line == MeanLine::zero ? 0.0 : height_parameters(view, threads).mean;

    std::vector<Stretch> parts;
    for (const auto& section : sections(view, section_length))
        parts.push_back(stretch(section, mean_line, section_length, 0.0, options.discrimination, threads));
    const auto section_heights = values_of(parts, [](const Stretch& s) { return s.heights.Sz; });
    const auto whole =
        stretch(view, mean_line, section_length, section_heights.mean(), options.discrimination, threads);

    ParameterRows rows(Standard::iso21920, description(options.filters, options.kind),
                       bandwidth(line, options.filters, options.kind, threads), undefined_alerts(line),
                       whole.heights.defined, options.only, letter_of(options.kind));
    const auto add = [&](std::string_view symbol, const std::function<double(const Stretch&)>& value) {
        rows.add(symbol, options.averages == Averages::sections ? mean_over_sections(values_of(parts, value))
                                                                : Estimate{value(whole)});
    };
    add("Rq", [](const Stretch& s) { return s.heights.Sq; });
    add("Rsk", [](const Stretch& s) { return s.heights.Ssk; });
    add("Rku", [](const Stretch& s) { return s.heights.Sku; });
    add("Ra", [](const Stretch& s) { return s.heights.Sa; });
    rows.add("Rt", {whole.heights.Sz});
    rows.add("Rp", mean_over_sections(values_of(parts, [](const Stretch& s) { return s.heights.Sp; })));
    rows.add("Rv", mean_over_sections(values_of(parts, [](const Stretch& s) { return s.heights.Sv; })));
    rows.add("Rz", mean_over_sections(section_heights));
    rows.add("Rzx", {section_heights.maxCoeff()});
    add("RSm", [](const Stretch& s) { return s.elements.RSm; });
    add("RSmq", [](const Stretch& s) { return s.elements.RSmq; });
    add("Rc", [](const Stretch& s) { return s.elements.Rc; });
    add("Rcq", [](const Stretch& s) { return s.elements.Rcq; });
    add("Rdq", [](const Stretch& s) { return s.slopes.Rdq; });
    add("Rda", [](const Stretch& s) { return s.slopes.Rda; });
    add("Rdq_2", [](const Stretch& s) { return s.slopes.Rdq_2; });
    rows.add("Rdt", {whole.slopes.Rdt});
    rows.add("Rdl", {(1.0 + whole.slopes.Rdr) * size});
    rows.add("Rdr", {whole.slopes.Rdr});
    if (is_requested(options.only, {"Ral"})) add_autocorrelation_length(rows, view, whole.heights.Sq);
    if (is_requested(options.only, {"Rmr(c)", "Rmc(p)", "Rdc", "Rk", "Rpk", "Rvk", "Rmrk1", "Rmrk2", "Rak1", "Rak2",
                                    "Rpkx", "Rvkx", "Rvmp", "Rvmc", "Rvvc", "Rvvv"}))
        add_curve(rows, view, options, mean_line, threads);
    return rows.take();
}

std::vector<TextureParameter> mean_profile_parameters(const topography::HeightMap& map, const ProfileOptions& options,
                                                      parallel::Threads threads) {
    std::vector<std::vector<TextureParameter>> lines;
    for (const auto& line : topography::line_scans(map))
        if ((!line.heights.isNaN()).count() > 1) lines.push_back(profile_parameters(line, options, threads));
    if (lines.empty())
        throw UndefinedDataError(topography::label(map.metadata) + ": no scan line has two defined heights");
    auto rows = lines.front();
    for (std::size_t row = 0; row < rows.size(); ++row) rows[row].quantity = mean_of_row(lines, row);
    return rows;
}

}  // namespace setae::texture
