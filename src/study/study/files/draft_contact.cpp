// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "draft_text.hpp"
#include "setae/bytes/text.hpp"

namespace setae::study {
namespace {

namespace fs = std::filesystem;

/// Bodies of a loop, by its file's metadata, else by its name.
struct RecognisedLoop {
    const DraftLoop* loop;
    std::string surface, surface_remark, elastomer, elastomer_remark, stage;
    bool reference = false;
    std::string sphere_radius;  ///< as the file states it
};

bool is_part(char c) {
    return static_cast<unsigned char>(c) >= 0x80 || std::isalnum(static_cast<unsigned char>(c)) != 0;
}

/// Parts of a name between characters that are neither letter nor digit, in lower case.
std::vector<std::string> parts_of(const std::string& name) {
    std::vector<std::string> parts;
    bool within = false;
    for (const char c : bytes::lowered(name)) {
        if (is_part(c) && !within) parts.emplace_back();
        if (is_part(c)) parts.back() += c;
        within = is_part(c);
    }
    return parts;
}

/// Removes a name's parts from a list where they are consecutive.
bool take(std::vector<std::string>& parts, const std::string& name) {
    const auto wanted = parts_of(name);
    if (wanted.empty()) return false;
    const auto found = std::search(parts.begin(), parts.end(), wanted.begin(), wanted.end());
    if (found == parts.end()) return false;
    parts.erase(found, found + static_cast<std::ptrdiff_t>(wanted.size()));
    return true;
}

/// The surface whose name is in that of the loop, the longest first; the other parts may name the elastomer.
std::string surface_in(std::vector<std::string>& parts, std::vector<std::string> surfaces) {
    std::stable_sort(surfaces.begin(), surfaces.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    for (const auto& surface : surfaces)
        if (take(parts, surface)) return surface;
    return "";
}

/// Rest of a name without words that do not describe the material.
std::string elastomer_in(const std::vector<std::string>& parts) {
    static const std::set<std::string> others{"loop", "jkr", "force", "curve", "run", "test", "measurement"};
    std::string name;
    for (const auto& part : parts)
        if (!others.contains(part) &&
            !std::all_of(part.begin(), part.end(), [](unsigned char c) { return std::isdigit(c) != 0; }))
            name += (name.empty() ? "" : "_") + part;
    return name;
}

RecognisedLoop recognised(const DraftLoop& loop, const std::vector<std::string>& surfaces) {
    const auto& metadata = loop.content->table->metadata;
    const auto stated = [&](const char* key) {
        const auto entry = metadata.find(key);
        return entry == metadata.end() ? std::string() : entry->second;
    };
    RecognisedLoop result{.loop = &loop, .sphere_radius = stated("sphere_radius")};
    auto parts = parts_of(fs::path(loop.file).stem().string());
    result.reference = take(parts, "reference") || take(parts, "ref");
    result.stage = take(parts, "before") ? "before" : take(parts, "after") ? "after" : "";
    result.surface = surface_in(parts, surfaces);
    result.surface_remark = "by its name";
    if (auto said = stated("surface"); !said.empty()) {
        result.surface = said;
        result.surface_remark = "as the file states";
    } else if (result.surface.empty() && surfaces.size() == 1) {
        result.surface = surfaces.front();
        result.surface_remark = "the only one";
    }
    result.elastomer = elastomer_in(parts);
    result.elastomer_remark = "by its name";
    if (auto said = stated("elastomer"); !said.empty()) {
        result.elastomer = said;
        result.elastomer_remark = "as the file states";
    }
    if (result.elastomer.empty()) {
        result.elastomer = "elastomer";
        result.elastomer_remark = "whatever it is called";
    }
    return result;
}

std::string experiment_text(const RecognisedLoop& loop) {
    const auto& content = *loop.loop->content;
    std::string text =
        "[[experiments]]\n" + draft_line("file", loop.loop->file, fmt::format("{} samples", content.table->rows()));
    if (loop.reference) {
        text += draft_line("role", "reference", "on a smooth reference");
        if (!loop.stage.empty()) text += draft_line("stage", loop.stage, "the rough loops");
    } else {
        text += draft_line("surface", loop.surface.empty() ? "?" : loop.surface,
                           loop.surface.empty() ? "one of the surfaces above" : loop.surface_remark);
    }
    text += draft_line("elastomer", loop.elastomer, loop.elastomer_remark);
    for (const auto& missing : content.missing) {
        if (missing == "spring_constant")
            text += draft_line("spring_constant", "?", "of the cantilever, such as \"0.05 N/m\"");
        if (missing == "sensitivity") text += draft_line("sensitivity", "?", "of its deflection, such as \"55 nm/V\"");
        if (missing == "columns" && loop.loop->mappings.size() == 1)
            text += draft_line("mapping", loop.loop->mappings.front(), "came with setae and reads its columns");
        else if (missing == "columns")
            text += draft_line(
                "mapping", "?",
                loop.loop->mappings.empty()
                    ? "a file that names its columns, see `setae jkr import`: " + content.note
                    : fmt::format("one that came with setae and reads it: {}", fmt::join(loop.loop->mappings, ", ")));
    }
    return text;
}

/// An elastomer with the radius that all its loops state.
std::string elastomer_text(const std::string& name, const std::vector<RecognisedLoop>& loops) {
    std::set<std::string> radii;
    for (const auto& loop : loops)
        if (loop.elastomer == name) radii.insert(loop.sphere_radius);
    const bool stated = radii.size() == 1 && !radii.begin()->empty();
    return fmt::format("[elastomers.{}]\n", draft_key(name)) +
           draft_line("surface_energy", "?", "such as \"25 ± 1 mJ/m2\"; the modulus comes from its loops") +
           (stated ? draft_line("sphere_radius", *radii.begin(), "as its loops give it")
                   : draft_line("sphere_radius", "?", "of the lens, such as \"1.25 mm\""));
}

/// Every line as a comment, to be taken in by removing "# ".
std::string commented(const std::string& text) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const auto end = text.find('\n', at);
        result += "# " + text.substr(at, end - at) + "\n";
        at = end + 1;
    }
    return result;
}

std::string rough_solid_text() {
    return "[rough_solid]\n" + draft_line("youngs_modulus", "?", "of the hard, rough body, such as \"1100 GPa\"") +
           draft_line("poisson_ratio", "?", "such as \"0.06\"");
}

constexpr const char* example =
    "\n# No loops were found. This is how a soft sphere pressed on a surface is described:\n# "
    "[rough_solid]\n# youngs_modulus = \"1100 GPa\"\n# poisson_ratio = 0.06\n#\n# [elastomers.soft]                     "
    "# without youngs_modulus it comes from its loops\n# youngs_modulus = \"0.7 ± 0.02 MPa\"\n# "
    "surface_energy = \"25 ± 1 mJ/m2\"\n# sphere_radius = \"1.25 mm\"\n# preload = \"1 mN\"                      "
    "# loops are predicted with it, measured or not\n#\n# [[experiments]]\n# file = \"loop.csv\"\n# "
    "surface = \"A\"\n# elastomer = \"soft\"\n";

}  // namespace

std::string draft_contact(const std::vector<DraftLoop>& loops, const std::vector<std::string>& recordings,
                          const std::vector<std::string>& surfaces) {
    std::string text = "\n" + draft_rule("Contact: elastomers and experiments");
    for (const auto& file : recordings)
        text +=
            fmt::format("# {}: frames of a contact, a loop's camera = {{ file = … }}; `setae jkr radius` reads them\n",
                        comment_line(file));
    if (loops.empty()) return text + example;
    std::vector<RecognisedLoop> found;
    std::vector<std::string> elastomers;
    for (const auto& loop : loops) {
        found.push_back(recognised(loop, surfaces));
        if (std::find(elastomers.begin(), elastomers.end(), found.back().elastomer) == elastomers.end())
            elastomers.push_back(found.back().elastomer);
    }
    text += "\n# Take the \"# \" in front of all lines below away once their \"?\" are answered.\n" +
            commented(rough_solid_text());
    for (const auto& name : elastomers) text += "#\n" + commented(elastomer_text(name, found));
    for (const auto& loop : found) text += "#\n" + commented(experiment_text(loop));
    return text;
}

}  // namespace setae::study
