// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "setae/study/study_result.hpp"

namespace setae::output {

/// Effect of kinds of warnings on a conclusion.
struct Bearing {
    std::vector<std::string_view> codes;  ///< kinds with the same consequence
    const char* sentence;                 ///< {} is replaced by the items concerned
};

/// Effects of every kind of warning that limits a conclusion, those with the largest effect first. Other kinds report
/// processing or properties of a file, or have a sentence of their own in Verdict::limits: failures, reconstructions,
/// Eq. 7 below 0.
[[nodiscard]] const std::vector<Bearing>& bearings();

/// Item that a warning concerns.
struct Subject {
    std::string name;     ///< the measurement or loop where it is one's, else the surface, pair or elastomer
    std::string surface;  ///< surface of a measurement; else empty
};

/// Determines the items that warnings of a result concern. The result outlives it. Cost: for each warning the logarithm
/// of their number.
class Subjects {
public:
    explicit Subjects(const study::StudyResult& result);
    [[nodiscard]] Subject of(const Alert& alert) const;

private:
    using Key = std::tuple<std::string_view, std::string_view, std::string_view, std::string_view>;

    static Key key_of(const Alert& alert) { return {alert.code, alert.subject, alert.message, alert.action}; }

    std::map<Key, Subject> subjects_;
};

/// Names once each, in order; of more than three measurements those of their surfaces.
[[nodiscard]] std::vector<std::string> names_of(const std::vector<Subject>& subjects);

}  // namespace setae::output
