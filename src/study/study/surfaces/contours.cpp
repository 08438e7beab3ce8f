// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/contours.hpp"

#include <cmath>
#include <filesystem>
#include <limits>

#include <fmt/format.h>

#include "foil_alert.hpp"
#include "setae/bytes/digest.hpp"
#include "setae/bytes/source.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/profile_file.hpp"
#include "setae/imaging/contour_overlay.hpp"
#include "setae/imaging/contour_profile.hpp"

namespace setae::study {
namespace {

/// (1/L) ∫ h² dx over straight segments.
double mean_square(const topography::Profile& profile) {
    double sum = 0;
    for (Index i = 1; i < profile.positions.size(); ++i) {
        const double a = profile.heights[i - 1], b = profile.heights[i];
        sum += (profile.positions[i] - profile.positions[i - 1]) * (a * a + a * b + b * b) / 3.0;
    }
    return sum / profile.size();
}

ContourProfile profile_of(const imaging::ContourSegment& segment, const TracedPicture& picture,
                          const ContourOptions& options) {
    ContourProfile profile;
    profile.curve = imaging::traced_curve(segment, picture.calibration.pixel_size);
    auto& metadata = profile.curve.metadata;
    metadata.name = std::filesystem::path(picture.micrograph.file).stem().string();
    metadata.file = picture.micrograph.file;
    metadata.instrument.type = "tem";
    metadata.instrument.name = picture.micrograph.instrument;
    metadata.acquisition_time = picture.micrograph.acquisition_time;
    if (options.foil_thickness) {
        if (!(*options.foil_thickness > 0))
            throw InvalidArgument(fmt::format("foil thickness {} m, expected more than 0", *options.foil_thickness));
        metadata.attributes["foil_thickness"] = fmt::format("{} m", *options.foil_thickness);
    }
    profile.levelled =
        topography::levelled(profile.curve, options.shape == ContourShape::cut ? topography::Reentrance::cut
                                                                               : topography::Reentrance::envelope);
    profile.statistics = topography::parametric_statistics(profile.curve);
    const auto& errors = profile.levelled.profile.standard_error;
    profile.rms_error = errors.size() > 0 ? std::sqrt(errors.square().mean()) : 0.0;
    profile.rms_height =
        std::sqrt(std::max(0.0, mean_square(profile.levelled.profile) - profile.rms_error * profile.rms_error));
    return profile;
}

Alert foil_alert(const std::string& subject, const std::optional<double>& thickness) {
    if (thickness) return foil_projection_alert(subject, *thickness);
    return {"FOIL_THICKNESS", subject,
            "the contour is the silhouette of a foil of unknown thickness: C1D is too low for wavelengths "
            "below about ten times the thickness",
            "give `foil_thickness`; docs/concepts/tem-projection.md gives the size of the effect"};
}

void take(std::vector<Alert>& alerts, std::vector<Alert> more, const std::string& subject) {
    for (auto& alert : more) {
        alert.subject = alert.subject.empty() || alert.subject == "picture" ? subject
                        : alert.subject.starts_with("segment")              ? subject + ", " + alert.subject
                                                                            : alert.subject;
        alerts.push_back(std::move(alert));
    }
}

/// A message that begins with the file.
std::string named(const std::string& path, const Error& error) {
    const std::string message = error.what();
    return message.starts_with(path) ? message : path + ": " + message;
}

std::string curve_text(const ContourProfile& profile) {
    const auto& curve = profile.curve;
    std::string text = "s [m],x [m],y [m],standard_error [m]\n";
    double along = 0;
    for (Index i = 0; i < curve.x.size(); ++i) {
        if (i > 0) along += std::hypot(curve.x[i] - curve.x[i - 1], curve.y[i] - curve.y[i - 1]);
        text += fmt::format("{},{},{},{}\n", along, curve.x[i], curve.y[i], curve.standard_error[i]);
    }
    return text;
}

}  // namespace

TracedPicture trace_picture(const std::string& path, const ContourOptions& options) {
    TracedPicture picture;
    picture.micrograph = imaging::read_micrograph(path, options.micrograph);
    picture.digest = bytes::sha256(bytes::file_source(path));
    take(picture.alerts, picture.micrograph.alerts, path);
    try {
        if (options.shared_calibration) {
            picture.calibration = *options.shared_calibration;
            imaging::check_same_magnification(picture.calibration, picture.micrograph);
        } else {
            picture.calibration = imaging::calibrate(picture.micrograph, options.calibration);
            take(picture.alerts, picture.calibration.alerts, path);
        }
        auto trace_options = options.trace;
        if (options.hide_annotations)
            for (const auto& region : imaging::annotations(picture.micrograph.pixels))
                trace_options.hidden.push_back(region);
        picture.hidden = trace_options.hidden;
        picture.trace = imaging::trace_contour(picture.micrograph.pixels, trace_options);
        take(picture.alerts, picture.trace.alerts, path);
        for (std::size_t i = 0; i < picture.trace.segments.size(); ++i) {
            picture.profiles.push_back(profile_of(picture.trace.segments[i], picture, options));
            take(picture.alerts, picture.profiles.back().levelled.alerts,
                 picture.trace.segments.size() > 1 ? fmt::format("{}, segment {}", path, i + 1) : path);
        }
    } catch (const InvalidArgument& error) {
        throw InvalidArgument(named(path, error));
    } catch (const UndefinedDataError& error) {
        throw UndefinedDataError(named(path, error));
    }
    if (!picture.trace.binary) picture.alerts.push_back(foil_alert(path, options.foil_thickness));
    return picture;
}

std::string overlay_of(const TracedPicture& picture, const ContourOptions& options) {
    return imaging::overlay_png(
        picture.micrograph.pixels, picture.trace,
        {.hidden = picture.hidden, .calibration = picture.calibration, .anchors = options.trace.anchors});
}

std::string profile_text(const TracedPicture& picture, std::size_t segment, ContourShape shape) {
    const auto& profile = picture.profiles.at(segment);
    return shape == ContourShape::parametric ? curve_text(profile) : formats::as_profile_file(profile.levelled.profile);
}

tables::TidyTable contour_table() {
    return {"",
            {"file", "segment", "state", "pixel_x [m]", "pixel_y [m]", "length [m]", "points", "Rq [m]",
             "rms_error [m]", "noise_density [m3]", "blur [m]", "contrast_to_noise", "rotation [rad]", "tortuosity",
             "reentrant_share", "reentrant_stretches", "alerts or failure"},
            {}};
}

void add_rows(tables::TidyTable& table, const TracedPicture& picture) {
    std::string codes;
    for (const auto& alert : picture.alerts) codes += (codes.empty() ? "" : " ") + alert.code;
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < picture.profiles.size(); ++i) {
        const auto& p = picture.profiles[i];
        const auto& response = p.levelled.profile.response;
        table.rows.push_back({picture.micrograph.file, static_cast<double>(i + 1),
                              picture.trace.binary ? std::string("binary") : std::string("traced"),
                              picture.calibration.pixel_size.x, picture.calibration.pixel_size.y, p.statistics.length,
                              static_cast<double>(p.levelled.profile.positions.size()), p.rms_height, p.rms_error,
                              response ? response->noise_density : none, response ? response->blur : none,
                              picture.trace.segments[i].contrast_to_noise, p.levelled.rotation, p.statistics.tortuosity,
                              p.levelled.reentrant_share, static_cast<double>(p.levelled.reentrant.size()), codes});
    }
}

void add_failure(tables::TidyTable& table, const std::string& path, const std::string& error) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<tables::TidyTable::Cell> row{path, none, std::string("failed")};
    while (row.size() + 1 < table.columns.size()) row.emplace_back(none);
    row.emplace_back(error);
    table.rows.push_back(row);
}

}  // namespace setae::study
