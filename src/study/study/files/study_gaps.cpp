// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/study_gaps.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "believed.hpp"
#include "setae/bytes/toml_reader.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/formats/channel.hpp"
#include "setae/study/measurement_options.hpp"
#include "setae/study/open_loop.hpp"

namespace setae::study {
namespace {

namespace fs = std::filesystem;

/// A study's file as lines, with the positions of its tables.
class StudyLines {
public:
    explicit StudyLines(const std::string& path) : document_(bytes::parse_toml_file(path)) {
        const auto text = bytes::read_file(path);
        for (std::size_t at = 0; at < text.size();) {
            const auto end = std::min(text.find('\n', at), text.size());
            lines_.push_back(text.substr(at, end - at));
            at = end + 1;
        }
    }

    /// Line of a key in the n-th table of a list; of the list where there is none.
    [[nodiscard]] std::size_t in_list(const toml::node* list, std::size_t n, const char* key) const {
        const auto* tables = list != nullptr ? list->as_array() : nullptr;
        const auto* table = tables != nullptr && n < tables->size() ? tables->get(n)->as_table() : nullptr;
        const auto* node = table != nullptr ? table->get(key) : nullptr;
        return line_of(node != nullptr ? node : table != nullptr ? table : list);
    }
    [[nodiscard]] const toml::node* at(const std::string& first, const std::string& second = "",
                                       const std::string& third = "") const {
        const toml::node* node = document_.get(first);
        for (const auto* key : {&second, &third})
            if (!key->empty()) node = node != nullptr && node->is_table() ? node->as_table()->get(*key) : nullptr;
        return node;
    }
    [[nodiscard]] static std::size_t line_of(const toml::node* node) {
        return node == nullptr ? 1 : static_cast<std::size_t>(node->source().begin.line);
    }

    /// The first line below one, within its table, with a question for one of some keys; the line itself where there is
    /// none.
    [[nodiscard]] std::size_t asking(std::size_t line, const std::vector<std::string>& keys) const {
        for (auto i = line; i < lines_.size() && !heads_table(lines_[i]) && lines_[i].find('{') == std::string::npos;
             ++i)
            if (const auto asked = asked_in(lines_[i]); std::find(keys.begin(), keys.end(), asked) != keys.end())
                return i + 1;
        return line;
    }

    /// Questions of tables in comments.
    [[nodiscard]] std::vector<StudyGap> asked_in_comments() const {
        std::vector<StudyGap> gaps;
        std::string table;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            if (heads_table(lines_[i])) table = commented_table(lines_[i]);
            const auto asked = asked_in(lines_[i]);
            if (!asked.empty() && !table.empty())
                gaps.push_back({i + 1, table, fmt::format("no {} yet; the line is a comment", asked)});
        }
        return gaps;
    }

private:
    /// A line without the sign of a comment in front.
    static std::string_view content_of(const std::string& line) {
        auto text = trimmed(line);
        while (!text.empty() && text.front() == '#') text = trimmed(text.substr(1));
        return text;
    }
    static bool heads_table(const std::string& line) {
        const auto text = content_of(line);
        return text.starts_with('[') && text.find(']') != std::string_view::npos;
    }
    /// "[elastomers.soft]" where a table is in a comment; empty for an active one.
    static std::string commented_table(const std::string& line) {
        if (!trimmed(line).starts_with('#')) return "";
        const auto text = content_of(line);
        return std::string(trimmed(text.substr(0, text.find('#'))));
    }
    /// KEY of `# KEY = "?"`.
    static std::string asked_in(const std::string& line) {
        if (!trimmed(line).starts_with('#')) return "";
        const auto text = content_of(line);
        const auto equals = text.find('=');
        if (equals == std::string_view::npos ||
            text.substr(equals, text.find('#', equals) - equals).find("\"?\"") == std::string_view::npos)
            return "";
        return std::string(trimmed(text.substr(0, equals)));
    }

    toml::table document_;
    std::vector<std::string> lines_;
};

class Gaps {
public:
    explicit Gaps(const Study& study) : study_(study), lines_(study.path) {}

    std::vector<StudyGap> found() && {
        for (const auto& surface : study_.surfaces) look_at(surface);
        for (const auto& elastomer : study_.elastomers) look_at(elastomer);
        for (std::size_t i = 0; i < study_.experiments.size(); ++i)
            look_at(study_.experiments[i], lines_.in_list(lines_.at("experiments"), i, "file"));
        const auto asked = lines_.asked_in_comments();
        gaps_.insert(gaps_.end(), asked.begin(), asked.end());
        std::stable_sort(gaps_.begin(), gaps_.end(), [](const auto& a, const auto& b) { return a.line < b.line; });
        return std::move(gaps_);
    }

private:
    [[nodiscard]] std::string shown(const std::string& file) const {
        return fs::path(file).lexically_proximate(fs::path(study_.path).parent_path()).generic_string();
    }

    void add(std::size_t line, const std::string& item, std::string message) {
        gaps_.push_back({line, item, std::move(message)});
    }

    /// Files that cannot be opened. A reason that begins with the file is cut there.
    template <class Opening>
    void try_to_open(std::size_t line, const std::string& file, const Opening& opening) {
        try {
            opening();
        } catch (const std::exception& error) {
            auto reason = reason_of(error, file);
            if (reason.starts_with(file + ": ")) reason = reason.substr(file.size() + 2);
            add(line, shown(file), reason);
        }
    }

    void look_at(const SurfaceInput& surface) {
        const auto* table = lines_.at("surfaces", surface.name);
        const auto* list = lines_.at("surfaces", surface.name, "measurements");
        for (std::size_t i = 0; i < surface.measurements.size(); ++i)
            look_at(surface.measurements[i], lines_.in_list(list, i, "file"));
        if (!surface.power_spectrum) return;
        const auto* key = lines_.at("surfaces", surface.name, "power_spectrum");
        const auto line = StudyLines::line_of(key != nullptr ? key : table);
        try_to_open(line, *surface.power_spectrum, [&] {
            const auto spectrum = tables::read_power_spectrum_table(*surface.power_spectrum, surface.spectrum_units);
            if (spectrum.metadata.contains("units"))
                add(line, shown(*surface.power_spectrum),
                    "the table states no units: q [1/m] and C1D [m3] are assumed; state them in power_spectrum_unit");
            if (spectrum.find("standard_error") == nullptr)
                add(line, shown(*surface.power_spectrum), "no standard errors: the ± of all results leave them out");
        });
    }

    void look_at(const MeasurementInput& input, std::size_t line) {
        try_to_open(line, input.file, [&] {
            for (const auto& channel : formats::open_chosen(input.file, input.channel, read_options(input)))
                look_at(input, channel.info, line);
        });
        auto files = input.references;
        if (input.tip_file) files.push_back(*input.tip_file);
        for (const auto& file : files) try_to_open(line, file, [&] { (void)bytes::file_source(file); });
    }

    void look_at(const MeasurementInput& input, const formats::ChannelInfo& info, std::size_t line) {
        const bool member = info.metadata.attributes.contains("member");
        const auto item = shown(input.file) + (member ? fmt::format(" ({})", info.name) : "");
        if (info.unit.empty())
            add(lines_.asking(line, {"unit"}), item, "no unit of heights, without which the file cannot be read");
        if (info.size.empty())
            add(lines_.asking(line, {"size"}), item, "no size, without which the file cannot be read");
        const auto& stated = info.metadata.instrument;
        const bool probe = input.tip_radius || input.tip_file || input.resolution || input.numerical_aperture ||
                           input.foil_thickness || stated.tip_radius || stated.resolution ||
                           info.metadata.attributes.contains("foil_thickness");
        if (probe) return;
        const auto type = input.instrument.empty() ? stated.type : input.instrument;
        const auto believed = resolution_without_probe(info);
        if (type.empty()) add(lines_.asking(line, {"instrument", "tip_radius"}), item, "no instrument: " + believed);
        else if (type == "afm" || type == "stylus")
            add(lines_.asking(line, {"tip_radius"}), item, fmt::format("no tip_radius of the {}: {}", type, believed));
        else if (type == "optical")
            add(lines_.asking(line, {"resolution", "numerical_aperture"}), item,
                "neither resolution nor numerical_aperture and light_wavelength: " + believed);
    }

    void look_at(const ElastomerInput& elastomer) {
        if (elastomer.youngs_modulus.value > 0.0) return;
        const bool loops = std::any_of(study_.experiments.begin(), study_.experiments.end(),
                                       [&](const auto& e) { return e.elastomer == elastomer.name && !e.excluded(); });
        const auto line = StudyLines::line_of(lines_.at("elastomers", elastomer.name));
        if (!loops)
            add(lines_.asking(line, {"youngs_modulus"}), "elastomer " + elastomer.name,
                "no modulus: neither youngs_modulus nor a loop is given, so that nothing can be predicted for "
                "this elastomer");
    }

    void look_at(const ExperimentInput& experiment, std::size_t line) {
        if (!experiment.sphere_radius && !study_.elastomer(experiment.elastomer)->sphere_radius)
            add(lines_.asking(line, {"sphere_radius"}), shown(experiment.file),
                fmt::format(
                    "no sphere_radius, neither for the experiment nor for elastomer '{}': the loop cannot be fitted",
                    experiment.elastomer));
        // contact radii in pictures take minutes to find
        if (experiment.camera)
            try_to_open(line, experiment.camera->file, [&] {
                if (!fs::is_directory(experiment.camera->file)) (void)bytes::file_source(experiment.camera->file);
                (void)bytes::file_source(experiment.file);
            });
        else try_to_open(line, experiment.file, [&] { (void)open_loop(experiment); });
    }

    const Study& study_;
    StudyLines lines_;
    std::vector<StudyGap> gaps_;
};

}  // namespace

std::vector<StudyGap> study_gaps(const Study& study) { return Gaps(study).found(); }

}  // namespace setae::study
