// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/calibration.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "drawn_bars.hpp"
#include "found_bars.hpp"
#include "setae/core/display_unit.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::imaging {
namespace {

constexpr double agreement_of_sizes = 0.01;
constexpr double equally_good = 0.1;  // of confidence
constexpr const char* ways_out =
    "give `pixel`, such as \"0.05 nm\", or the length of the scale bar in `scale_bar`, such as \"5 "
    "nm\"";

/// A known pixel size, as text for messages.
struct KnownSize {
    PixelSize size;
    double relative_standard_error = 0;
    bool of_bar = false;
    std::string source, words;
};

std::string in_words(double length) {
    const auto unit = display_unit(length * (1 + 1e-12), "m");
    return fmt::format("{:g} {}", length / unit.factor, unit.name);
}

std::string in_words(const PixelSize& size) {
    if (size.x == size.y) return format_value(size.x, "m");
    return fmt::format("{} × {}", format_value(size.x, "m"), format_value(size.y, "m"));
}

void require_positive(const PixelSize& size, const std::string& where, const char* what) {
    if (!(size.x > 0 && size.y > 0 && std::isfinite(size.x) && std::isfinite(size.y)))
        throw InvalidArgument(
            fmt::format("{}{} {:g} × {:g} m, expected positive numbers", where, what, size.x, size.y));
}

KnownSize size_by(const ScaleBar& bar, double length, const char* how) {
    const double size = length / bar.length;
    const auto source = fmt::format("scale bar {} = {:.1f} px", in_words(length), bar.length);
    return {{size, size},
            bar.length_standard_error / bar.length,
            true,
            source,
            fmt::format("the scale bar of {:.1f} px, {} {},", bar.length, how, in_words(length))};
}

/// Whether two sizes differ by more than the error of the bar; bars are along x.
bool contradict(const KnownSize& first, const KnownSize& second) {
    const double allowed =
        std::max(agreement_of_sizes, 3 * std::hypot(first.relative_standard_error, second.relative_standard_error));
    const bool x = std::abs(first.size.x / second.size.x - 1) > allowed,
               y = std::abs(first.size.y / second.size.y - 1) > allowed;
    return x || (y && !first.of_bar && !second.of_bar);
}

/// Another equally good bar with another size, as text; empty without one.
std::string ambiguity(const std::vector<FoundBar>& found, const std::optional<double>& given) {
    if (found.empty()) return {};
    const auto& best = found.front().bar;
    for (std::size_t k = 1; k < found.size(); ++k) {
        const auto& other = found[k].bar;
        if (other.confidence < best.confidence - equally_good) continue;
        double ratio = other.length / best.length;  // of the pixel sizes, if both are one length
        if (!given && best.labelled_length && other.labelled_length)
            ratio /= *other.labelled_length / *best.labelled_length;
        const double error =
            std::hypot(best.length_standard_error / best.length, other.length_standard_error / other.length);
        if (std::abs(ratio - 1) <= std::max(agreement_of_sizes, 3 * error)) continue;
        return fmt::format(
            "two scale bars are equally good, of {:.1f} px at x {:.0f}, y {:.0f} and of {:.1f} px at x "
            "{:.0f}, y {:.0f}; the first was used",
            best.length, best.begin_x, best.y, other.length, other.begin_x, other.y);
    }
    return {};
}

class Decision {
public:
    Decision(const Micrograph& micrograph, const CalibrationOptions& options)
        : micrograph_(micrograph), options_(options), where_(micrograph.file.empty() ? "" : micrograph.file + ": ") {
        if (options.pixel_size) require_positive(*options.pixel_size, where_, "pixel size");
        if (options.scale_bar_length)
            require_positive({*options.scale_bar_length, *options.scale_bar_length}, where_, "length of the scale bar");
        if (micrograph.pixel_size) require_positive(*micrograph.pixel_size, where_, "the file states a pixel size of");
        found_ = found_bars(scaled_levels(micrograph.pixels));
        if (options.scale_bar_length && found_.empty())
            throw InvalidArgument(
                fmt::format("{}no scale bar is found, although its length {} was given; give the pixel size instead in "
                            "`pixel`, such as \"0.05 nm\"",
                            where_, in_words(*options.scale_bar_length)));
    }

    [[nodiscard]] Calibration made() {
        collect();
        compare();
        if (known_.empty()) refuse();
        const auto& chosen = known_.front();
        Calibration calibration{.pixel_size = chosen.size,
                                .relative_standard_error = chosen.relative_standard_error,
                                .source = chosen.source,
                                .scale_bar = bar()};
        if (known_.size() == 1 && chosen.of_bar && !options_.scale_bar_length)
            alert("SCALE_BAR_UNCONFIRMED",
                  fmt::format("the label of the scale bar was read as '{}' ({:.1f} px); nothing else confirms it",
                              bar()->label, bar()->length),
                  fmt::format("look at the picture and confirm the length in `scale_bar`: \"{}\"", bar()->label));
        if (const auto words = ambiguity(found_, options_.scale_bar_length); !words.empty())
            alert("SCALE_BAR_AMBIGUOUS", words, "give the pixel size in `pixel`, such as \"0.05 nm\"");
        calibration.alerts = std::move(alerts_);
        return calibration;
    }

private:
    [[nodiscard]] std::optional<ScaleBar> bar() const {
        return found_.empty() ? std::nullopt : std::optional(found_.front().bar);
    }

    void alert(const char* code, const std::string& message, const std::string& action) {
        alerts_.push_back({code, micrograph_.name, message, action});
    }

    /// Sizes in order of priority.
    void collect() {
        if (options_.pixel_size) known_.push_back({*options_.pixel_size, 0, false, "given", "the given value"});
        std::vector<KnownSize> stated;
        if (micrograph_.pixel_size)
            stated.push_back({*micrograph_.pixel_size, 0, false, "file: " + micrograph_.pixel_size_source, "the file"});
        if (!options_.ignore_stated_pixel_size) known_.insert(known_.end(), stated.begin(), stated.end());
        if (const auto found = bar()) {
            if (options_.scale_bar_length) known_.push_back(size_by(*found, *options_.scale_bar_length, "given as"));
            if (found->labelled_length) known_.push_back(size_by(*found, *found->labelled_length, "read as"));
        }
        if (options_.ignore_stated_pixel_size) known_.insert(known_.end(), stated.begin(), stated.end());
    }

    void compare() {
        for (std::size_t i = 0; i < known_.size(); ++i)
            for (std::size_t k = i + 1; k < known_.size(); ++k) {
                const auto &first = known_[i], &second = known_[k];
                // two lengths of one bar differ exactly or are equal
                const bool same_bar = first.of_bar && second.of_bar;
                if (same_bar ? std::abs(first.size.x / second.size.x - 1) <= 1e-6 : !contradict(first, second))
                    continue;
                const auto message = fmt::format("{} gives {} per pixel, {} {}", first.words, in_words(first.size),
                                                 second.words, in_words(second.size));
                if (!options_.ignore_stated_pixel_size)
                    throw InvalidArgument(fmt::format(
                        "{}{}; correct the wrong one, or set `ignore_stated_pixel_size` to use the first of the given "
                        "value and the scale bar",
                        where_, message));
                alert(first.of_bar || second.of_bar ? "SCALE_BAR_DISAGREES" : "PIXEL_SIZE_DISAGREES",
                      message + "; the first was used", "compare the picture with the pixel size that the file states");
            }
    }

    [[noreturn]] void refuse() const {
        if (found_.empty())
            throw InvalidArgument(
                fmt::format("{}no pixel size: the file states none, and no scale bar was found; {}", where_, ways_out));
        const auto& best = found_.front();
        throw InvalidArgument(
            fmt::format("{}no pixel size: the file states none, and the label of the scale bar of {:.1f} px at x "
                        "{:.0f}, y {:.0f} gives none ({}); {}",
                        where_, best.bar.length, best.bar.begin_x, best.bar.y, best.label_fault, ways_out));
    }

    const Micrograph& micrograph_;
    const CalibrationOptions& options_;
    std::string where_;
    std::vector<FoundBar> found_;
    std::vector<KnownSize> known_;
    std::vector<Alert> alerts_;
};

}  // namespace

Calibration calibrate(const Micrograph& micrograph, const CalibrationOptions& options) {
    return Decision(micrograph, options).made();
}

void check_same_magnification(const Calibration& calibration, const Micrograph& micrograph) {
    const KnownSize kept{calibration.pixel_size, calibration.relative_standard_error,
                         calibration.scale_bar.has_value() && calibration.relative_standard_error > 0,
                         calibration.source, "the calibration"};
    std::vector<KnownSize> own;
    if (micrograph.pixel_size) own.push_back({*micrograph.pixel_size, 0, false, "", "the file"});
    if (const auto bars = find_scale_bars(micrograph.pixels); !bars.empty() && bars.front().labelled_length)
        own.push_back(size_by(bars.front(), *bars.front().labelled_length, "read as"));
    for (const auto& other : own)
        if (contradict(kept, other))
            throw InvalidArgument(
                fmt::format("{}{}{} gives {} per pixel, the calibration ({}) {}; calibrate pictures of another "
                            "magnification separately",
                            micrograph.file, micrograph.file.empty() ? "" : ": ", other.words, in_words(other.size),
                            calibration.source, in_words(calibration.pixel_size)));
}

}  // namespace setae::imaging
