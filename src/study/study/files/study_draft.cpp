// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/study_draft.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "draft_text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/formats/container.hpp"
#include "setae/study/instrument_words.hpp"
#include "setae/tables/mapping_folder.hpp"

namespace setae::study {
namespace {

namespace fs = std::filesystem;

/// Files of one surface by its folder.
struct SurfaceFiles {
    std::string name;
    std::vector<DraftMeasurement> measurements;
    std::vector<const FileContent*> spectra, micrographs;
};

fs::path whole_path(const fs::path& path) {
    std::error_code ignored;
    return fs::weakly_canonical(fs::absolute(path, ignored), ignored);
}

/// The folder relative to which surfaces are named: the given one, or the one around all files.
fs::path root_of(const std::vector<std::string>& paths) {
    fs::path root;
    for (const auto& path : paths) {
        const auto whole = whole_path(path);
        const auto folder = is_folder(whole.string()) ? whole : whole.parent_path();
        if (root.empty()) {
            root = folder;
            continue;
        }
        const auto [end, other] = std::mismatch(root.begin(), root.end(), folder.begin(), folder.end());
        fs::path shared;
        for (auto part = root.begin(); part != end; ++part) shared /= *part;
        root = shared;
    }
    return root;
}

/// "rougher" of mine/rougher/afm/scan.spm: the folder below the root, without folders named after instruments.
std::string surface_of_folder(const fs::path& folder, const fs::path& root) {
    std::string name;
    for (const auto& part : folder.lexically_relative(root))
        if (part != "." && instrument_of_word(fmt::format("{}", fmt::join(words_in_name(part.string()), " "))).empty())
            name += (name.empty() ? "" : "/") + part.string();
    return name.empty() ? root.filename().string() : name;
}

class Draft {
public:
    Draft(const std::vector<std::string>& paths, const std::string& study_file, const std::string& mapping_folder)
        : root_(root_of(paths)),
          base_(whole_path(fs::path(study_file)).parent_path()),
          mapping_folder_(mapping_folder) {
        const auto found = found_files(paths);
        draft_.left_out = found.unreadable;
        draft_.own = found.own;
        std::set<fs::path> seen{whole_path(study_file)};
        for (const auto& file : found.files)
            if (const auto whole = whole_path(file); seen.insert(whole).second) look_at(file);
        for (const auto& content : contents_) add(*content);
    }

    StudyDraft written() && {
        std::string text = draft_heading(valid_utf8(root_.filename().string()));
        for (const auto& surface : surfaces_) text += surface_text(surface);
        text += contact_text(loops_, recordings_);
        if (!draft_.left_out.empty()) text += "\n# Left out:\n";
        for (const auto& left : draft_.left_out) text += "# " + comment_line(left.reason) + "\n";
        draft_.text = std::move(text);
        return std::move(draft_);
    }

private:
    void look_at(const std::string& file) {
        if (const auto named = relative(file); valid_utf8(named) != named) {
            draft_.left_out.push_back(
                {file, file + ": its name is no UTF-8, which a study's file cannot hold; rename it"});
            return;
        }
        try {
            contents_.push_back(std::make_unique<FileContent>(file_content(file)));
        } catch (const std::exception& error) {
            draft_.left_out.push_back({file, reason_of(error, file)});
        }
    }

    [[nodiscard]] std::string relative(const std::string& file) const {
        return whole_path(file).lexically_proximate(base_).generic_string();
    }

    SurfaceFiles& surface(const std::string& given) {
        const auto name = valid_utf8(given);
        const auto known =
            std::find_if(surfaces_.begin(), surfaces_.end(), [&](const auto& s) { return s.name == name; });
        if (known != surfaces_.end()) return *known;
        surfaces_.push_back({name, {}, {}, {}});
        return surfaces_.back();
    }
    SurfaceFiles& surface_of(const std::string& file) {
        return surface(surface_of_folder(whole_path(file).parent_path(), root_));
    }

    void add(const FileContent& content) {
        switch (content.kind) {
            case FileKind::topography: return add_topography(content);
            case FileKind::container: return add_container(content);
            case FileKind::spectrum: return surface_of(content.file).spectra.push_back(&content);
            case FileKind::micrograph: return surface_of(content.file).micrographs.push_back(&content);
            case FileKind::recording: return recordings_.push_back(relative(content.file));
            case FileKind::loop:
            case FileKind::force_curve:
                return loops_.push_back({relative(content.file), &content, mappings_of(content)});
            case FileKind::study:
            case FileKind::recipe:
            case FileKind::mapping:
            case FileKind::pipeline: return;
        }
    }

    /// The mappings that read a loop with unknown columns.
    [[nodiscard]] std::vector<std::string> mappings_of(const FileContent& content) const {
        const bool open = std::find(content.missing.begin(), content.missing.end(), "columns") != content.missing.end();
        return open ? tables::fitting_mappings(content.file, mapping_folder_) : std::vector<std::string>{};
    }

    /// The preferred channel, with the others in its remark.
    void add_topography(const FileContent& content) {
        std::vector<std::size_t> heights;
        for (std::size_t i = 0; i < content.channels.size(); ++i)
            if (content.channels[i].info.is_height) heights.push_back(i);
        if (heights.empty()) {
            draft_.left_out.push_back({content.file, content.file + ": none of its channels holds heights"});
            return;
        }
        const auto chosen = formats::preferred_channel(content.channels).value_or(heights.front());
        DraftMeasurement measurement{relative(content.file), &content.channels[chosen].info, {}, {}};
        if (heights.size() > 1) {
            measurement.channel = chosen;
            for (const auto i : heights)
                measurement.channels +=
                    fmt::format("{}{} '{}'", i == heights.front() ? "" : ", ", i, content.channels[i].info.name);
        }
        surface_of(content.file).measurements.push_back(std::move(measurement));
    }

    /// One entry a member, as each may have an instrument of its own; surfaces are those of the index.
    void add_container(const FileContent& content) {
        std::size_t channel = 0;
        for (const auto& inner : formats::read_container(bytes::file_source(content.file)).container.surfaces) {
            auto& of_index = surface(inner.name.empty() ? fs::path(content.file).stem().string() : inner.name);
            for (std::size_t i = 0; i < inner.topographies.size(); ++i, ++channel) {
                const auto& info = content.channels.at(channel).info;
                if (info.format.empty())
                    draft_.left_out.push_back(
                        {content.file, fmt::format("{}: channel {} cannot be read", content.file, channel)});
                else of_index.measurements.push_back({relative(content.file), &info, channel, info.name});
            }
        }
    }

    std::string surface_text(const SurfaceFiles& surface) {
        std::string text = "\n" + draft_rule("Surface " + surface.name);
        draft_.micrographs += surface.micrographs.size();
        if (!surface.measurements.empty()) ++draft_.surfaces;
        for (const auto& measurement : surface.measurements) {
            ++draft_.measurements;
            text += "\n" + measurement_text(surface.name, measurement);
        }
        for (const auto* spectrum : surface.spectra) text += "\n" + spectrum_text(surface, *spectrum);
        if (!surface.micrographs.empty()) text += "\n" + micrographs_text(surface);
        return text;
    }

    /// A table of a spectrum is a surface of its own; next to measurements it is an alternative.
    std::string spectrum_text(const SurfaceFiles& surface, const FileContent& spectrum) {
        const auto file = relative(spectrum.file);
        const auto remark = spectrum_remark(*spectrum.table);
        if (!surface.measurements.empty())
            return "# " + draft_line("power_spectrum", file, "in place of the measurements: " + remark);
        ++draft_.surfaces;
        const auto name =
            surface.spectra.size() == 1 ? surface.name : surface.name + "/" + fs::path(spectrum.file).stem().string();
        return fmt::format("[surfaces.{}]\n", draft_key(name)) + draft_line("power_spectrum", file, remark);
    }

    std::string micrographs_text(const SurfaceFiles& surface) const {
        std::string text =
            "# Micrographs. These commands, typed in this file's folder, trace their edges; the profiles are then\n"
            "# measurements with instrument = \"tem\". Where a file does not say the size of a pixel, --pixel or --scale-bar does.\n";
        for (const auto* micrograph : surface.micrographs)
            text += "#   " + contour_command(relative(micrograph->file), !micrograph->picture->pixel_size) + "\n";
        return text;
    }

    /// Loops, with surface and elastomer from their files or names.
    [[nodiscard]] std::string contact_text(const std::vector<DraftLoop>& loops,
                                           const std::vector<std::string>& recordings) {
        std::vector<std::string> names;
        for (const auto& surface : surfaces_)
            if (!surface.measurements.empty() || !surface.spectra.empty()) names.push_back(surface.name);
        draft_.loops = loops.size();
        return draft_contact(loops, recordings, names);
    }

    fs::path root_, base_;
    std::string mapping_folder_;
    std::vector<std::unique_ptr<FileContent>> contents_;
    std::vector<SurfaceFiles> surfaces_;
    std::vector<DraftLoop> loops_;
    std::vector<std::string> recordings_;
    StudyDraft draft_;
};

}  // namespace

StudyDraft draft_study(const std::vector<std::string>& paths, const std::string& study_file,
                       const std::string& mapping_folder) {
    return Draft(paths, study_file, mapping_folder).written();
}

}  // namespace setae::study
