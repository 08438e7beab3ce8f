// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/errors.hpp"

namespace setae::loops {

/// A mistake in the columns of a record.
enum class ChannelFault {
    force_reversed,         ///< tension is positive
    displacement_reversed,  ///< the displacement falls as the bodies approach
    both_reversed,
    swapped,  ///< force and displacement changed places
};

/// "force_reversed", "displacement_reversed", "both_reversed", "swapped".
[[nodiscard]] std::string to_string(ChannelFault fault);

/// A record that makes sense with another sign, or with its columns exchanged, and with neither as it is.
class ChannelFaultError : public UndefinedDataError {
public:
    explicit ChannelFaultError(ChannelFault fault);
    /// The error with another message, such as one with the file and the remedy.
    ChannelFaultError(ChannelFault fault, const std::string& what) : UndefinedDataError(what), fault_(fault) {}
    [[nodiscard]] ChannelFault fault() const { return fault_; }

private:
    ChannelFault fault_;
};

}  // namespace setae::loops
