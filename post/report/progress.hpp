// SPDX-License-Identifier: BSD-3-Clause
// How far long work is, for a person who waits: stage, share done, speed and remaining time, in one line.
#pragma once

#include <cstddef>
#include <cstdio>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace tiretherm::post {

/// Columns of a terminal: COLUMNS where it is set, otherwise as the terminal says; 80 where neither is known.
[[nodiscard]] std::size_t terminal_width(std::FILE* stream);

/// How far a run is, for the line below.
struct Advance {
    double start = 0.0;    ///< s
    double end = 0.0;      ///< s
    double time = 0.0;     ///< s, now
    double hottest = 0.0;  ///< K, now
    double elapsed = 0.0;  ///< s of wall time, > 0
};

/// `laser/one_watt  37 %  about 0.4 s left  t = 662 s of 1800 s  hottest 98.1 °C  2 100 x real time`
[[nodiscard]] std::string progress_line(const std::string& name, const Advance& advance);

/// How far work is that consists of equal pieces.
struct WorkDone {
    /// One of several things that are done one after the other.
    struct Stage {
        std::string doing{};     ///< "candidate"; empty: there is one stage alone
        std::string of{};        ///< "sidewall_convection"
        std::size_t number = 0;  ///< of `count` pieces that the stage consists of, from 1
        std::size_t count = 0;   ///< 0: not known, and then nothing is said of the time left
        double elapsed = 0.0;    ///< s of wall time since the stage began
    };
    Stage stage{};
    std::size_t done = 0;            ///< pieces
    std::size_t total = 0;           ///< 0: not known, and then nothing is said of the time left
    std::size_t at_most = 0;         ///< where `total` is the least that it may become; otherwise 0
    std::size_t kept = 0;            ///< of those done, by an earlier call: they took no time
    std::string_view thing = "run";  ///< a piece
};

/// `candidate 7 of 23: sidewall_convection, about 40 s left, 212 simulations, 3.4 simulations/s, 62 s so far` - what is left
/// is left of the candidates, by the six that are done - or where the total is known
/// `12 of 40 runs, 3.1 runs/s, about 9 s left`, or within what bounds `12 of 40 to 130 runs, 3 runs/s, 9.3 s to 39 s left`.
/// @param elapsed s of wall time
[[nodiscard]] std::string work_line(const WorkDone& work, double elapsed);

/// One line of stderr: on a terminal rewritten at most ten times a second and removed at the end, in a file or a pipe a line
/// a minute.
class ProgressLine {
public:
    enum class Kind { silent, rewritten, each_minute, listened };
    /// Takes a line ten times a second at most. @param share done, 0 to 1; NaN: not known
    using Listener = std::function<void(const std::string& line, double share)>;
    /// Seconds of wall time from any moment on.
    using Clock = std::function<double()>;

    /// @param stream where the line goes, usually stderr
    ProgressLine(std::FILE* stream, Kind kind, Clock clock = wall_clock);
    /// As it suits the stream. @param quiet stays silent
    ProgressLine(std::FILE* stream, bool quiet);
    explicit ProgressLine(Listener listener);
    ~ProgressLine() { wipe(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// @param line makes the line of the seconds since the beginning; called only where one is due
    /// @param share done, 0 to 1; NaN: not known
    void show(const std::function<std::string(double elapsed)>& line,
              double share = std::numeric_limits<double>::quiet_NaN());
    void show(const WorkDone& work);
    /// Removes the line, so that other text can follow.
    void wipe();

    [[nodiscard]] static double wall_clock();

private:
    std::FILE* stream_ = nullptr;
    Listener listener_{};
    Kind kind_;
    Clock clock_;
    double begun_;
    double written_;
    bool stands_ = false;
};

/// The line of one run.
class Progress {
public:
    Progress(ProgressLine& line, std::string name, double start, double end);

    /// @param time s  @param temperature [n_nodes] K
    void update(double time, std::span<const double> temperature);

private:
    ProgressLine* line_;
    std::string name_;
    double start_;
    double end_;
};

}  // namespace tiretherm::post
