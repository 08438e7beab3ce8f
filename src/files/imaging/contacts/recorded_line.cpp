// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/imaging/contact_outline.hpp"

namespace setae::imaging {
namespace {

constexpr double arc_per_ray = 2.0;  // px of the largest edge
constexpr Index min_rays = 32;

struct Traced {
    ContactOutline outline;
    std::string failure;
};

Traced traced(const FrameSource& source, std::size_t index, const ContactFrame& contact, double x, double y,
              Index angles, double smallest_void) {
    const auto read = source.read(index);
    if (!read.fault.empty()) return {{}, read.fault};
    const auto left = static_cast<double>(source.region().x), top = static_cast<double>(source.region().y);
    auto within = contact;  // [px] of the region
    within.ellipse.centre_x -= left;
    within.ellipse.centre_y -= top;
    try {
        auto outline = trace_contact_outline(read.pixels, within, x - left, y - top, angles, smallest_void);
        for (auto& hole : outline.voids) {
            hole.x += left;
            hole.y += top;
        }
        return {std::move(outline), {}};
    } catch (const InvalidArgument& e) {
        return {{}, e.what()};
    }
}

}  // namespace

RecordedLine measure_contact_line(const FrameSource& source, const ContactRadii& radii, const LineOptions& options) {
    RecordedLine recorded{.pixel_size = radii.pixel_size};
    std::vector<std::size_t> whole;
    double largest = 0.0;
    for (std::size_t i = 0; i < radii.frames.size(); ++i) {
        const auto& contact = radii.frames[i].contact;
        if (contact.state == FrameState::no_contact) continue;
        if (contact.state != FrameState::measured || contact.partial) {
            recorded.left_out.push_back(fmt::format("frame {}: {}", radii.frames[i].number, contact.reason));
            continue;
        }
        whole.push_back(i);
        recorded.centre_x += contact.ellipse.centre_x;
        recorded.centre_y += contact.ellipse.centre_y;
        largest = std::max(largest, contact.radius);
    }
    if (whole.empty())
        throw UndefinedDataError(fmt::format("none of {} frames shows a whole contact{}", radii.frames.size(),
                                             recorded.left_out.empty() ? "" : "; " + recorded.left_out.front()));
    recorded.centre_x /= static_cast<double>(whole.size());
    recorded.centre_y /= static_cast<double>(whole.size());
    const Index angles =
        options.angles.value_or(std::max(min_rays, 2 * static_cast<Index>(std::ceil(pi * largest / arc_per_ray))));
    std::vector<Traced> lines(whole.size());
    parallel::for_each_index(whole.size(), options.threads, [&](std::size_t k) {
        lines[k] = traced(source, whole[k], radii.frames[whole[k]].contact, recorded.centre_x, recorded.centre_y,
                          angles, options.smallest_void);
    });
    const auto rows = std::count_if(lines.begin(), lines.end(), [](const Traced& t) { return t.failure.empty(); });
    recorded.time.resize(rows);
    recorded.radius.resize(rows, angles);
    double noise = 0.0;
    Index row = 0;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const auto& frame = radii.frames[whole[k]];
        if (!lines[k].failure.empty()) {
            recorded.left_out.push_back(fmt::format("frame {}: {}", frame.number, lines[k].failure));
            continue;
        }
        recorded.frames.push_back(frame.number);
        recorded.time[row] = frame.time;
        recorded.radius.row(row++) = radii.pixel_size * lines[k].outline.radius.transpose();
        noise += std::pow(radii.pixel_size * lines[k].outline.place_error, 2);
        recorded.voids.push_back(std::move(lines[k].outline.voids));
    }
    if (rows == 0)
        throw UndefinedDataError(fmt::format("no frame shows the whole edge; {}", recorded.left_out.front()));
    recorded.place_error = std::sqrt(noise / static_cast<double>(rows));
    return recorded;
}

}  // namespace setae::imaging
