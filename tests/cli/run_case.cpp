// SPDX-License-Identifier: GPL-3.0-or-later
// cli_case SETAE FILE NAME: runs the case [NAME] of a file of cases and compares exit code, output and JSON with it.
//
//   [info_line_scan]                              the name of the test is cli.info_line_scan
//   # why the expected values are right
//   command = "$SETAE info $DATA/sine.csv --json" what sh runs in the root of the sources
//   needs = "jkr/pdms_a.txt"                      skip where this real file is missing
//   exit_code = 0                                 of the last command; 0 where it is not stated
//   stdout = ["part of it"], stderr = ["part"]    no_stdout = true: standard output is empty
//   json = [                                      parts of standard output; tolerances are relative
//     { pointer = "/channels/0/shape/0", value = 200 },
//     { pointer = "/channels/0/size/0", value = 2e-5, tolerance = 1e-9 },
//     { pointer = "/channels/0/instrument", null = true },
//   ]
//
// $DATA is the folder data beside the file of cases, $REAL_DATA the folder of real files, $WORK a new empty folder.
// A command of several lines is a script between ''' and ''', in which nothing is escaped: a line that ends in && goes
// on only after success, one that ends in a backslash is continued; after any other line the next one runs in any case.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <sys/wait.h>
#include <toml++/toml.h>
#include <nlohmann/json.hpp>

namespace fs = std::filesystem;

namespace {

constexpr int skipped = 77;

std::string content(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

struct Run {
    int exit_code = 0;
    std::string out, err;
};

Run run(const std::string& command, const fs::path& work) {
    const auto line =
        fmt::format("({}\n) >'{}' 2>'{}'", command, (work / "stdout").string(), (work / "stderr").string());
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(work / "stdout"), content(work / "stderr")};
}

class Verdict {
public:
    void require(bool condition, const std::string& message) {
        if (condition) return;
        fmt::print(stderr, "case failed: {}\n", message);
        failed_ = true;
    }
    [[nodiscard]] bool failed() const { return failed_; }

private:
    bool failed_ = false;
};

/// A key that nothing reads would be a check that nothing makes.
void check_keys(const toml::table& expected, Verdict& verdict) {
    const std::set<std::string_view> known{"command", "needs", "exit_code", "no_stdout", "stdout", "stderr", "json"};
    for (const auto& [key, value] : expected)
        verdict.require(known.contains(key.str()), fmt::format("unknown key '{}'", key.str()));
}

void check_texts(const toml::table& expected, const char* key, const std::string& text, Verdict& verdict) {
    const auto* list = expected[key].as_array();
    if (!list) return;
    for (const auto& element : *list) {
        const auto wanted = element.value<std::string>().value_or("");
        verdict.require(text.find(wanted) != std::string::npos,
                        fmt::format("{} holds no '{}', it is:\n{}", key, wanted, text));
    }
}

void check_value(const toml::table& expected, const nlohmann::json& json, Verdict& verdict) {
    const auto pointer = expected["pointer"].value<std::string>().value_or("");
    const nlohmann::json::json_pointer at(pointer);
    if (!json.contains(at)) {
        verdict.require(false, fmt::format("no {} in the JSON", pointer));
        return;
    }
    const auto& value = json.at(at);
    if (expected["null"].value<bool>().value_or(false)) {
        verdict.require(value.is_null(), fmt::format("{} is {}, expected null", pointer, value.dump()));
    } else if (const auto flag = expected["value"].value_exact<bool>()) {
        verdict.require(value == *flag, fmt::format("{} is {}, expected {}", pointer, value.dump(), *flag));
    } else if (const auto text = expected["value"].value_exact<std::string>()) {
        verdict.require(value.is_string() && value.get<std::string>() == *text,
                        fmt::format("{} is {}, expected \"{}\"", pointer, value.dump(), *text));
    } else {
        const double wanted = expected["value"].value<double>().value_or(NAN),
                     tolerance = expected["tolerance"].value<double>().value_or(0.0);
        verdict.require(
            value.is_number() && std::abs(value.get<double>() - wanted) <= tolerance * std::abs(wanted),
            fmt::format("{} is {}, expected {} within a relative {}", pointer, value.dump(), wanted, tolerance));
    }
}

void check_json(const toml::table& expected, const std::string& out, Verdict& verdict) {
    const auto* checks = expected["json"].as_array();
    if (!checks) return;
    const auto json = nlohmann::json::parse(out, nullptr, false);
    if (json.is_discarded()) {
        verdict.require(false, "standard output is no JSON:\n" + out);
        return;
    }
    for (const auto& check : *checks) check_value(*check.as_table(), json, verdict);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) return 2;
    const fs::path file = fs::absolute(argv[2]);
    const auto cases = toml::parse_file(file.string());
    const auto* found = cases[argv[3]].as_table();
    if (!found) {
        fmt::print(stderr, "{}: no case [{}]; run cmake again\n", file.string(), argv[3]);
        return 2;
    }
    const auto& expected = *found;
    Verdict verdict;
    check_keys(expected, verdict);
    const char* given = std::getenv("SETAE_REFERENCE_DATA");
    const fs::path real_data = given ? fs::path(given) : fs::path("..") / "shared" / "data";
    if (const auto needs = expected["needs"].value<std::string>(); needs && !fs::exists(real_data / *needs)) {
        fmt::print("skipped: no {}; set SETAE_REFERENCE_DATA to the folder with the real files\n",
                   (real_data / *needs).string());
        return skipped;
    }
    char work_name[] = "/tmp/setae_case_XXXXXX";
    const fs::path work = mkdtemp(work_name);
    setenv("SETAE", argv[1], 1);
    setenv("DATA", (file.parent_path() / "data").c_str(), 1);
    setenv("REAL_DATA", real_data.c_str(), 1);
    setenv("WORK", work.c_str(), 1);
    setenv("SETAE_CACHE", (work / "cache").c_str(), 1);  // no case sees what another kept

    const auto result = run(expected["command"].value<std::string>().value_or("false"), work);
    const auto exit_code = expected["exit_code"].value<int>().value_or(0);
    verdict.require(result.exit_code == exit_code, fmt::format("exit code {}, expected {}; standard error:\n{}",
                                                               result.exit_code, exit_code, result.err));
    verdict.require(!expected["no_stdout"].value<bool>().value_or(false) || result.out.empty(),
                    "standard output is not empty:\n" + result.out);
    check_texts(expected, "stdout", result.out, verdict);
    check_texts(expected, "stderr", result.err, verdict);
    check_json(expected, result.out, verdict);
    fs::remove_all(work);
    return verdict.failed() ? 1 : 0;
}
