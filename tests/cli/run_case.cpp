// SPDX-License-Identifier: GPL-3.0-or-later
// Runs one case of the program and compares exit code, output and JSON with what case.toml says.
//
//   command = "$SETAE info $CASE/a.txt --json"   a shell line; $DATA is the folder of real files, $WORK an empty folder
//   needs = "jkr/pdms_a.txt"                      skip where this real file is missing
//   exit_code = 0
//   stdout = ["text it holds"], stderr = [...], no_stdout = true
//   [[json]] pointer = "/channels/0/mean", value = 1.0, tolerance = 1e-9 (relative), or null = true
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

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
    const auto line = fmt::format("({}) >'{}' 2>'{}'", command, (work / "stdout").string(), (work / "stderr").string());
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
    if (argc != 3) return 2;
    const fs::path folder = argv[2];
    const auto expected = toml::parse_file((folder / "case.toml").string());
    const char* given = std::getenv("SETAE_REFERENCE_DATA");
    const fs::path data = given ? fs::path(given) : fs::path("..") / "shared" / "data";
    if (const auto needs = expected["needs"].value<std::string>(); needs && !fs::exists(data / *needs)) {
        fmt::print("skipped: no {}; set SETAE_REFERENCE_DATA to the folder with the real files\n",
                   (data / *needs).string());
        return skipped;
    }
    char work_name[] = "/tmp/setae_case_XXXXXX";
    const fs::path work = mkdtemp(work_name);
    setenv("SETAE", argv[1], 1);
    setenv("CASE", folder.c_str(), 1);
    setenv("DATA", data.c_str(), 1);
    setenv("WORK", work.c_str(), 1);
    setenv("SETAE_CACHE", (work / "cache").c_str(), 1);  // no case sees what another kept

    const auto result = run(expected["command"].value<std::string>().value_or("false"), work);
    Verdict verdict;
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
