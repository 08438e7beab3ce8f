// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "setae/contact_line/contact_line.hpp"
#include "setae/fields/describe.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::simulation {

/// Recording of a contact by a camera.
struct RecordingOptions {
    double pixel_size = 0.0;                ///< [m], > 0
    double frame_rate = 10.0;               ///< [1/s], > 0
    double inside = 80.0, contrast = 60.0;  ///< grey level of the contact, and of the outside minus that level
    double blur = 0.8;                      ///< standard deviation of the edge's profile [px], > 0
    double noise = 3.0;                     ///< standard deviation of a pixel [levels], white
    std::uint64_t seed = 1;
    parallel::Threads threads;
};

struct RecordingShape {
    int frames = 0;
    long width = 0, height = 0;  ///< [px]
};

/// Writes a TIFF stack of the edge of a contact as recorded by a camera, with its pixel size and frame rate as ImageJ
/// states them.
///
///   I = inside + contrast/2 (1 + erf(d/(√2 blur))) + noise,  d = (ρ − r(θ, t)) r/√(r² + r'²)
///
/// ρ, θ: polar coordinates of the middle of a pixel about the centre, θ from x towards y, downwards; frames at the
/// first time of the edge and every 1/rate after it, with linear interpolation of the edge in time. Equal bytes for any
/// number of threads. @throws InvalidArgument for options outside their domain, an edge closer than 1 px to its centre
/// or pictures of more than 10⁷ pixels or 10⁵ frames; FileError where the file cannot be written.
RecordingShape write_recording(const std::string& path, const contact_line::ContactLine& edge,
                               const RecordingOptions& options);

/// Output of `setae lab recording`.
struct RecordingOutput {
    std::string file;
    RecordingShape shape;
    double pixel_size = 0.0;  ///< [m]
    double frame_rate = 0.0;  ///< [1/s]
};

}  // namespace setae::simulation

template <>
struct setae::fields::Described<setae::simulation::RecordingOutput> {
    using T = simulation::RecordingOutput;
    static constexpr std::array rows{
        field<&T::file>("file", "file of the TIFF stack"),
        made<T>("frames", "number of frames", [](const T& of) { return of.shape.frames; }),
        made<T>("size", "number of pixels of a frame along x and y",
                [](const T& of) {
                    return std::array{of.shape.width, of.shape.height};
                }),
        value<&T::pixel_size>("pixel_size", "m", "size of a pixel that the file states"),
        value<&T::frame_rate>("frame_rate", "1/s", "frame rate that the file states"),
        inner<&T::shape>(),
    };
    static constexpr Description description{"", "rendered recording of an edge by a camera", rows};
};
static_assert(setae::fields::complete<setae::simulation::RecordingOutput>);
