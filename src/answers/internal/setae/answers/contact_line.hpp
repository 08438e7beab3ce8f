// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/answers/contact_radii.hpp"
#include "setae/contact_line/line_motion.hpp"
#include "setae/contact_line/line_roughness.hpp"
#include "setae/core/table.hpp"
#include "setae/imaging/contact_outline.hpp"
#include "setae/output/json.hpp"

namespace setae::answers {

/// How the edge of a contact is analysed, as `setae jkr line` is told.
struct LineRequest : RadiusRequest {
    std::optional<long> angles;                ///< of pictures; default a ray every 2 px
    double smallest_void = 16.0;               ///< [px²]
    std::string ring_width;                    ///< "2 um"; empty: the program's choice
    double threshold = 3.0;                    ///< of jumps and arrests, against the mean speed
    long smallest_mode = 3, largest_mode = 0;  ///< of the roughness

    [[nodiscard]] imaging::LineOptions line_options(parallel::Threads threads = {}) const;
};

/// How the edge moves in one direction.
struct LineMotion {
    contact_line::Passage passage;
    std::vector<contact_line::Cluster> jumps, arrests;                ///< largest first
    std::optional<contact_line::PowerLawTail> speed_tail, jump_tail;  ///< of v/⟨v⟩; of areas
};

/// All that is found of an edge. No roughness, or no motion in either direction, has its reason in `notes`; a tail of
/// too few numbers is left out.
struct LineAnswer {
    imaging::RecordedLine recorded;  ///< of a table: without voids
    contact_line::LineShape shape;
    std::optional<contact_line::LineRoughness> roughness;
    std::optional<LineMotion> advancing, receding;
    std::vector<std::string> notes;
};

/// An edge that was simulated or measured before: a table of contact_line::as_table().
/// @throws as contact_line::line_of.
[[nodiscard]] imaging::RecordedLine recorded_line(const Table& table);

/// An edge, and the radii from whose centres its rays go out; a table has none.
struct RecordedEdge {
    imaging::RecordedLine line;
    std::optional<imaging::ContactRadii> radii;
};

/// Of pictures, or of one table that recorded_line() reads, "….csv". @throws as reading them does.
[[nodiscard]] RecordedEdge recorded_edge(const std::vector<std::string>& files, const LineRequest& request,
                                         parallel::Threads threads = {});

/// What recorded_line() reads: contact_line::as_table() as CSV below "# place_error: …".
[[nodiscard]] std::string line_csv(const imaging::RecordedLine& recorded);

/// @throws InvalidArgument for a band of modes or a threshold outside their domain.
[[nodiscard]] LineAnswer contact_line_answer(imaging::RecordedLine recorded, const LineRequest& request);

/// Areas of clusters [m²].
[[nodiscard]] Array1D areas_of(const std::vector<contact_line::Cluster>& clusters);

/// One row a frame: time, frame, mean_radius, area, perimeter, deviation, voids, void_area.
[[nodiscard]] Table as_table(const LineAnswer& answer);
[[nodiscard]] output::Json to_json(const LineAnswer& answer);

}  // namespace setae::answers
