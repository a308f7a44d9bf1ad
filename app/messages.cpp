#include "app/messages.hpp"

#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

namespace tiretherm::app {

namespace {

using Json = nlohmann::ordered_json;

void print(const Json& json) {
    // A byte that is not UTF-8 may stand in the user's file; it must not end the program.
    fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

bool on_terminal(std::FILE* stream) { return isatty(fileno(stream)) == 1; }

bool may_be_bold() { return on_terminal(stdout) && std::getenv("NO_COLOR") == nullptr; }

void tell_error(const std::string& sentence, const std::string& remedy, bool json) {
    const std::string whole = remedy.empty() ? sentence : fmt::format("{}; {}", sentence, remedy);
    if (json) {
        print({{"error", whole}, {"mistakes", Json::array()}});
    } else {
        fmt::print(stderr, "tiretherm: {}\n", whole);
    }
}

void tell_mistakes(const input::Reading& reading, const std::string& consequence, bool json) {
    const std::size_t n = reading.mistakes.size();
    const std::string sentence = fmt::format("{} {}; {}", n, n == 1 ? "mistake" : "mistakes", consequence);
    if (!json) {
        fmt::print(stderr, "{}{}\n", input::render(reading), sentence);
        return;
    }
    Json mistakes = Json::array();
    for (const input::Mistake& mistake : reading.mistakes) {
        mistakes.push_back({{"file", mistake.file},
                            {"line", mistake.line},
                            {"column", mistake.column},
                            {"length", mistake.length},
                            {"message", mistake.what},
                            {"remedy", mistake.remedy}});
    }
    print({{"error", sentence}, {"mistakes", mistakes}, {"warnings", reading.warnings}});
}

}  // namespace tiretherm::app
