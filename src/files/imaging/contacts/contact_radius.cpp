// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/contact_radius.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::imaging {
namespace {

constexpr double undefined_radius = std::numeric_limits<double>::quiet_NaN();

/// Reason of each excluded frame of the source.
std::vector<const std::string*> exclusions(const FrameSource& source, const std::vector<ExcludedFrame>& excluded) {
    std::vector<const std::string*> reasons(source.size(), nullptr);
    for (const auto& [number, reason] : excluded) {
        if (trimmed(reason).empty())
            throw InvalidArgument(fmt::format("frame {} is excluded without a reason; give the reason", number));
        std::size_t at = 0;
        while (at < source.size() && source.number(at) != number) ++at;
        if (at == source.size())
            throw InvalidArgument(
                fmt::format("frame {} is excluded, but the recording contributes only frames {} to {}", number,
                            source.number(0), source.number(source.size() - 1)));
        reasons[at] = &reason;
    }
    return reasons;
}

ContactFrame no_measurement(FrameState state, std::string reason) {
    ContactFrame frame;
    frame.state = state;
    frame.reason = std::move(reason);
    frame.radius = frame.radius_standard_error = frame.roundness = frame.roundness_standard_error =
        frame.contrast_to_noise = frame.edge_width = undefined_radius;
    frame.ellipse = {undefined_radius, undefined_radius, undefined_radius, undefined_radius,
                     undefined_radius, undefined_radius, undefined_radius, undefined_radius};
    return frame;
}

ContactFrame measured(const FrameSource& source, std::size_t index, const ContactFrameOptions& options) {
    const auto read = source.read(index);
    if (!read.fault.empty()) return no_measurement(FrameState::bad_frame, read.fault);
    auto frame = measure_contact_frame(read.pixels, options);
    frame.ellipse.centre_x += static_cast<double>(source.region().x);
    frame.ellipse.centre_y += static_cast<double>(source.region().y);
    return frame;
}

/// The polarity of most frames by their confidence; automatic if nothing was measured.
Polarity majority(const std::vector<ContactRadius>& frames) {
    double dark = 0, bright = 0;
    for (const auto& frame : frames)
        if (frame.contact.state == FrameState::measured)
            (frame.contact.polarity == Polarity::dark ? dark : bright) += frame.contact.confidence;
    return dark + bright == 0 ? Polarity::automatic : dark >= bright ? Polarity::dark : Polarity::bright;
}

RadiusSummary summary_of(const std::vector<ContactRadius>& frames, std::size_t missing) {
    RadiusSummary summary{.frames = frames.size(), .missing = missing};
    for (const auto& frame : frames) {
        switch (frame.contact.state) {
            case FrameState::measured: ++summary.measured; break;
            case FrameState::no_contact: ++summary.no_contact; break;
            case FrameState::not_found: ++summary.not_found; break;
            case FrameState::bad_frame: ++summary.bad; break;
            case FrameState::excluded: ++summary.excluded; break;
        }
        summary.partial += frame.contact.partial ? 1 : 0;
    }
    return summary;
}

/// "3, 7 to 9".
std::string ranges(const std::vector<long>& numbers) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < numbers.size();) {
        auto end = i;
        while (end + 1 < numbers.size() && numbers[end + 1] == numbers[end] + 1) ++end;
        parts.push_back(end == i ? fmt::format("{}", numbers[i]) : fmt::format("{} to {}", numbers[i], numbers[end]));
        i = end + 1;
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

template <class Value>
Column column(const ContactRadii& radii, const char* name, const char* unit, Value value) {
    Column result{name, unit, Array1D(static_cast<Index>(radii.frames.size()))};
    for (std::size_t i = 0; i < radii.frames.size(); ++i) result.values[static_cast<Index>(i)] = value(radii.frames[i]);
    return result;
}

}  // namespace

ContactRadii measure_contact_radii(const FrameSource& source, const RadiusOptions& options) {
    if (!source.pixel_size())
        throw InvalidArgument(
            "no pixel size: the files state none; expected it in `pixel`, such as \"1.82 um\" per pixel");
    const auto reasons = exclusions(source, options.excluded);
    ContactRadii radii{.pixel_size = *source.pixel_size(), .frame_rate = source.frame_rate(), .notes = source.notes()};
    radii.frames.resize(source.size());
    const auto measure = [&](std::size_t index, const ContactFrameOptions& how) {
        auto& frame = radii.frames[index];
        frame.contact =
            reasons[index] ? no_measurement(FrameState::excluded, *reasons[index]) : measured(source, index, how);
        frame.number = source.number(index);
        frame.name = source.name(index);
        frame.time = source.time(index);
        frame.radius = frame.contact.radius * radii.pixel_size;
        frame.standard_error = frame.contact.radius_standard_error * radii.pixel_size;
    };
    parallel::for_each_index(source.size(), options.threads, [&](std::size_t index) { measure(index, options.frame); });
    radii.polarity = options.frame.polarity;
    if (radii.polarity == Polarity::automatic) {
        radii.polarity = majority(radii.frames);
        std::vector<std::size_t> others;
        for (std::size_t i = 0; i < radii.frames.size(); ++i)
            if (radii.frames[i].contact.state == FrameState::measured &&
                radii.frames[i].contact.polarity != radii.polarity)
                others.push_back(i);
        auto given = options.frame;
        given.polarity = radii.polarity;
        parallel::for_each_index(others.size(), options.threads, [&](std::size_t k) { measure(others[k], given); });
    }
    radii.summary = summary_of(radii.frames, source.missing().size());
    if (!source.missing().empty())
        radii.notes.push_back(
            fmt::format("frames missing from the sequence: {}; the times of the other frames are unchanged",
                        ranges(source.missing())));
    return radii;
}

Table as_table(const ContactRadii& radii) {
    const double pixel = radii.pixel_size;
    const auto seen = [](double value, const ContactRadius& f) {
        return f.contact.state == FrameState::measured ? value : undefined_radius;
    };
    Table table;
    table.columns = {
        column(radii, "time", "s", [](const auto& f) { return f.time; }),
        column(radii, "contact_radius", "m", [](const auto& f) { return f.radius; }),
        column(radii, "contact_radius_standard_error", "m", [](const auto& f) { return f.standard_error; }),
        column(radii, "frame", "1", [](const auto& f) { return static_cast<double>(f.number); }),
        column(radii, "semi_major", "m", [&](const auto& f) { return pixel * f.contact.ellipse.semi_major; }),
        column(radii, "semi_minor", "m", [&](const auto& f) { return pixel * f.contact.ellipse.semi_minor; }),
        column(radii, "roundness", "1", [](const auto& f) { return f.contact.roundness; }),
        column(radii, "confidence", "1", [&](const auto& f) { return seen(f.contact.confidence, f); }),
        column(radii, "agreeing_rays", "1", [&](const auto& f) { return seen(f.contact.agreeing_rays, f); }),
        column(radii, "visible_share", "1", [&](const auto& f) { return seen(f.contact.visible_share, f); }),
        column(radii, "contrast_to_noise", "1", [](const auto& f) { return f.contact.contrast_to_noise; }),
        column(radii, "centre_x", "m", [&](const auto& f) { return pixel * f.contact.ellipse.centre_x; }),
        column(radii, "centre_y", "m", [&](const auto& f) { return pixel * f.contact.ellipse.centre_y; }),
        column(radii, "state", "1", [](const auto& f) { return static_cast<double>(f.contact.state); }),
    };
    const auto& s = radii.summary;
    table.metadata = {{"pixel_size", fmt::format("{:.9g} m", radii.pixel_size)},
                      {"frame_rate", fmt::format("{:.9g} 1/s", radii.frame_rate)},
                      {"polarity", to_string(radii.polarity)},
                      {"frames", fmt::format("{} measured, {} without contact, {} not found, {} bad, {} excluded",
                                             s.measured, s.no_contact, s.not_found, s.bad, s.excluded)},
                      {"state", "0 measured, 1 no contact, 2 not found, 3 bad frame, 4 excluded"}};
    return table;
}

std::string as_csv(const ContactRadii& radii) {
    const auto table = as_table(radii);
    std::string text;
    for (const auto& [key, value] : table.metadata) text += fmt::format("# {}: {}\n", key, value);
    for (const auto& frame : radii.frames) {
        if (frame.contact.reason.empty()) continue;
        std::string comment = to_string(frame.contact.state) + ": " + frame.contact.reason;
        std::replace_if(
            comment.begin(), comment.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
        text += fmt::format("# frame {}: {}\n", frame.number, comment);
    }
    return text + tables::as_csv(table);
}

std::string to_string(FrameState state) {
    switch (state) {
        case FrameState::measured: return "measured";
        case FrameState::no_contact: return "no contact";
        case FrameState::not_found: return "not found";
        case FrameState::bad_frame: return "bad frame";
        case FrameState::excluded: return "excluded";
    }
    throw InternalError("a state of frames without a name");
}

std::string to_string(Polarity polarity) {
    switch (polarity) {
        case Polarity::automatic: return "automatic";
        case Polarity::dark: return "dark";
        case Polarity::bright: return "bright";
    }
    throw InternalError("a polarity without a name");
}

}  // namespace setae::imaging
