// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Output of `setae jkr radius`.

#include <optional>
#include <string_view>
#include <vector>

#include "setae/answers/contact_radii.hpp"
#include "setae/fields/describe.hpp"

namespace setae::answers {

/// A number of a picture with its standard error, which is null where it is unknown.
struct MeasuredInPicture {
    std::string_view quantity, symbol;
    double value;
    std::string_view unit;
    double standard_error;
};

/// A frame of a recording.
struct RadiusFrame {
    const imaging::ContactRadius* frame;
    double pixel_size;  ///< [m]
};
/// The ellipse of a frame in which the contact was measured.
struct FrameEllipse {
    const imaging::ContactFrame* contact;
    double pixel_size;  ///< [m]

    /// From pixels.
    [[nodiscard]] MeasuredInPicture length(std::string_view quantity, std::string_view symbol, double value,
                                           double standard_error) const {
        return {quantity, symbol, pixel_size * value, "m", pixel_size * standard_error};
    }
};

}  // namespace setae::answers

namespace setae::fields {

template <>
struct Described<answers::MeasuredInPicture> {
    using T = answers::MeasuredInPicture;
    static constexpr std::array rows{
        field<&T::quantity>("quantity", "name of the quantity"),
        field<&T::symbol>("symbol", "symbol of the quantity in formulas"),
        field<&T::value>("value", "value in SI units"),
        field<&T::unit>("unit", "unit of value and standard error"),
        field<&T::standard_error>("standard_error", "one standard deviation; null if it is unknown"),
    };
    static constexpr Description description{"", "a number of a picture with its standard error", rows};
};
static_assert(complete<answers::MeasuredInPicture>);

template <>
struct Described<answers::FrameEllipse> {
    using T = answers::FrameEllipse;
    static constexpr std::array rows_of_centre{
        made<T>("x", "coordinate along x", [](const T& of) { return of.pixel_size * of.contact->ellipse.centre_x; })
            .in_unit("m"),
        made<T>("y", "coordinate along y", [](const T& of) { return of.pixel_size * of.contact->ellipse.centre_y; })
            .in_unit("m"),
        made<T>("standard_error", "standard error of both coordinates",
                [](const T& of) { return of.pixel_size * of.contact->ellipse.centre_standard_error; })
            .in_unit("m"),
        made<T>("unit", "unit of the coordinates", [](const T&) { return std::string_view("m"); }),
    };
    static constexpr Description centre{"", "centre of the ellipse", rows_of_centre};
    static constexpr std::array rows{
        made<T>("semi_major", "semi-major axis of the ellipse",
                [](const T& of) {
                    const auto& ellipse = of.contact->ellipse;
                    return of.length("semi-major axis", "a1", ellipse.semi_major, ellipse.semi_major_standard_error);
                })
            .in_unit("m"),
        made<T>("semi_minor", "semi-minor axis of the ellipse",
                [](const T& of) {
                    const auto& ellipse = of.contact->ellipse;
                    return of.length("semi-minor axis", "a2", ellipse.semi_minor, ellipse.semi_minor_standard_error);
                })
            .in_unit("m"),
        made_value<T>("angle", "rad", "angle of the major axis, from x towards y",
                      [](const T& of) { return of.contact->ellipse.angle; }),
        made<T>("roundness", "semi-minor axis divided by semi-major axis",
                [](const T& of) {
                    return answers::MeasuredInPicture{"roundness", "a2/a1", of.contact->roundness, "1",
                                                      of.contact->roundness_standard_error};
                })
            .in_unit("1"),
        part<T>("centre", "centre of the ellipse", centre),
        made<T>("confidence", "confidence from 0 to 1", [](const T& of) { return of.contact->confidence; }),
        made<T>("agreeing_rays", "share of the visible rays that agree",
                [](const T& of) { return of.contact->agreeing_rays; }),
        made<T>("visible_share", "share of the perimeter within the frame",
                [](const T& of) { return of.contact->visible_share; }),
        made<T>("contrast_to_noise", "contrast of the edge divided by the standard deviation of one pixel",
                [](const T& of) { return of.contact->contrast_to_noise; }),
        made_value<T>("edge_width", "m", "width of the edge",
                      [](const T& of) { return of.pixel_size * of.contact->edge_width; }),
        made<T>("polarity", "grey level of the contact relative to the surroundings",
                [](const T& of) { return to_string(of.contact->polarity); })
            .one_of(Asked<answers::RadiusRequest>::polarities),
        made<T>("partial", "whether the contact reaches beyond the frame",
                [](const T& of) { return of.contact->partial; }),
        inner<&T::contact>(),
        inner<&T::pixel_size>(),
    };
    static constexpr Description description{"", "ellipse of a contact", rows};
};
static_assert(complete<answers::FrameEllipse>);

template <>
struct Described<answers::RadiusFrame> {
    using T = answers::RadiusFrame;
    static constexpr std::array<std::string_view, 5> states{"measured", "no contact", "not found", "bad frame",
                                                            "excluded"};
    static constexpr std::array rows{
        made<T>("frame", "number of the frame", [](const T& of) { return of.frame->number; }),
        made<T>("name", "name of the picture", [](const T& of) -> const std::string& { return of.frame->name; }),
        made<T>("time", "time of the frame", [](const T& of) { return of.frame->time; }).in_unit("s"),
        made<T>("state", "result of the frame", [](const T& of) { return to_string(of.frame->contact.state); })
            .one_of(states),
        made<T>("remark", "reason for which there is no radius, or a warning; may be empty",
                [](const T& of) -> const std::string& { return of.frame->contact.reason; }),
        made<T>("contact_radius", "contact radius a",
                [](const T& of) {
                    return answers::MeasuredInPicture{"contact radius", "a", of.frame->radius, "m",
                                                      of.frame->standard_error};
                })
            .in_unit("m"),
        fields_of<T>([](const T& of) -> std::optional<answers::FrameEllipse> {
            if (of.frame->contact.state != imaging::FrameState::measured) return std::nullopt;
            return answers::FrameEllipse{&of.frame->contact, of.pixel_size};
        }),
        inner<&T::frame>(),
        inner<&T::pixel_size>(),
    };
    static constexpr Description description{"", "frame of a recording", rows};
};
static_assert(complete<answers::RadiusFrame>);

template <>
struct Described<imaging::RadiusSummary> {
    using T = imaging::RadiusSummary;
    static constexpr std::array rows{
        field<&T::frames>("frames", "all frames"),
        field<&T::measured>("measured", "frames with a radius"),
        field<&T::no_contact>("no_contact", "frames without contact"),
        field<&T::not_found>("not_found", "frames in which no disc was found"),
        field<&T::bad>("bad", "frames that cannot be read"),
        field<&T::excluded>("excluded", "excluded frames"),
        field<&T::partial>("partial", "frames in which the contact reaches beyond the picture"),
        field<&T::missing>("missing", "missing frames"),
    };
    static constexpr Description description{"", "number of frames per result", rows};
};
static_assert(complete<imaging::RadiusSummary>);

template <>
struct Described<imaging::ContactRadii> {
    using T = imaging::ContactRadii;
    static constexpr std::array rows{
        value<&T::pixel_size>("pixel_size", "m", "size of a pixel"),
        value<&T::frame_rate>("frame_rate", "1/s", "frames per second"),
        made<T>("polarity", "grey level of the contact relative to the surroundings, in most frames",
                [](const T& of) { return to_string(of.polarity); })
            .one_of(Asked<answers::RadiusRequest>::polarities),
        field<&T::summary>("summary", "number of frames per result"),
        field<&T::notes>("notes", "further remarks"),
        made<T>("frames", "one entry per frame",
                [](const T& of) {
                    std::vector<answers::RadiusFrame> frames;
                    for (const auto& frame : of.frames) frames.push_back({&frame, of.pixel_size});
                    return frames;
                }),
        inner<&T::polarity>(),
        inner<&T::frames>(),
    };
    static constexpr Description description{"", "contact radii in a recording", rows};
};
static_assert(complete<imaging::ContactRadii>);

}  // namespace setae::fields
