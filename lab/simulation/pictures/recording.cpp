// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/recording.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "setae/bytes/tiff_writer.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::simulation {
namespace {

constexpr double min_radius = 1.0;  ///< that pixels show [px]
constexpr double margin = 30.0;     ///< around the widest contact [px]

void require_camera(const RecordingOptions& options) {
    const auto require = [](bool holds, const char* what, double value) {
        if (!holds) throw InvalidArgument(fmt::format("{} {} is outside its domain", what, value));
    };
    require(options.pixel_size > 0.0 && std::isfinite(options.pixel_size), "pixel size", options.pixel_size);
    require(options.frame_rate > 0.0 && std::isfinite(options.frame_rate), "frame rate", options.frame_rate);
    require(options.blur > 0.0 && options.blur < 0.2 * margin, "blur", options.blur);
    require(options.noise >= 0.0 && options.noise < 256.0, "noise", options.noise);
    require(options.inside >= 0.0 && options.inside <= 255.0, "grey level inside", options.inside);
    require(options.contrast != 0.0 && options.inside + options.contrast >= 0.0 &&
                options.inside + options.contrast <= 255.0,
            "contrast", options.contrast);
}

/// One frame's edge in pixels, by angle.
class FrameEdge {
public:
    FrameEdge(const Array1D& radius, double pixel_size) : radius_(radius / pixel_size) {}

    /// Distance of a position outside the edge [px], along the edge's normal.
    [[nodiscard]] double outside(double x, double y) const {
        const auto n = static_cast<double>(radius_.size());
        const double turn = std::atan2(y, x) / (2.0 * pi), place = (turn - std::floor(turn)) * n;
        const Index left = static_cast<Index>(place) % radius_.size(), right = (left + 1) % radius_.size();
        const double share = place - std::floor(place), step = radius_[right] - radius_[left];
        const double r = radius_[left] + share * step, slope = step * n / (2.0 * pi);
        return (std::hypot(x, y) - r) * r / std::hypot(r, slope);
    }

private:
    Array1D radius_;
};

}  // namespace

RecordingShape write_recording(const std::string& path, const contact_line::ContactLine& edge,
                               const RecordingOptions& options) {
    constexpr double max_pixels = 1e7, max_frames = 1e5;
    require_camera(options);
    contact_line::require_valid(edge);
    const double smallest = edge.radius.minCoeff() / options.pixel_size,
                 largest = edge.radius.maxCoeff() / options.pixel_size,
                 duration = edge.time[edge.frames() - 1] - edge.time[0];
    if (smallest < min_radius)
        throw InvalidArgument(
            fmt::format("the edge comes to {:.1f} px from its centre; expected {} at least, as with "
                        "pixels of {}",
                        smallest, min_radius, format_value(edge.radius.minCoeff() / min_radius, "m", 2)));
    const double side = 2.0 * std::ceil(largest + margin) + 1.0,
                 frames = std::floor(duration * options.frame_rate) + 1.0;
    if (side * side > max_pixels || frames > max_frames)
        throw InvalidArgument(fmt::format("{:.0f} frames of {:.0f} x {:.0f} px; expected at most {:.0g} of {:.0g} px",
                                          frames, side, side, max_frames, max_pixels));
    const RecordingShape shape{static_cast<int>(frames), static_cast<long>(side), static_cast<long>(side)};
    const Array1D times = edge.time[0] + Array1D::LinSpaced(shape.frames, 0.0, static_cast<double>(shape.frames - 1)) /
                                             options.frame_rate;
    const auto seen = contact_line::at_times(edge, times.min(edge.time[edge.frames() - 1]));
    const double centre = 0.5 * (side - 1.0);
    const bytes::GreyPages pages{
        .width = static_cast<std::uint32_t>(shape.width),
        .height = static_cast<std::uint32_t>(shape.height),
        .count = shape.frames,
        .description = fmt::format("ImageJ=1.53\nimages={}\nunit=um\nfinterval={}\nfps={}\nloop=false\n", shape.frames,
                                   1.0 / options.frame_rate, options.frame_rate),
        .pixels_per_unit = 1e-6 / options.pixel_size};
    bytes::write_tiff(path, pages, [&](int frame, std::span<std::uint8_t> pixels) {
        const FrameEdge now(seen.radius.row(frame).transpose(), options.pixel_size);
        parallel::for_each_index(static_cast<std::size_t>(shape.height), options.threads, [&](std::size_t row) {
            const auto at = static_cast<std::uint64_t>(row) * static_cast<std::uint64_t>(shape.width);
            const Array1D noise = numerics::normal_numbers(
                numerics::substream({options.seed, 0}, static_cast<std::uint64_t>(frame)), at, shape.width);
            for (Index column = 0; column < shape.width; ++column) {
                const double d = now.outside(static_cast<double>(column) - centre, static_cast<double>(row) - centre);
                const double grey = options.inside +
                                    0.5 * options.contrast * (1.0 + std::erf(d / (std::sqrt(2.0) * options.blur))) +
                                    options.noise * noise[column];
                pixels[at + static_cast<std::uint64_t>(column)] =
                    static_cast<std::uint8_t>(std::clamp(std::round(grey), 0.0, 255.0));
            }
        });
    });
    return shape;
}

}  // namespace setae::simulation
