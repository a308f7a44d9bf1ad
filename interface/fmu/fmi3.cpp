// SPDX-License-Identifier: BSD-3-Clause
// The functions of FMI 3.0 for co-simulation without events, declared as the standard gives them. A shared object has to have all of
// them: those of other kinds of FMU and of clocks are at the end, and refuse.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "interface/fmu/call.hpp"

namespace fmu = tiretherm::fmu;
using fmu::Instance;
using fmu::Mode;

namespace {

using Handle = void*;
using Environment = void*;
using String = const char*;
using Reference = std::uint32_t;
using Binary = const std::uint8_t*;
using LogMessage = void (*)(Environment environment, int status, String category, String message);
using IntermediateUpdate = void (*)(Environment environment, double time, bool can_set, bool can_get, bool is_finished,
                                    bool can_return, bool* return_wanted, double* return_time);

/// A variable in a message stands between #: one that is meant is written twice.
fmu::Logger logger_of(Environment environment, LogMessage log) {
    if (log == nullptr) {
        return {};
    }
    return [environment, log](fmu::Status status, const char* category, const std::string& message) {
        log(environment, static_cast<int>(status), category, fmu::doubled(message, '#').c_str());
    };
}

Handle refuse_kind(Environment environment, LogMessage log) {
    if (const fmu::Logger logger = logger_of(environment, log)) {
        logger(fmu::Status::error, fmu::log_error.data(), "the FMU is for co-simulation alone");
    }
    return nullptr;
}

}  // namespace

#pragma GCC visibility push(default)
extern "C" {

const char* fmi3GetVersion(void) { return "3.0"; }

int fmi3SetDebugLogging(Handle i, bool on, std::size_t n, const String categories[]) {
    return fmu::call(i, "fmi3SetDebugLogging", fmu::any_mode,
                     [&](Instance& it) { it.set_logging(on, fmu::list(categories, n)); });
}

Handle fmi3InstantiateCoSimulation(String name, String token, String resources, bool /*visible*/, bool logging,
                                   bool event_mode, bool /*early_return_allowed*/, const Reference /*intermediate*/[],
                                   std::size_t n_intermediate, Environment environment, LogMessage log,
                                   IntermediateUpdate /*update*/) {
    return fmu::instantiate(name, token, resources, logger_of(environment, log), logging, [&] {
        fmu::require(!event_mode, "the FMU has no event mode");
        fmu::require(n_intermediate == 0, "the FMU has no intermediate values");
        return std::filesystem::path(resources);
    });
}

void fmi3FreeInstance(Handle i) { delete static_cast<Instance*>(i); }

int fmi3EnterInitializationMode(Handle i, bool /*has_tolerance*/, double /*tolerance*/, double start, bool has_stop,
                                double stop) {
    return fmu::call(i, "fmi3EnterInitializationMode", {Mode::instantiated}, [&](Instance& it) {
        it.set_up(start, has_stop, stop);
        it.enter_initialization();
    });
}

int fmi3ExitInitializationMode(Handle i) {
    return fmu::call(i, "fmi3ExitInitializationMode", {Mode::initialization},
                     [](Instance& it) { it.exit_initialization(); });
}

int fmi3Terminate(Handle i) {
    return fmu::call(i, "fmi3Terminate", {Mode::step}, [](Instance& it) { it.terminate(); });
}

int fmi3Reset(Handle i) {
    return fmu::call(i, "fmi3Reset", fmu::any_mode, [](Instance& it) { it.reset(); });
}

int fmi3GetFloat64(Handle i, const Reference which[], std::size_t n, double values[], std::size_t n_values) {
    return fmu::call(i, "fmi3GetFloat64", fmu::any_mode,
                     [&](Instance& it) { it.get(fmu::list(which, n), fmu::list(values, n_values)); });
}

int fmi3SetFloat64(Handle i, const Reference which[], std::size_t n, const double values[], std::size_t n_values) {
    return fmu::call(i, "fmi3SetFloat64", {Mode::instantiated, Mode::initialization, Mode::step},
                     [&](Instance& it) { it.set(fmu::list(which, n), fmu::list(values, n_values)); });
}

int fmi3DoStep(Handle i, double point, double size, bool /*no_set_state_before*/, bool* event, bool* terminate,
               bool* early, double* last_time) {
    return fmu::call(i, "fmi3DoStep", {Mode::step}, [&](Instance& it) {
        fmu::require(event != nullptr && terminate != nullptr && early != nullptr && last_time != nullptr,
                     "there is no place for the results");
        *event = *terminate = *early = false;
        *last_time = it.point();
        it.step(point, size);
        *last_time = it.point();
    });
}

int fmi3GetFMUState(Handle i, void** state) { return fmu::get_state(i, "fmi3GetFMUState", state); }
int fmi3SetFMUState(Handle i, void* state) { return fmu::set_state(i, "fmi3SetFMUState", state); }
int fmi3FreeFMUState(Handle i, void** state) { return fmu::free_state(i, "fmi3FreeFMUState", state); }
int fmi3SerializedFMUStateSize(Handle i, void* state, std::size_t* size) {
    return fmu::serialised_size(i, "fmi3SerializedFMUStateSize", state, size);
}
int fmi3SerializeFMUState(Handle i, void* state, std::uint8_t bytes[], std::size_t size) {
    return fmu::serialise(i, "fmi3SerializeFMUState", state, reinterpret_cast<char*>(bytes), size);
}
int fmi3DeserializeFMUState(Handle i, const std::uint8_t bytes[], std::size_t size, void** state) {
    return fmu::deserialise(i, "fmi3DeserializeFMUState", reinterpret_cast<const char*>(bytes), size, state);
}

int fmi3GetDirectionalDerivative(Handle i, const Reference unknowns[], std::size_t n, const Reference knowns[],
                                 std::size_t n_known, const double seed[], std::size_t n_seed, double sensitivity[],
                                 std::size_t n_sensitivity) {
    return fmu::call(i, "fmi3GetDirectionalDerivative", {Mode::initialization, Mode::step, Mode::terminated},
                     [&](Instance& it) {
                         it.derive(fmu::list(unknowns, n), fmu::list(knowns, n_known), fmu::list(seed, n_seed),
                                   fmu::list(sensitivity, n_sensitivity));
                     });
}

// All variables are of 64 bits: of the other types nothing can be got or set.
#define TIRETHERM_NO_VARIABLES(type, Value)                                                                          \
    int fmi3Get##type(Handle i, const Reference /*which*/[], std::size_t n, Value /*values*/[], std::size_t) {       \
        return fmu::call(i, "fmi3Get" #type, fmu::any_mode, [&](Instance&) { fmu::require_none(n); });               \
    }                                                                                                                \
    int fmi3Set##type(Handle i, const Reference /*which*/[], std::size_t n, const Value /*values*/[], std::size_t) { \
        return fmu::call(i, "fmi3Set" #type, fmu::any_mode, [&](Instance&) { fmu::require_none(n); });               \
    }
TIRETHERM_NO_VARIABLES(Float32, float)
TIRETHERM_NO_VARIABLES(Int8, std::int8_t)
TIRETHERM_NO_VARIABLES(UInt8, std::uint8_t)
TIRETHERM_NO_VARIABLES(Int16, std::int16_t)
TIRETHERM_NO_VARIABLES(UInt16, std::uint16_t)
TIRETHERM_NO_VARIABLES(Int32, std::int32_t)
TIRETHERM_NO_VARIABLES(UInt32, std::uint32_t)
TIRETHERM_NO_VARIABLES(Int64, std::int64_t)
TIRETHERM_NO_VARIABLES(UInt64, std::uint64_t)
TIRETHERM_NO_VARIABLES(Boolean, bool)
TIRETHERM_NO_VARIABLES(String, String)
int fmi3GetBinary(Handle i, const Reference /*which*/[], std::size_t n, std::size_t /*sizes*/[], Binary /*values*/[],
                  std::size_t /*n_values*/) {
    return fmu::call(i, "fmi3GetBinary", fmu::any_mode, [&](Instance&) { fmu::require_none(n); });
}
int fmi3SetBinary(Handle i, const Reference /*which*/[], std::size_t n, const std::size_t /*sizes*/[],
                  const Binary /*values*/[], std::size_t /*n_values*/) {
    return fmu::call(i, "fmi3SetBinary", fmu::any_mode, [&](Instance&) { fmu::require_none(n); });
}

Handle fmi3InstantiateModelExchange(String, String, String, bool, bool, Environment environment, LogMessage log) {
    return refuse_kind(environment, log);
}
Handle fmi3InstantiateScheduledExecution(String, String, String, bool, bool, Environment environment, LogMessage log,
                                         void (*)(Environment), void (*)(), void (*)()) {
    return refuse_kind(environment, log);
}

// Event mode, configuration mode, dependencies of elements, other derivatives, clocks, other kinds of FMU.
#define TIRETHERM_UNSUPPORTED(name, ...) \
    int name(Handle i __VA_OPT__(, ) __VA_ARGS__) { return fmu::unsupported(i, #name); }
using References = const Reference*;
using Count = std::size_t;
using Reals = double*;
TIRETHERM_UNSUPPORTED(fmi3EnterEventMode, bool, bool, const std::int32_t*, Count, bool)
TIRETHERM_UNSUPPORTED(fmi3EnterStepMode)
TIRETHERM_UNSUPPORTED(fmi3EnterConfigurationMode)
TIRETHERM_UNSUPPORTED(fmi3ExitConfigurationMode)
TIRETHERM_UNSUPPORTED(fmi3EvaluateDiscreteStates)
TIRETHERM_UNSUPPORTED(fmi3UpdateDiscreteStates, bool*, bool*, bool*, bool*, bool*, Reals)
TIRETHERM_UNSUPPORTED(fmi3GetNumberOfVariableDependencies, Reference, Count*)
TIRETHERM_UNSUPPORTED(fmi3GetVariableDependencies, Reference, Count*, Reference*, Count*, int*, Count)
TIRETHERM_UNSUPPORTED(fmi3GetAdjointDerivative, References, Count, References, Count, const double*, Count, Reals,
                      Count)
TIRETHERM_UNSUPPORTED(fmi3GetOutputDerivatives, References, Count, const std::int32_t*, Reals, Count)
TIRETHERM_UNSUPPORTED(fmi3GetClock, References, Count, bool*)
TIRETHERM_UNSUPPORTED(fmi3SetClock, References, Count, const bool*)
TIRETHERM_UNSUPPORTED(fmi3GetIntervalDecimal, References, Count, Reals, int*)
TIRETHERM_UNSUPPORTED(fmi3GetIntervalFraction, References, Count, std::uint64_t*, std::uint64_t*, int*)
TIRETHERM_UNSUPPORTED(fmi3GetShiftDecimal, References, Count, Reals)
TIRETHERM_UNSUPPORTED(fmi3GetShiftFraction, References, Count, std::uint64_t*, std::uint64_t*)
TIRETHERM_UNSUPPORTED(fmi3SetIntervalDecimal, References, Count, const double*)
TIRETHERM_UNSUPPORTED(fmi3SetIntervalFraction, References, Count, const std::uint64_t*, const std::uint64_t*)
TIRETHERM_UNSUPPORTED(fmi3SetShiftDecimal, References, Count, const double*)
TIRETHERM_UNSUPPORTED(fmi3SetShiftFraction, References, Count, const std::uint64_t*, const std::uint64_t*)
TIRETHERM_UNSUPPORTED(fmi3ActivateModelPartition, Reference, double)
TIRETHERM_UNSUPPORTED(fmi3EnterContinuousTimeMode)
TIRETHERM_UNSUPPORTED(fmi3CompletedIntegratorStep, bool, bool*, bool*)
TIRETHERM_UNSUPPORTED(fmi3SetTime, double)
TIRETHERM_UNSUPPORTED(fmi3SetContinuousStates, const double*, Count)
TIRETHERM_UNSUPPORTED(fmi3GetContinuousStateDerivatives, Reals, Count)
TIRETHERM_UNSUPPORTED(fmi3GetEventIndicators, Reals, Count)
TIRETHERM_UNSUPPORTED(fmi3GetContinuousStates, Reals, Count)
TIRETHERM_UNSUPPORTED(fmi3GetNominalsOfContinuousStates, Reals, Count)
TIRETHERM_UNSUPPORTED(fmi3GetNumberOfEventIndicators, Count*)
TIRETHERM_UNSUPPORTED(fmi3GetNumberOfContinuousStates, Count*)

}  // extern "C"
#pragma GCC visibility pop
