// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Output of `setae jkr line`.

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "setae/answers/contact_line.hpp"
#include "setae/answers/line_comparison.hpp"
#include "setae/fields/describe.hpp"

namespace setae::answers {

/// The tail of the distribution of speeds.
struct SpeedTail {
    const contact_line::PowerLawTail* tail;
};
/// The tail of the distribution of the areas of jumps.
struct JumpTail {
    const contact_line::PowerLawTail* tail;
};

/// Connected cells, one list per property.
struct Clusters {
    const std::vector<contact_line::Cluster>* list;

    [[nodiscard]] Array1D all(double contact_line::Cluster::*property) const {
        Array1D values(std::ssize(*list));
        for (Index i = 0; i < values.size(); ++i) values[i] = (*list)[static_cast<std::size_t>(i)].*property;
        return values;
    }
};

/// The energy release rates before and after the widest contact.
struct ReleaseRates {
    const std::optional<ReleaseRate>*advancing, *receding;
};

/// An edge and its comparison with a second edge.
struct ComparedLine {
    const LineAnswer* answer;
    const LineComparison* comparison;
};

}  // namespace setae::answers

namespace setae::fields {

template <>
struct Described<contact_line::LineRoughness> {
    using T = contact_line::LineRoughness;
    static constexpr std::array rows{
        quantity<&T::exponent>("exponent", "zeta", "1", "roughness exponent ζ").as("roughness exponent of the edge"),
        value<&T::amplitude>("amplitude", "m2", "amplitude A of <|r_n|²> = A n^−(1 + 2ζ)"),
        made<T>("modes", "first and last mode that were fitted",
                [](const T& of) {
                    return std::array{of.smallest_mode, of.largest_mode};
                }),
        field<&T::power>("power", "power <|r_n|²> of each mode").in_unit("m2"),
        field<&T::structure>("structure", "structure function of the edge").in_unit("m"),
        inner<&T::mode>(),
        inner<&T::lag>(),
        inner<&T::smallest_mode>(),
        inner<&T::largest_mode>(),
    };
    static constexpr Description description{"", "roughness of the edge", rows};
};
static_assert(complete<contact_line::LineRoughness>);

template <>
struct Described<answers::SpeedTail> {
    using T = answers::SpeedTail;
    using Tail = contact_line::PowerLawTail;
    static constexpr std::array size_and_fit_rows{
        field<&Tail::count>("count", "number of values in the tail"),
        field<&Tail::distance>("distance", "Kolmogorov distance between power law and data"),
    };
    static constexpr Description size_and_fit{"", "size and fit of a tail", size_and_fit_rows};
    static constexpr std::array rows{
        made<T>("exponent", "eta", "1", "exponent of the power law", [](const T& of) { return of.tail->exponent; })
            .as("exponent of the speeds' tail"),
        made_value<T>("smallest", "1", "smallest speed, divided by the mean, to which the power law applies",
                      [](const T& of) { return of.tail->smallest; }),
        fields_of<T>(size_and_fit, [](const T& of) -> const Tail& { return *of.tail; }),
        inner<&T::tail>(),
    };
    static constexpr Description description{"", "power law of large speeds", rows};
};
static_assert(complete<answers::SpeedTail>);

template <>
struct Described<answers::JumpTail> {
    using T = answers::JumpTail;
    static constexpr std::array rows{
        made<T>("exponent", "tau", "1", "exponent of the power law", [](const T& of) { return of.tail->exponent; })
            .as("exponent of the jumps' areas"),
        made_value<T>("smallest", "m2", "smallest area to which the power law applies",
                      [](const T& of) { return of.tail->smallest; }),
        fields_of<T>(Described<answers::SpeedTail>::size_and_fit,
                     [](const T& of) -> const contact_line::PowerLawTail& { return *of.tail; }),
        inner<&T::tail>(),
    };
    static constexpr Description description{"", "power law of large jumps", rows};
};
static_assert(complete<answers::JumpTail>);

template <>
struct Described<answers::Clusters> {
    using T = answers::Clusters;
    using Cluster = contact_line::Cluster;
    static constexpr std::array rows{
        made<T>("count", "number of groups", [](const T& of) { return of.list->size(); }),
        made<T>("area", "area of each group", [](const T& of) { return of.all(&Cluster::area); }).in_unit("m2"),
        made<T>("along", "extent along the edge", [](const T& of) { return of.all(&Cluster::along); }).in_unit("m"),
        made<T>("across", "extent along the radius", [](const T& of) { return of.all(&Cluster::across); })
            .in_unit("m"),
        made<T>("angle", "angle of the middle", [](const T& of) { return of.all(&Cluster::angle); }).in_unit("rad"),
        made<T>("radius", "radius of the middle", [](const T& of) { return of.all(&Cluster::radius); })
            .in_unit("m"),
        inner<&T::list>(),
    };
    static constexpr Description description{"clusters", "connected cells, the largest group first", rows};
};
static_assert(complete<answers::Clusters>);

template <>
struct Described<answers::LineMotion> {
    using T = answers::LineMotion;
    template <class Tail>
    static std::optional<Tail> tail_of(const std::optional<contact_line::PowerLawTail>& tail) {
        if (!tail) return std::nullopt;
        return Tail{&*tail};
    }
    static constexpr std::array rows{
        made_value<T>("mean_speed", "m/s", "mean speed, distance divided by time",
                      [](const T& of) { return of.passage.mean_speed; }),
        made_value<T>("ring_width", "m", "width of the rings of cells in which speeds are determined",
                      [](const T& of) { return of.passage.width; }),
        made<T>("speed_tail", "power law of large speeds; null for too few values",
                [](const T& of) { return tail_of<answers::SpeedTail>(of.speed_tail); })
            .or_null(),
        made<T>("jump_tail", "power law of large jumps; null for too few values",
                [](const T& of) { return tail_of<answers::JumpTail>(of.jump_tail); })
            .or_null(),
        made<T>("jumps", "connected cells that are faster than the threshold",
                [](const T& of) { return answers::Clusters{&of.jumps}; }),
        made<T>("arrests", "connected cells that are slower than the threshold",
                [](const T& of) { return answers::Clusters{&of.arrests}; }),
        inner<&T::passage>(),
        inner<&T::jumps>(),
        inner<&T::arrests>(),
        inner<&T::speed_tail>(),
        inner<&T::jump_tail>(),
    };
    static constexpr Description description{"motion", "motion of the edge in one direction", rows};
};
static_assert(complete<answers::LineMotion>);

template <>
struct Described<answers::ReleaseRate> {
    using T = answers::ReleaseRate;
    static constexpr std::array rows{
        field<&T::frames>("frames", "number of frames"),
        value<&T::mean>("mean", "J/m2", "mean over frames and angles of the energy release rate"),
        value<&T::scatter>("scatter", "J/m2",
                           "square root of the mean variance along the edge, minus the contribution of noise"),
        value<&T::noise>("noise", "J/m2", "contribution of the noise of positions, which is subtracted"),
        made<T>("energy_share", "U_el/(A W) of roughness that causes this scatter, (scatter/mean)²/4",
                [](const T& of) { return of.energy_share(); }),
    };
    static constexpr Description description{"release_rate", "energy release rate along the edge", rows};
};
static_assert(complete<answers::ReleaseRate>);

template <>
struct Described<answers::ReleaseRates> {
    using T = answers::ReleaseRates;
    static constexpr std::array rows{
        made<T>("advancing", "before the widest contact; null without frames",
                [](const T& of) { return *of.advancing; })
            .or_null(),
        made<T>("receding", "after the widest contact; null without frames", [](const T& of) { return *of.receding; })
            .or_null(),
        inner<&T::advancing>(),
        inner<&T::receding>(),
    };
    static constexpr Description description{"", "energy release rates before and after the widest contact", rows};
};
static_assert(complete<answers::ReleaseRates>);

template <>
struct Described<answers::LineAnswer> {
    using T = answers::LineAnswer;
    static constexpr std::array rows{
        made<T>("frames", "numbers of the frames", [](const T& of) -> const auto& { return of.recorded.frames; }),
        made<T>("angles", "number of places along the edge", [](const T& of) { return of.recorded.line.angles(); }),
        made_value<T>("place_error", "m", "standard error of a position",
                      [](const T& of) { return of.recorded.line.place_error; }),
        field<&T::roughness>("roughness", "roughness of the edge; null where it cannot be determined").or_null(),
        field<&T::advancing>("advancing", "motion outwards; null without such motion").or_null(),
        field<&T::receding>("receding", "motion inwards; null without such motion").or_null(),
        made<T>("release_rate", "energy release rate along the edge, if sphere and displacement are given",
                [](const T& of) -> std::optional<answers::ReleaseRates> {
                    if (!of.advancing_rate && !of.retracting_rate) return std::nullopt;
                    return answers::ReleaseRates{&of.advancing_rate, &of.retracting_rate};
                }),
        made_value<T>("time", "s", "time of each frame",
                      [](const T& of) -> const Array1D& { return of.recorded.line.time; }),
        made_value<T>("mean_radius", "m", "mean radius of the edge in each frame",
                      [](const T& of) -> const Array1D& { return of.shape.mean_radius; }),
        made_value<T>("area", "m2", "area within the edge",
                      [](const T& of) -> const Array1D& { return of.shape.area; }),
        made_value<T>("perimeter", "m", "length of the edge",
                      [](const T& of) -> const Array1D& { return of.shape.perimeter; }),
        made_value<T>("deviation", "m", "rms deviation of the edge from an ellipse",
                      [](const T& of) -> const Array1D& { return of.shape.deviation; }),
        made_value<T>("voids", "1", "number of voids within the contact",
                      [](const T& of) { return void_counts(of.recorded); }),
        made_value<T>("void_area", "m2", "area of all voids", [](const T& of) { return void_areas(of.recorded); }),
        made<T>("left_out", "frames that were left out, with the reason",
                [](const T& of) -> const auto& { return of.recorded.left_out; }),
        field<&T::notes>("notes", "further remarks"),
        inner<&T::recorded>(),
        inner<&T::shape>(),
        inner<&T::advancing_rate>(),
        inner<&T::retracting_rate>(),
    };
    static constexpr Description description{"contact_edge", "edge of a contact", rows};
};
static_assert(complete<answers::LineAnswer>);

template <>
struct Described<answers::ComparedLine> {
    using T = answers::ComparedLine;
    static constexpr std::array rows{
        fields_of<T>([](const T& of) -> const answers::LineAnswer& { return *of.answer; }),
        made<T>("beside", "results of the second edge, which was given for comparison",
                [](const T& of) -> const answers::LineAnswer& { return of.comparison->other; }),
        made<T>("shared_frames", "frames of the first edge at times that the second edge has, too",
                [](const T& of) { return of.comparison->frames; }),
        made_value<T>("edge_difference", "m",
                      "rms difference of the radii at shared times, without the displacement of the centre; null "
                      "without shared times",
                      [](const T& of) { return of.comparison->difference; })
            .or_null(),
        inner<&T::answer>(),
        inner<&T::comparison>(),
    };
    static constexpr Description description{"", "edge of a contact in comparison with a second edge", rows};
};
static_assert(complete<answers::ComparedLine>);

}  // namespace setae::fields
