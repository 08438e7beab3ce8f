// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "container_measurement.hpp"
#include "setae/bytes/temporary_folder.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/formats/container_draft.hpp"

namespace setae::formats {
namespace {

double rms(const Array1D& heights) {
    const auto defined = !heights.isNaN();
    const double count = static_cast<double>(defined.count());
    const double mean = defined.select(heights, 0.0).sum() / count;
    return std::sqrt(defined.select((heights - mean).square(), 0.0).sum() / count);
}

/// Difference between a processed copy and the original processed as in the index; empty if they agree to a thousandth,
/// the tolerance for other programs' fits of trends.
std::optional<std::string> difference_of_copy(const topography::Measurement& original,
                                              const topography::Measurement& copy, const std::string& detrend_mode) {
    constexpr double tolerance = 1e-3;
    if (topography::shape(original) != topography::shape(copy)) return "they have different numbers of points";
    const auto trend = trend_of(detrend_mode).value_or(topography::Trend::mean);
    const auto expected = topography::all_heights(topography::detrended(original, trend));
    const auto found = topography::all_heights(topography::detrended(copy, trend));
    const double rms_expected = rms(expected), rms_found = rms(found);
    if (std::abs(rms_found / rms_expected - 1.0) > tolerance)
        return fmt::format("the rms height of the copy is {}, that of the original {}", format_value(rms_found, "m"),
                           format_value(rms_expected, "m"));
    const auto both = !expected.isNaN() && !found.isNaN();
    const double largest = both.select((found - expected).abs(), 0.0).maxCoeff();
    if (largest > tolerance * rms_expected * 10.0)
        return fmt::format("the rms heights are equal, but points differ by up to {}", format_value(largest, "m"));
    return std::nullopt;
}

/// A measurement of the index with the heights of the processed copy.
ContainerTopography only_copy(ContainerTopography topography) {
    topography.datafile.original.clear();
    return topography;
}

class Check {
public:
    Check(const bytes::Source& source, ContainerReport& report) : source_(source), archive_(source), report_(report) {}

    void measurement(const ContainerSurface& surface, const ContainerTopography& topography) {
        const auto place = fmt::format("{} / {}", surface.name, topography.name);
        const auto channel = container_channel(source_, archive_, surface, topography);
        for (auto alert : channel.info.alerts) {
            alert.subject = place;
            report_.alerts.push_back(std::move(alert));
        }
        report_.channels.push_back(channel.info);
        if (repeats_scale(archive_, topography))
            report_.alerts.push_back(
                {"SCALE_TWICE", place,
                 fmt::format("the index repeats the height scale {}, which {} already contains; setae applies it once",
                             *topography.height_scale, topography.datafile.original),
                 "remove it from the index with `setae container write`; programs that apply both scales have "
                 "heights wrong by this factor"});
        if (channel.info.is_height) heights(channel, surface, topography, place);
    }

private:
    void heights(const Channel& channel, const ContainerSurface& surface, const ContainerTopography& topography,
                 const std::string& place) {
        const auto &original = topography.datafile.original, &squeezed = topography.datafile.squeezed;
        try {
            const auto measurement = channel.read();
            if (original.empty() || squeezed.empty() || !archive_.has(original)) return;
            const bool filled =
                !topography.fill_undefined_data_mode.empty() && topography.fill_undefined_data_mode != "do-not-fill";
            if (filled && topography::all_heights(measurement).isNaN().any()) return;
            const auto copy = container_channel(source_, archive_, surface, only_copy(topography));
            if (const auto difference = difference_of_copy(measurement, copy.read(), topography.detrend_mode))
                report_.alerts.push_back({"COPY_DIFFERS", place,
                                          fmt::format("the processed copy {} differs from the original {}: {}",
                                                      squeezed, original, *difference),
                                          "the original is used; find out which of the two is right"});
        } catch (const std::exception& error) {
            report_.alerts.push_back({"UNREADABLE_MEMBER", place, reason_of(error),
                                      "the other measurements are not affected; repair or replace this one"});
        }
    }

    const bytes::Source& source_;
    bytes::Archive archive_;
    ContainerReport& report_;
};

std::vector<std::string> differences_after_writing(const bytes::Source& source, const ContainerFile& file) {
    const bytes::TemporaryFolder folder("check");
    const auto written = folder.file("written.zip");
    std::vector<ContainerMember> members;
    const bytes::Archive archive(source);
    for (const auto& name : file.members) members.push_back({name, [archive, name] { return archive.member(name); }});
    write_container(written, file.container, members);
    return container_differences(source, bytes::file_source(written));
}

}  // namespace

ContainerReport check_container(const bytes::Source& source) {
    ContainerReport report;
    report.file = read_container(source);
    report.alerts = report.file.alerts;
    for (auto& violation : schema_violations(report.file.container)) {
        const bool reported = std::any_of(report.alerts.begin(), report.alerts.end(),
                                          [&](const Alert& alert) { return alert.subject == violation.subject; });
        if (!reported) report.alerts.push_back(std::move(violation));
    }
    Check check(source, report);
    for (const auto& surface : report.file.container.surfaces)
        for (const auto& topography : surface.topographies) check.measurement(surface, topography);
    report.differences = differences_after_writing(source, report.file);
    return report;
}

}  // namespace setae::formats
