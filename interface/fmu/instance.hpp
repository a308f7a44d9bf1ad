// SPDX-License-Identifier: BSD-3-Clause
// One instance of an FMU, as both versions of the standard see it: its mode, its values, its steps, its kept states and its log.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "solver/real_time/tunable_session.hpp"

/// What an FMU exports: the functions of FMI 2 and FMI 3 on one session.
namespace tiretherm::fmu {

/// The numbers are those of fmi2Status and fmi3Status.
enum class Status : int { ok = 0, warning = 1, discard = 2, error = 3, fatal = 4 };

/// Where an instance is in the calling sequence.
enum class Mode : std::uint8_t { instantiated, initialization, step, terminated };
[[nodiscard]] std::string_view name_of(Mode mode);

/// The categories of the standard that an instance uses. `log_all` stands for all of them.
inline constexpr std::string_view log_discard = "logStatusDiscard";
inline constexpr std::string_view log_error = "logStatusError";
inline constexpr std::string_view log_events = "logEvents";
inline constexpr std::string_view log_all = "logAll";

/// Hands a message to the environment. @param category ends with a zero
using Logger = std::function<void(Status status, const char* category, const std::string& message)>;

/// What can be kept of an instance and taken up again, by the same or another instance of one FMU.
struct KeptState {
    Mode mode = Mode::instantiated;
    double start_time = 0.0;  ///< s
    double stop_time = 0.0;   ///< s
    double point = 0.0;       ///< s, the present communication point
    std::vector<double> session;
};

/// A call that changed nothing and may be made again otherwise.
struct Discarded : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A session behind the calling sequence of the standard. Calls go through `run`; what the other functions throw is for it.
class Instance {
public:
    /// @param resources folder of the unpacked FMU  @param token that the description of the FMU has
    /// @errors std::runtime_error: the resources cannot be read, or are not those of the description
    Instance(const std::filesystem::path& resources, std::string_view token, Logger logger, bool logging);

    /// Runs a call. What it throws, or refuses, is logged, and after an error the instance takes no more steps until it is reset.
    /// @param name of the call  @param allowed modes
    template <typename Call>
    Status run(std::string_view name, std::initializer_list<Mode> allowed, const Call& call) {
        try {
            check_mode(allowed);
            call();
            return Status::ok;
        } catch (const Discarded& reason) {
            log(Status::discard, log_discard, std::string(name) + ": " + reason.what());
            return Status::discard;
        } catch (const std::exception& reason) {
            log(Status::error, log_error, std::string(name) + ": " + reason.what());
            mode_ = Mode::terminated;
            return Status::error;
        }
    }

    /// @param categories of the standard; empty: all
    void set_logging(bool on, std::span<const char* const> categories);
    void set_up(double start_time, bool has_stop, double stop_time);
    [[nodiscard]] bool is_set_up() const { return is_set_up_; }
    void enter_initialization() { mode_ = Mode::initialization; }
    void exit_initialization();
    void terminate() { mode_ = Mode::terminated; }
    void reset();

    /// @errors std::invalid_argument for an unknown value
    void get(std::span<const std::uint32_t> which, std::span<double> values);
    /// Sets all or none. @errors Discarded for a value out of range, std::invalid_argument for what cannot be set now
    void set(std::span<const std::uint32_t> which, std::span<const double> values);
    /// Derivatives of outputs in a direction among inputs and parameters, see TunableSession::find_slopes.
    /// @param seed what each of the knowns moves by  @param sensitivity out, of the unknowns
    /// @errors std::invalid_argument for what is no unknown, or no known now; Discarded where there is no derivative
    void derive(std::span<const std::uint32_t> unknowns, std::span<const std::uint32_t> knowns,
                std::span<const double> seed, std::span<double> sensitivity);
    /// @errors Discarded when the heat balance has no solution: the instance is as it was before
    void step(double point, double size);
    [[nodiscard]] double point() const { return kept_.point; }

    [[nodiscard]] KeptState state();
    void restore(const KeptState& state);
    [[nodiscard]] std::string serialised(const KeptState& state) const;
    [[nodiscard]] KeptState deserialised(std::string_view bytes) const;

private:
    void check_mode(std::initializer_list<Mode> allowed) const;
    void log(Status status, std::string_view category, const std::string& message) const;
    void follow_settings();
    void check_settable(std::uint32_t which) const;

    std::string token_;
    Logger logger_;
    bool logs_events_ = false;
    Mode mode_ = Mode::instantiated;
    std::unique_ptr<solver::TunableSession> session_;
    std::vector<const physics::Signal*> inputs_;
    solver::ValueNumbers numbers_;
    KeptState kept_{};  ///< but for mode and session
    bool is_set_up_ = false;
    bool is_stale_ = false;  ///< inputs or parameters were set since the session began
};

}  // namespace tiretherm::fmu
