// SPDX-License-Identifier: BSD-3-Clause
// The functions of FMI 2.0 for co-simulation, declared as the standard gives them: names, arguments and numbers of its statuses.

#include <array>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <string>

#include "interface/fmu/call.hpp"

namespace fmu = tiretherm::fmu;
using fmu::Instance;
using fmu::Mode;

namespace {

using Real = double;
using Integer = int;
using Boolean = int;
using String = const char*;
using Reference = unsigned int;
using Component = void*;

enum StatusKind : int { do_step_status, pending_status, last_successful_time, is_terminated };
constexpr int co_simulation = 1;

/// What the environment gives an instance to call.
struct CallbackFunctions {
    void (*logger)(void* environment, String instance, int status, String category, String message, ...);
    void* (*allocate_memory)(std::size_t count, std::size_t size);
    void (*free_memory)(void* memory);
    void (*step_finished)(void* environment, int status);
    void* environment;
};

/// The folder of "file:///tmp/fmu/resources": characters after a percent sign are written as two hexadecimal digits.
std::filesystem::path folder_of(std::string_view uri) {
    for (const std::string_view scheme : {"file://localhost/", "file:///", "file:/"}) {
        if (uri.starts_with(scheme)) {
            uri.remove_prefix(scheme.size() - 1);
            break;
        }
    }
    const auto digit = [](char c) {
        const std::string_view digits = "0123456789abcdef";
        return digits.find(c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c);
    };
    std::string path;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool coded = uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) < 16 && digit(uri[i + 2]) < 16;
        path += coded ? static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2])) : uri[i];
        i += coded ? 2 : 0;
    }
    return path;
}

/// Instances log under their names. The message is a format of printf.
fmu::Logger logger_of(String name, const CallbackFunctions& functions) {
    if (functions.logger == nullptr) {
        return {};
    }
    return [name = std::string(name), functions](fmu::Status status, const char* category, const std::string& message) {
        functions.logger(functions.environment, name.c_str(), static_cast<int>(status), category,
                         fmu::doubled(message, '%').c_str());
    };
}

}  // namespace

#pragma GCC visibility push(default)
extern "C" {

const char* fmi2GetTypesPlatform(void) { return "default"; }
const char* fmi2GetVersion(void) { return "2.0"; }

int fmi2SetDebugLogging(Component c, Boolean on, std::size_t n, const String categories[]) {
    return fmu::call(c, "fmi2SetDebugLogging", fmu::any_mode,
                     [&](Instance& it) { it.set_logging(on != 0, fmu::list(categories, n)); });
}

Component fmi2Instantiate(String name, int type, String guid, String resources, const CallbackFunctions* functions,
                          Boolean /*visible*/, Boolean logging) {
    if (functions == nullptr) {
        return nullptr;
    }
    return fmu::instantiate(name, guid, resources, logger_of(name != nullptr ? name : "", *functions), logging != 0,
                            [&] {
                                fmu::require(type == co_simulation, "the FMU is for co-simulation alone");
                                return folder_of(resources);
                            });
}

void fmi2FreeInstance(Component c) { delete static_cast<Instance*>(c); }

int fmi2SetupExperiment(Component c, Boolean /*has_tolerance*/, Real /*tolerance*/, Real start, Boolean has_stop,
                        Real stop) {
    return fmu::call(c, "fmi2SetupExperiment", {Mode::instantiated},
                     [&](Instance& it) { it.set_up(start, has_stop != 0, stop); });
}

int fmi2EnterInitializationMode(Component c) {
    return fmu::call(c, "fmi2EnterInitializationMode", {Mode::instantiated}, [](Instance& it) {
        fmu::require(it.is_set_up(), "fmi2SetupExperiment has to be called before");
        it.enter_initialization();
    });
}

int fmi2ExitInitializationMode(Component c) {
    return fmu::call(c, "fmi2ExitInitializationMode", {Mode::initialization},
                     [](Instance& it) { it.exit_initialization(); });
}

int fmi2Terminate(Component c) {
    return fmu::call(c, "fmi2Terminate", {Mode::step}, [](Instance& it) { it.terminate(); });
}

int fmi2Reset(Component c) {
    return fmu::call(c, "fmi2Reset", fmu::any_mode, [](Instance& it) { it.reset(); });
}

int fmi2GetReal(Component c, const Reference which[], std::size_t n, Real values[]) {
    return fmu::call(c, "fmi2GetReal", {Mode::initialization, Mode::step, Mode::terminated},
                     [&](Instance& it) { it.get(fmu::list(which, n), fmu::list(values, n)); });
}

int fmi2SetReal(Component c, const Reference which[], std::size_t n, const Real values[]) {
    return fmu::call(c, "fmi2SetReal", {Mode::instantiated, Mode::initialization, Mode::step},
                     [&](Instance& it) { it.set(fmu::list(which, n), fmu::list(values, n)); });
}

// All variables are real: of the other types nothing can be got or set.
#define TIRETHERM_NO_VARIABLES(name, Values)                                                 \
    int name(Component c, const Reference /*which*/[], std::size_t n, Values /*values*/) {   \
        return fmu::call(c, #name, fmu::any_mode, [&](Instance&) { fmu::require_none(n); }); \
    }
TIRETHERM_NO_VARIABLES(fmi2GetInteger, Integer*)
TIRETHERM_NO_VARIABLES(fmi2GetBoolean, Boolean*)
TIRETHERM_NO_VARIABLES(fmi2GetString, String*)
TIRETHERM_NO_VARIABLES(fmi2SetInteger, const Integer*)
TIRETHERM_NO_VARIABLES(fmi2SetBoolean, const Boolean*)
TIRETHERM_NO_VARIABLES(fmi2SetString, const String*)

int fmi2GetFMUstate(Component c, void** state) { return fmu::get_state(c, "fmi2GetFMUstate", state); }
int fmi2SetFMUstate(Component c, void* state) { return fmu::set_state(c, "fmi2SetFMUstate", state); }
int fmi2FreeFMUstate(Component c, void** state) { return fmu::free_state(c, "fmi2FreeFMUstate", state); }
int fmi2SerializedFMUstateSize(Component c, void* state, std::size_t* size) {
    return fmu::serialised_size(c, "fmi2SerializedFMUstateSize", state, size);
}
int fmi2SerializeFMUstate(Component c, void* state, char bytes[], std::size_t size) {
    return fmu::serialise(c, "fmi2SerializeFMUstate", state, bytes, size);
}
int fmi2DeSerializeFMUstate(Component c, const char bytes[], std::size_t size, void** state) {
    return fmu::deserialise(c, "fmi2DeSerializeFMUstate", bytes, size, state);
}

int fmi2GetDirectionalDerivative(Component c, const Reference unknowns[], std::size_t n, const Reference knowns[],
                                 std::size_t n_known, const Real seed[], Real sensitivity[]) {
    return fmu::call(c, "fmi2GetDirectionalDerivative", {Mode::initialization, Mode::step, Mode::terminated},
                     [&](Instance& it) {
                         it.derive(fmu::list(unknowns, n), fmu::list(knowns, n_known), fmu::list(seed, n_known),
                                   fmu::list(sensitivity, n));
                     });
}
int fmi2SetRealInputDerivatives(Component c, const Reference /*which*/[], std::size_t /*n*/, const Integer /*order*/[],
                                const Real /*values*/[]) {
    return fmu::unsupported(c, "fmi2SetRealInputDerivatives");
}
int fmi2GetRealOutputDerivatives(Component c, const Reference /*which*/[], std::size_t /*n*/, const Integer /*order*/[],
                                 Real /*values*/[]) {
    return fmu::unsupported(c, "fmi2GetRealOutputDerivatives");
}

int fmi2DoStep(Component c, Real point, Real size, Boolean /*no_set_state_before*/) {
    return fmu::call(c, "fmi2DoStep", {Mode::step}, [&](Instance& it) { it.step(point, size); });
}
int fmi2CancelStep(Component c) { return fmu::unsupported(c, "fmi2CancelStep"); }

// A step is done when the call returns: of its status there is only when it ended.
int fmi2GetRealStatus(Component c, int kind, Real* value) {
    return fmu::call(c, "fmi2GetRealStatus", {Mode::step, Mode::terminated}, [&](Instance& it) {
        fmu::require_status(kind == last_successful_time && value != nullptr);
        *value = it.point();
    });
}
int fmi2GetBooleanStatus(Component c, int kind, Boolean* value) {
    return fmu::call(c, "fmi2GetBooleanStatus", {Mode::step, Mode::terminated}, [&](Instance&) {
        fmu::require_status(kind == is_terminated && value != nullptr);
        *value = 0;
    });
}
int fmi2GetStatus(Component c, int kind, int* value) {
    return fmu::call(c, "fmi2GetStatus", {Mode::step, Mode::terminated}, [&](Instance&) {
        fmu::require_status(kind == do_step_status && value != nullptr);
        *value = 0;
    });
}
int fmi2GetIntegerStatus(Component c, int /*kind*/, Integer* /*value*/) {
    return fmu::call(c, "fmi2GetIntegerStatus", {Mode::step, Mode::terminated},
                     [&](Instance&) { fmu::require_status(false); });
}
int fmi2GetStringStatus(Component c, int /*kind*/, String* /*value*/) {
    return fmu::call(c, "fmi2GetStringStatus", {Mode::step, Mode::terminated},
                     [&](Instance&) { fmu::require_status(false); });
}

}  // extern "C"
#pragma GCC visibility pop
