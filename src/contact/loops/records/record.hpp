// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "force_minimum.hpp"
#include "setae/loops/segments.hpp"

namespace setae::loops {

/// A loop with its force relative to its zero, and the thresholds between features and noise.
struct Record {
    const Loop& loop;
    Array1D level;            ///< force [N], zero and drift subtracted
    Array1D force;            ///< the same, averaged over neighbours where it is noisy [N]
    SampleNoise noise;        ///< of `level`
    double range = 0.0;       ///< largest minus smallest force [N]
    double feature = 0.0;     ///< a force further from zero is no noise [N]
    double free_level = 0.0;  ///< a force within is that of free flight [N]
    double turning = 0.0;     ///< a reversal of less is no reversal [N]

    [[nodiscard]] Index size() const { return force.size(); }
    [[nodiscard]] bool has_radius() const { return loop.contact_radius.size() > 0; }
    [[nodiscard]] bool has_displacement() const { return loop.displacement.size() > 0; }
    /// Out of contact: a = 0 where the radius is known, else a force of free flight.
    [[nodiscard]] bool is_free(Index sample) const;
    /// Quantity that reverses together with the force in a true release: displacement, else contact radius.
    [[nodiscard]] double position(Index sample) const;
};

/// @throws InvalidArgument for series of different length, an undefined force or displacement, or a short record.
void require_valid(const Loop& loop);

/// level: the force with its zero subtracted. segments: the baselines. @throws UndefinedDataError for a force that is
/// constant or never exceeds its noise.
[[nodiscard]] Record make_record(const Loop& loop, const Array1D& level, const Segments& segments,
                                 const SegmentOptions& options);

}  // namespace setae::loops
