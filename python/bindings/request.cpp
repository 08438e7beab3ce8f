// SPDX-License-Identifier: GPL-3.0-or-later
#include "request.hpp"

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::python {
namespace {

/// Runs a check. @throws InvalidArgument that begins with the name of the argument.
template <class Check>
void check_of(std::string_view argument, Check&& check) {
    try {
        check();
    } catch (const InvalidArgument& error) {
        throw InvalidArgument(fmt::format("{}: {}", argument, error.what()));
    }
}

}  // namespace

void require_valid_text(const fields::Option& option, std::string_view argument, const std::string& text) {
    if (text.empty()) return;  // not given
    check_of(argument, [&] {
        if (option.quantity) (void)parse_uncertain_quantity(text, *option.quantity);
        if (option.check) option.check(text);
    });
}

void require_valid_number(const fields::Option& option, std::string_view argument, double value) {
    check_of(argument, [&] {
        if (option.domain) require_within(*option.domain, value, fmt::format("{}", value));
        if (option.whole && !(value >= option.whole->least && value <= option.whole->greatest))
            throw InvalidArgument(fmt::format("'{}', expected a whole number from {} to {}", value, option.whole->least,
                                              option.whole->greatest));
    });
}

}  // namespace setae::python
