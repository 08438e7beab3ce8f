// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "setae/contact_line/contact_line.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/extent.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/transform.hpp"

namespace setae::contact_line {

ContactLine at_fewer_angles(const ContactLine& line, Index angles) {
    require_valid(line);
    if (angles < 16 || angles > line.angles())
        throw InvalidArgument(
            fmt::format("an edge of {} places at {} angles; expected 16 to {}", line.angles(), angles, line.angles()));
    const fourier::RealTransform forward(line.angles());
    const fourier::InverseRealTransform back(angles);
    fourier::Buffer<double> radii(extent(line.angles()));
    fourier::Buffer<fourier::Complex> modes(extent(forward.modes()));
    ContactLine result{.time = line.time, .radius = Array2D(line.frames(), angles), .place_error = line.place_error};
    for (Index i = 0; i < line.frames(); ++i) {
        std::copy_n(line.radius.data() + i * line.angles(), line.angles(), radii.begin());
        forward.forward(radii.data(), modes.data());
        if (angles % 2 == 0 && angles < line.angles()) modes[extent(angles / 2)] = 0.0;  // neither sine nor cosine only
        back.apply(modes.data(), radii.data());
        for (Index j = 0; j < angles; ++j) result.radius(i, j) = radii[extent(j)] / static_cast<double>(line.angles());
    }
    return result;
}

ContactLine at_times(const ContactLine& line, const ArrayView1D& times) {
    require_valid(line);
    const Index last = line.frames() - 1;
    ContactLine result{.time = times, .radius = Array2D(times.size(), line.angles()), .place_error = line.place_error};
    for (Index i = 0; i < times.size(); ++i) {
        if (!(times[i] >= line.time[0] && times[i] <= line.time[last]))
            throw InvalidArgument(fmt::format("a time of {} s outside an edge recorded from {} to {} s", times[i],
                                              line.time[0], line.time[last]));
        const Index after =
            std::clamp<Index>(std::upper_bound(line.time.begin(), line.time.end(), times[i]) - line.time.begin(),
                              std::min<Index>(1, last), last);
        const Index before = std::max<Index>(0, after - 1);
        const double share =
            after > before ? (times[i] - line.time[before]) / (line.time[after] - line.time[before]) : 0.0;
        result.radius.row(i) = (1.0 - share) * line.radius.row(before) + share * line.radius.row(after);
    }
    return result;
}

}  // namespace setae::contact_line
