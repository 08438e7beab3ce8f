// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "setae/answers/contact_radii.hpp"
#include "setae/contact_line/line_motion.hpp"
#include "setae/contact_line/line_roughness.hpp"
#include "setae/core/table.hpp"
#include "setae/fields/option.hpp"
#include "setae/imaging/contact_outline.hpp"

namespace setae::answers {

/// Request of `setae jkr line`: analysis of the edge of a contact.
struct LineRequest : RadiusRequest {
    std::optional<long> angles;
    double smallest_void = 16.0;  ///< [px²]
    std::string ring_width;
    double threshold = 3.0;
    long smallest_mode = 3, largest_mode = 0;
    std::string sphere_radius, contact_modulus;  ///< for the release rate, which needs both
    std::string displacement;

    [[nodiscard]] imaging::LineOptions line_options(parallel::Threads threads = {}) const;
};

/// Motion of the edge in one direction.
struct LineMotion {
    contact_line::Passage passage;
    std::vector<contact_line::Cluster> jumps, arrests;                ///< largest first
    std::optional<contact_line::PowerLawTail> speed_tail, jump_tail;  ///< tails of v/⟨v⟩ and of areas
};

/// Energy release rate at the edge on approach or retraction: contact_line::local_release_rate() of the frames before
/// or after the widest contact.
struct ReleaseRate {
    Index frames = 0;
    double mean = 0.0;     ///< over frames and angles [J/m²]
    double scatter = 0.0;  ///< square root of the mean variance along the edge, minus the contribution of noise [J/m²]
    double noise = 0.0;    ///< that [J/m²]

    /// U_el/AW of roughness that makes such a scatter, (scatter/mean)²/4: std(w_R)/w = 2√(U_el/AW).
    [[nodiscard]] double energy_share() const { return 0.25 * (scatter / mean) * (scatter / mean); }
};

/// The edge in all frames of a recording that show it whole, or of a table.
struct RecordedLine {
    std::vector<long> frames;                              ///< numbers of the frames, one per row of the line
    contact_line::ContactLine line;                        ///< [s], [m]; its error is of pixel noise
    double pixel_size = 0;                                 ///< [m]
    double centre_x = 0, centre_y = 0;                     ///< [px] of the whole frame: the mean of the frames'
    std::vector<std::vector<imaging::ContactVoid>> voids;  ///< voids of every frame
    std::vector<std::string> left_out;                     ///< frames that are left out, each with its reason
};

/// All that is found of an edge. No roughness, or no motion in either direction, has its reason in `notes`; a tail of
/// too few numbers is left out.
struct LineAnswer {
    RecordedLine recorded;  ///< edge of a table: without voids
    contact_line::LineShape shape;
    std::optional<contact_line::LineRoughness> roughness;
    std::optional<LineMotion> advancing, receding;
    std::optional<ReleaseRate> advancing_rate, retracting_rate;
    std::vector<std::string> notes;
};

/// An edge that was simulated or measured before: a table of contact_line::as_table().
/// @throws as contact_line::line_of.
[[nodiscard]] RecordedLine recorded_line(const Table& table);

/// An edge, and the radii from whose centres its rays go out; a table has none.
struct RecordedEdge {
    RecordedLine line;
    std::optional<imaging::ContactRadii> radii;
    std::optional<Array1D> displacement;  ///< at the line's times [m], where a table has it
};

/// The edge from pictures, or from one table that recorded_line() reads, "….csv". @throws as reading them does.
[[nodiscard]] RecordedEdge recorded_edge(const std::vector<std::string>& files, const LineRequest& request,
                                         parallel::Threads threads = {});

/// A table of contact_line::as_table() as CSV below "# place_error: …", which recorded_line() reads.
[[nodiscard]] std::string edge_csv(const Table& table);
/// The same of a recording.
[[nodiscard]] std::string line_csv(const RecordedLine& recorded);

/// @throws InvalidArgument for a band of modes or a threshold outside their domain, and for a release rate without
/// sphere, modulus or displacements.
[[nodiscard]] LineAnswer contact_line_answer(RecordedEdge recorded, const LineRequest& request);

/// Areas of clusters [m²].
[[nodiscard]] Array1D areas_of(const std::vector<contact_line::Cluster>& clusters);

/// One row per frame: time, frame, mean_radius, area, perimeter, deviation, voids, void_area.
[[nodiscard]] Table as_table(const LineAnswer& answer);
/// Number of voids in each frame, and their area [m²].
[[nodiscard]] Array1D void_counts(const RecordedLine& recorded);
[[nodiscard]] Array1D void_areas(const RecordedLine& recorded);

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::LineRequest> {
    using R = answers::LineRequest;
    static constexpr std::array options{
        option<&R::angles>("angles", "number of places along the edge")
            .or_else("one every 2 px of the largest contact")
            .advanced(),
        option<&R::smallest_void>("smallest_void", "smallest area of a reported void, in px^2")
            .within(domain::positive)
            .default_shown()
            .advanced(),
        option<&R::ring_width>("ring_width", "width of the rings whose cells have a speed each")
            .of(positive(dimension::length))
            .such_as("5 um")
            .or_else("the step of the edge from frame to frame")
            .advanced(),
        option<&R::threshold>("threshold",
                              "factor by which a jump is faster, and an arrest slower, than the mean speed")
            .default_shown()
            .advanced(),
        option<&R::smallest_mode>("smallest_mode",
                                  "smallest mode of the edge's roughness; mode 1 is the centre, mode 2 an ellipse")
            .default_shown()
            .advanced(),
        option<&R::largest_mode>("largest_mode", "largest mode of the edge's roughness")
            .or_else("a quarter of the places")
            .advanced(),
        option<&R::sphere_radius>("radius", "radius of the sphere, for the energy release rate")
            .of(positive(dimension::length))
            .such_as("1 mm"),
        option<&R::contact_modulus>("contact_modulus", "contact modulus E* of both bodies, for the energy release rate")
            .of(positive(dimension::pressure))
            .such_as("1 MPa"),
        option<&R::displacement>("displacement",
                                 "table of time and displacement of the sphere, for the energy release rate")
            .or_else("the displacement in the table of the edge")
            .of_input(),
    };
};
