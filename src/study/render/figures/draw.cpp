// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "setae/bytes/png_mark.hpp"
#include "setae/bytes/temporary_folder.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/figures/figure.hpp"
#include "setae/platform/files.hpp"
#include "setae/platform/processes.hpp"

namespace setae::figures {
namespace {

/// The program's environment without time zone, language and gnuplot's own settings, which would change figures.
std::vector<std::string> environment() {
    auto variables = platform::environment();
    std::erase_if(variables, [](std::string_view variable) {
        const auto begins = [&](std::string_view name) { return variable.starts_with(name); };
        return begins("TZ=") || begins("LC_") || begins("LANG") || begins("GNUPLOT") || begins("SOURCE_DATE_EPOCH=");
    });
    variables.insert(variables.begin(), {"TZ=UTC0", "LC_ALL=C.UTF-8"});
    return variables;
}

/// Runs gnuplot on a script, with its messages in a file. The script names its output relative to `folder`.
platform::ProcessEnd run_gnuplot(const std::string& folder, const std::string& script, const std::string& words) {
    // --default-settings: no initialisation file of the user changes a figure
    return platform::run({.words = {"gnuplot", "--default-settings", script},
                          .environment = environment(),
                          .folder = folder,
                          .output = words});
}

/// A PDF without its time of creation, which cairo cannot omit. Equal length, so offsets in the file stay valid.
void erase_date(std::string& content) {
    constexpr std::string_view key = "/CreationDate (D:";
    for (auto at = content.find(key); at != std::string::npos; at = content.find(key, at + 1)) {
        const std::string_view epoch = "20000101000000Z00'00";
        auto end = content.find(')', at);
        if (end == std::string::npos) return;
        const auto first = at + key.size();
        for (std::size_t i = first; i < end; ++i) content[i] = i - first < epoch.size() ? epoch[i - first] : '0';
    }
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

/// Completes an SVG: similar fonts where there is no Liberation Sans, which the file names and does not contain, blanks
/// between upright and italic text, and a character that gnuplot does not escape.
void complete_svg(std::string& content) {
    replace_all(content, "font-family=\"Liberation Sans\"",
                "font-family=\"Liberation Sans, Arial, Helvetica, sans-serif\"");
    replace_all(content, "<text>", "<text xml:space=\"preserve\">");
    // outside CDATA sections, of which gnuplot writes none, XML forbids these three letters
    replace_all(content, "]]>", "]]&gt;");
}

/// Name of gnuplot's output, within a folder of its own.
std::string output_name(const std::string& ending) { return "figure." + ending; }

}  // namespace

std::string drawn(const Figure& figure, const std::string& ending) {
    const bytes::TemporaryFolder folder("figure");
    // relative, so that no folder's name needs quoting
    const auto output = output_name(ending);
    bytes::write_unflushed_file(folder.file("script.gp"), {gnuplot_script(figure, ending, output)});
    const auto end = run_gnuplot(folder.path(), "script.gp", folder.file("words.txt"));
    if (end.start == std::errc::no_such_file_or_directory)
        throw FileError(
            "a figure cannot be drawn without gnuplot; install it (Debian: apt-get install gnuplot-nox) or run ./setup");
    if (end.start) throw FileError(fmt::format("gnuplot cannot be started: {}", end.start.message()));
    std::error_code missing;
    if (!end.well() || std::filesystem::file_size(folder.file(output), missing) == 0 || missing)
        throw FileError(fmt::format("gnuplot failed: {}", trimmed(bytes::read_back(folder.file("words.txt")))));
    auto content = bytes::read_back(folder.file(output));
    if (ending == "pdf") erase_date(content);
    if (ending == "svg") complete_svg(content);
    return bytes::with_png_mark(std::move(content));
}

std::string drawing_program() {
    const char* search = std::getenv("PATH");
    std::string_view rest = search ? search : "";
    while (!rest.empty()) {
        const auto end = rest.find(':');
        const auto file = std::filesystem::path(rest.substr(0, end)) / "gnuplot";
        std::error_code error;
        const auto real = std::filesystem::canonical(file, error);
        if (!error && platform::is_executable(real.string())) {
            const auto size = std::filesystem::file_size(real, error);
            const auto time = std::filesystem::last_write_time(real, error);
            if (!error) return fmt::format("{} {} {}", real.string(), size, time.time_since_epoch().count());
        }
        if (end == std::string_view::npos) break;
        rest.remove_prefix(end + 1);
    }
    return {};
}

void draw(const Figure& figure, const std::string& path) {
    auto ending = std::filesystem::path(path).extension().string();
    if (!ending.empty()) ending.erase(0, 1);
    try {
        bytes::write_whole_file(path, drawn(figure, ending));
    } catch (const FileError& error) {
        const std::string message = error.what();
        throw FileError(message.starts_with(path) ? message : path + ": " + message);
    }
}

}  // namespace setae::figures
