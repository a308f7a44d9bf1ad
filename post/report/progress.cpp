// SPDX-License-Identifier: BSD-3-Clause
// Rewrites the progress line at most ten times a second, cut to the width of the terminal.

#include "post/report/progress.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <sys/ioctl.h>

#include "input/text/suggestions.hpp"
#include "post/report/table.hpp"
#include "solver/celsius.hpp"

namespace tiretherm::post {

namespace {

constexpr std::chrono::milliseconds interval{100};

/// A longer line would wrap, and then it could not be rewritten.
std::string cut_to_width(const std::string& line, std::FILE* stream) {
    winsize size{};
    const std::size_t width =
        ioctl(fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 1 ? size.ws_col - 1u : 120u;
    std::size_t seen = 0;
    for (std::size_t byte = 0; byte < line.size(); ++byte) {
        const bool starts_character = (static_cast<unsigned char>(line[byte]) & 0xC0) != 0x80;
        if (starts_character && ++seen > width) {
            return line.substr(0, byte);
        }
    }
    return line;
}

}  // namespace

std::string progress_line(const std::string& name, const Advance& advance) {
    const double done = advance.time - advance.start;
    const double whole = advance.end - advance.start;
    std::string line = fmt::format("{}  {:.0f} %  t = {:.0f} s of {:.0f} s  hottest {:.1f} °C", name,
                                   whole > 0.0 ? 100.0 * done / whole : 100.0, advance.time, advance.end,
                                   solver::celsius(advance.hottest));
    if (done > 0.0) {
        line += fmt::format("  {} x real time  {:.1f} s left", grouped(done / advance.elapsed),
                            advance.elapsed * (whole - done) / done);
    }
    return line;
}

Progress::Progress(std::FILE* stream, bool shown, std::string name, double start, double end)
    : stream_(stream),
      shown_(shown),
      name_(std::move(name)),
      start_(start),
      end_(end),
      begun_(Clock::now()),
      written_(begun_) {}

Progress::~Progress() {
    if (line_stands_) {
        fmt::print(stream_, "\r\033[K");
        std::fflush(stream_);
    }
}

void Progress::update(double time, std::span<const double> temperature) {
    const Clock::time_point now = Clock::now();
    if (!shown_ || now - written_ < interval) {
        return;
    }
    const Advance advance{.start = start_,
                          .end = end_,
                          .time = time,
                          .hottest = *std::max_element(temperature.begin(), temperature.end()),
                          .elapsed = std::chrono::duration<double>(now - begun_).count()};
    fmt::print(stream_, "\r{}\033[K", cut_to_width(progress_line(input::printable(name_), advance), stream_));
    std::fflush(stream_);
    written_ = now;
    line_stands_ = true;
}

}  // namespace tiretherm::post
