// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/own_outputs.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>

#include "setae/bytes/png_mark.hpp"
#include "setae/bytes/source.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"

namespace setae::study {
namespace {

namespace fs = std::filesystem;

/// How the first line of a table of results begins.
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

}  // namespace

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
        return false;  // whoever reads it says why
    }
}

std::set<std::string> results_in(const std::string& folder) {
    std::set<std::string> files;
    std::error_code ignored;
    const auto list = fs::path(folder) / result_list;
    if (fs::is_regular_file(list, ignored)) try {
            const auto text = bytes::file_source(list.string()).all();
            if (text.starts_with(result_list_heading)) {
                files.insert(list.string());
                std::istringstream lines(text);
                for (std::string line; std::getline(lines, line);)
                    if (!line.empty() && !line.starts_with('#')) files.insert((fs::path(folder) / line).string());
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
