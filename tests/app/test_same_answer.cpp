// SPDX-License-Identifier: BSD-3-Clause
// The same call gives the same bytes: over repeats, threads of the program and of its libraries, cores, locales, time zones,
// checkpoints, and after a kill.

#include <sched.h>

#include <optional>

#include <gtest/gtest.h>

#include "tests/app/spawned.hpp"

namespace tiretherm::app_test {
namespace {

const std::string case_library = TIRETHERM_SOURCE_DIR "/cases/";

/// What may differ between two calls, and nothing else: the time that a call took, in all and by its parts; how many threads
/// it was given; and the order of a study's journal, whose runs end in any.
const std::regex may_differ(R"re("(seconds|assembly|factor|solve|output|threads)": [-+0-9.e]+)re");
constexpr std::string_view any_order = "runs.jsonl";

struct Command {
    std::string name;
    std::string arguments;
    bool takes_threads = false;
    bool writes_files = true;
};

/// Small calls of the commands that compute.
std::vector<Command> repeated_commands() {
    const std::string data =
        " --data " + case_library + "practice/run1.csv --data " + case_library + "practice/run2.csv";
    return {{"run", "run run.toml --fields 300"},       {"compare", "compare bench.toml" + data},
            {"identify", "identify bench.toml" + data}, {"diagnose", "diagnose bench.toml" + data},
            {"study", "study study.toml", true},        {"validate", "validate table.toml", true, false}};
}

void write_short_cases(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    post::replace_file(folder / "run.toml",
                       "include = [\"" + case_library + "section/4000N_100kmh.toml\"]\n[time]\nend = \"600 s\"\n");
    post::replace_file(folder / "bench.toml",
                       "include = [\"" + case_library +
                           "practice/two_node_bench.toml\"]\n[diagnose]\ncandidates = [\"sidewall_convection\", "
                           "\"sensor_offset\", \"convection_exponent\"]\n");
    post::replace_file(folder / "study.toml", "case = \"" + two_node +
                                                  "\"\n[[vary]]\nkey = \"drive.speed\"\nfrom = \"60 km/h\"\nto = "
                                                  "\"120 km/h\"\ncount = 12\n");
    std::string table = "title = \"Two loads\"\n";
    for (const char* load : {"4000N", "7000N"}) {
        table += fmt::format(
            "[[number]]\nid = \"{0}\"\nwhat = \"bulk\"\nfiles = {{ two_node = \"{1}two_node/{0}_100kmh.toml\" "
            "}}\nchannel = \"bulk_temperature\"\nvalue = \"50 degC\"\nuncertainty = \"2 K\"\nsource = \"a page\"\n",
            load, case_library);
    }
    post::replace_file(folder / "table.toml", table);
}

/// Under which a call is made: variables of the environment, an empty one is absent; threads, where the command takes them.
struct Setting {
    std::string name;
    std::vector<std::pair<std::string, std::string>> environment;
    int threads = 1;
    bool one_core = false;
};

/// Sets variables of this process, which its calls inherit, until it ends.
class Environment {
public:
    explicit Environment(const Setting& setting) {
        for (const auto& [name, value] : setting.environment) {
            const char* before = getenv(name.c_str());
            before_.emplace_back(name, before != nullptr ? std::optional<std::string>(before) : std::nullopt);
            setenv(name.c_str(), value.c_str(), 1);
        }
        sched_getaffinity(0, sizeof cores_, &cores_);
        if (setting.one_core) {
            cpu_set_t one;
            CPU_ZERO(&one);
            for (int core = 0; core < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++core) {
                if (CPU_ISSET(core, &cores_)) {
                    CPU_SET(core, &one);
                }
            }
            sched_setaffinity(0, sizeof one, &one);
        }
    }
    ~Environment() {
        sched_setaffinity(0, sizeof cores_, &cores_);
        for (const auto& [name, value] : before_) {
            value ? setenv(name.c_str(), value->c_str(), 1) : unsetenv(name.c_str());
        }
    }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

private:
    std::vector<std::pair<std::string, std::optional<std::string>>> before_;
    cpu_set_t cores_{};
};

const Setting plain{"alone", {{"LC_ALL", "C"}, {"TZ", "UTC"}, {"OMP_NUM_THREADS", "1"}, {"OPENBLAS_NUM_THREADS", "1"}}};

std::string arguments_of(const Command& command, const Setting& setting) {
    return command.arguments + (command.takes_threads ? fmt::format(" --threads {}", setting.threads) : "") +
           " --json" + (command.writes_files ? " --out o" : "");
}

/// Everything that a call gave: its files, and what it said, each without what may differ.
std::map<std::string, std::string> answer(const std::filesystem::path& folder, const std::string& said) {
    std::map<std::string, std::string> all;
    if (std::filesystem::exists(folder / "o")) {
        all = files_of(folder / "o");
    }
    for (auto& [name, text] : all) {
        text = name == any_order ? sorted_lines(text) : text;
        text = name.ends_with(".json") ? std::regex_replace(text, may_differ, "") : text;
    }
    all["what it said"] = std::regex_replace(said, may_differ, "");
    return all;
}

std::map<std::string, std::string> answer_of(const Command& command, const Setting& setting) {
    const sample::Scratch scratch;
    write_short_cases(scratch.path());
    const Environment environment(setting);
    const Call done = call(arguments_of(command, setting), scratch.path());
    EXPECT_EQ(done.exit_code, 0) << done.out << done.err;
    return answer(scratch.path(), done.out);
}

void expect_same(const std::map<std::string, std::string>& expected, const std::map<std::string, std::string>& found) {
    EXPECT_EQ(found.size(), expected.size());
    for (const auto& [name, bytes] : expected) {
        EXPECT_TRUE(found.contains(name) && found.at(name) == bytes) << name << " differs";
    }
}

/// Every command under the plain setting and under each of some others.
void expect_same_under(const std::vector<Setting>& settings) {
    for (const Command& command : repeated_commands()) {
        const auto expected = answer_of(command, plain);
        EXPECT_GT(expected.size(), command.writes_files ? 1U : 0U);
        EXPECT_GT(expected.at("what it said").size(), 200U);
        for (const Setting& setting : settings) {
            SCOPED_TRACE(command.name + ", " + setting.name);
            expect_same(expected, answer_of(command, setting));
        }
    }
}

}  // namespace

// Bytes against bytes: no tolerance.
TEST(SameAnswer, OverRepeatsThreadsCoresAndCheckpoints) {
    expect_same_under({plain,
                       {"four threads of the libraries", {{"OMP_NUM_THREADS", "4"}, {"OPENBLAS_NUM_THREADS", "4"}}, 2},
                       {"one core, checkpoints all the time", {{"TIRETHERM_CHECKPOINT_SECONDS", "0"}}, 3, true}});
}

TEST(SameAnswer, OverLocalesAndTimeZones) {
    // A decimal comma and another day: neither is for files.
    const sample::Scratch scratch;
    const std::string made = (scratch / "de_DE.UTF-8").string();
    std::vector<Setting> settings{{"C.UTF-8, Tokyo", {{"LC_ALL", "C.UTF-8"}, {"TZ", "Asia/Tokyo"}}}};
    if (std::system(("localedef -i de_DE -f UTF-8 '" + made + "' >/dev/null 2>&1").c_str()) == 0) {
        settings.push_back({"de_DE.UTF-8", {{"LC_ALL", "de_DE.UTF-8"}, {"LOCPATH", scratch.path().string()}}});
    } else {
        std::puts("the German locale cannot be made here (localedef, package locales): it is left out");
    }
    expect_same_under(settings);
}

// Killed at a third and at two thirds of its time, and called again: `run`, `identify`, `diagnose` and `study` go on, `compare`
// and `validate` begin anew.
TEST(SameAnswer, AfterAKill) {
    for (const Command& command : repeated_commands()) {
        SCOPED_TRACE(command.name);
        const sample::Scratch scratch;
        write_short_cases(scratch / "whole");
        write_short_cases(scratch / "killed");
        const Environment environment(plain);
        Spawned whole(arguments_of(command, plain), scratch / "whole", "0");
        ASSERT_EQ(whole.end(), 0) << whole.err();
        const auto expected = answer(scratch / "whole", whole.out());
        for (const double share : {0.33, 0.67}) {
            Spawned killed(arguments_of(command, plain), scratch / "killed", "0");
            std::this_thread::sleep_for(std::chrono::duration<double>(share * whole.seconds()));
            killed.send(SIGKILL);
            killed.wait();
        }
        Spawned last(arguments_of(command, plain), scratch / "killed", "0");
        ASSERT_EQ(last.end(), 0) << last.err();
        auto found = answer(scratch / "killed", last.out());
        if (command.name == "study") {  // tells how many of its runs it kept
            found["what it said"] = expected.at("what it said");
        }
        expect_same(expected, found);
    }
}

}  // namespace tiretherm::app_test
