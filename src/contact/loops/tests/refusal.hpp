// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::loops::tests {

/// The message of what a function refuses, empty where it does not.
template <class Exception, class Function>
std::string refusal_of(const Function& function) {
    try {
        function();
    } catch (const Exception& error) {
        return error.what();
    }
    return "";
}

}  // namespace setae::loops::tests
