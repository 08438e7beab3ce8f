// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/own_outputs.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "setae/bytes/png_mark.hpp"
#include "setae/bytes/source.hpp"
#include "setae/bytes/text.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"

namespace setae::study {
namespace {

namespace fs = std::filesystem;

/// First characters of the first line of a table of results.
constexpr std::array<std::string_view, 20> table_beginnings{
    "file,surface,elastomer,lens,spot,contact,cycle,",  // fits and energies of loops
    "time [s],force [N],displacement [m],work [J],elastic [J]",
    "curve,x [m],y [m],column,row,",
    "wavevector [1/m],C1D [m3],standard_error [m3],count [1]",
    "wavevector [1/m],C_iso [m4],standard_error [m4],count [1]",
    "wavevector [1/m],C_iso [m4],C_iso_standard_error [m4],",
    "distance [m],autocorrelation [m2],count [1]",
    "distance [m],rms_slope [1],count [1]",
    "distance [m],rms_curvature [1/m],count [1]",
    "distance [m],variable_bandwidth [m],count [1]",
    "surface,elastomer,method,",
    "surface,elastomer,model,",
    "surface,method,",
    "surface,instrument,",
    "surface,file,name,instrument,",
    "quantity,surface,elastomer,method,",
    "ranking,model,formula,",
    "input,unit,before,standard_error before,",
    "fit,variant,method,W_int",
    "code,subject,message,action"};

bool holds(std::string_view text, std::string_view word) { return text.find(word) != std::string_view::npos; }

bool is_own_table(std::string_view head) {
    return std::any_of(table_beginnings.begin(), table_beginnings.end(),
                       [&](std::string_view beginning) { return head.starts_with(beginning); }) ||
           (head.starts_with("# title: ") && holds(head, "\n# written by: setae "));
}

/// JSON of a command or study.
bool is_own_json(std::string_view head) {
    if (!head.starts_with('{') && !head.starts_with('[')) return false;
    return (holds(head, "\"quantity\": \"") && holds(head, "\"symbol\": \"")) || holds(head, "\"verdict\": {") ||
           (holds(head, "\"channels\": [") && holds(head, "\"file\": \"")) || holds(head, "\"left_out\": [");
}

/// Figures as gnuplot writes them for setae.
bool is_own_svg(std::string_view head) {
    return holds(head, "<svg") && holds(head, "Produced by GNUPLOT") &&
           holds(head, "Liberation Sans, Arial, Helvetica, sans-serif");
}

bool is_own_pdf(const bytes::Source& file, std::string_view head) {
    constexpr std::uint64_t tail = 1 << 14;
    if (!head.starts_with("%PDF-")) return false;
    const auto size = std::min(file.size, tail);
    const auto end = file.bytes(file.size - size, size);
    return holds(end, "cairo") && holds(end, "/CreationDate (D:20000101000000Z");
}

constexpr std::string_view study_mark = "# study: ";

constexpr std::string_view hexadecimal = "0123456789abcdef";

bool needs_escape(char letter) {
    const auto byte = static_cast<unsigned char>(letter);
    return byte < 0x20 || byte == 0x7f || letter == '\\';
}

std::string escaped(const std::string& name) {
    std::string text;
    for (const char letter : name) {
        if (!needs_escape(letter)) {
            text += letter;
            continue;
        }
        const auto byte = static_cast<unsigned char>(letter);
        text += {'\\', 'x', hexadecimal[byte >> 4U], hexadecimal[byte & 15U]};
    }
    return text;
}

std::string unescaped(std::string_view text) {
    std::string name;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto digit = [&](std::size_t at) {
            return at < text.size() ? hexadecimal.find(text[at]) : std::string_view::npos;
        };
        const auto high = digit(i + 2), low = digit(i + 3);
        const bool escape =
            text.substr(i).starts_with("\\x") && high != std::string_view::npos && low != std::string_view::npos;
        name += escape ? static_cast<char>(16 * high + low) : text[i];
        if (escape) i += 3;
    }
    return name;
}

/// A name a list may hold: inside the folder, by its letters.
bool stays_inside(const std::string& name) {
    const fs::path path(name);
    return !name.empty() && name.find('\0') == std::string::npos && path.is_relative() &&
           path == path.lexically_normal() && *path.begin() != ".." && *path.begin() != "." && name.back() != '/';
}

ResultList parsed_list(const std::string& text) {
    ResultList list;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(study_mark)) list.study = unescaped(line.substr(study_mark.size()));
        else if (auto name = unescaped(line); !line.starts_with('#') && stays_inside(name))
            list.names.insert(std::move(name));
    }
    return list;
}

}  // namespace

ResultList read_result_list(const std::string& path) { return parsed_list(bytes::read_back(path)); }

std::string study_of_result_list(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    for (std::string line; std::getline(file, line) && line.starts_with('#');)
        if (line.starts_with(study_mark)) return unescaped(line.substr(study_mark.size()));
    return "";
}

std::string result_list_line(const std::string& name) { return escaped(name) + "\n"; }

std::string as_text(const ResultList& list) {
    auto text = std::string(result_list_heading) + std::string(study_mark) + result_list_line(list.study);
    for (const auto& name : list.names) text += result_list_line(name);
    return text;
}

bool is_own_output(const std::string& file) {
    constexpr std::uint64_t enough = 1 << 15;
    const auto ending = bytes::lowered(fs::path(file).extension().string());
    const auto any = [&](std::initializer_list<const char*> endings) {
        return std::any_of(endings.begin(), endings.end(), [&](const char* known) { return ending == known; });
    };
    if (!any({".png", ".svg", ".pdf", ".csv", ".json", ".html", ".txt"})) return false;
    try {
        const auto source = bytes::file_source(file);
        const auto head = source.head(enough);
        if (ending == ".png") return bytes::has_png_mark(head);
        if (ending == ".svg") return is_own_svg(head);
        if (ending == ".pdf") return is_own_pdf(source, head);
        if (ending == ".json") return is_own_json(head);
        if (ending == ".html") return holds(head, "<meta name=\"generator\" content=\"setae");
        return is_own_table(head) || head.starts_with(result_list_heading);
    } catch (const Error&) {
        return false;  // reading it later reports the reason
    }
}

std::set<std::string> results_in(const std::string& folder) {
    std::set<std::string> files;
    std::error_code ignored;
    const auto list = fs::path(folder) / result_list;
    if (fs::is_regular_file(list, ignored)) try {
            if (bytes::file_source(list.string()).head(result_list_heading.size()) == result_list_heading) {
                files.insert(list.string());
                for (const auto& name : read_result_list(list.string()).names)
                    files.insert((fs::path(folder) / name).string());
                return files;
            }
        } catch (const Error&) {  // no list that can be read
        }
    if (!fs::exists(fs::path(folder) / "study.json", ignored) || !fs::exists(fs::path(folder) / "report.html", ignored))
        return files;
    for (fs::recursive_directory_iterator entry(folder, ignored), end; !ignored && entry != end;
         entry.increment(ignored))
        if (entry->is_regular_file(ignored)) files.insert(entry->path().string());
    return files;
}

}  // namespace setae::study
