// SPDX-License-Identifier: BSD-3-Clause
// An importer of FMUs, for tests: unpacks one, opens its shared object and finds the functions, declared here anew from the text of
// the standard.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <dlfcn.h>

#include "input/runs/reader.hpp"
#include "post/fmu/fmu_file.hpp"
#include "post/report/file.hpp"
#include "tests/post/scratch.hpp"

namespace tiretherm::sample {

inline post::PackedFmu packed_fmu(const std::string& case_file, post::FmiVersion version) {
    const input::Reading reading = input::read_case_run(case_file, "");
    const input::RunOfCase& run = reading.chosen.at(0);
    return post::pack_fmu(solver::session_model(run.problem, run.parameters),
                          {.version = version, .case_text = "# the case\n"});
}

/// An FMU in a folder of its own, as an importer unpacks it, with its shared object opened.
class UnpackedFmu {
public:
    UnpackedFmu(const std::string& case_file, post::FmiVersion version) : packed(packed_fmu(case_file, version)) {
        post::replace_file(folder / "it.fmu", packed.bytes);
        const std::string call =
            "python3 -m zipfile -e '" + (folder / "it.fmu").string() + "' '" + folder.path().string() + "'";
        if (std::system(call.c_str()) != 0) {
            throw std::runtime_error(call);
        }
        const std::string place = version == post::FmiVersion::fmi2 ? "linux64" : "x86_64-linux";
        const std::filesystem::path path = folder / "binaries" / place / (packed.content.identifier + ".so");
        library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (library == nullptr) {
            throw std::runtime_error(dlerror());
        }
    }
    UnpackedFmu(const UnpackedFmu&) = delete;
    UnpackedFmu& operator=(const UnpackedFmu&) = delete;
    ~UnpackedFmu() { dlclose(library); }

    template <typename Function>
    [[nodiscard]] Function* find(const char* name) const {
        void* address = dlsym(library, name);
        if (address == nullptr) {
            throw std::runtime_error(std::string("it does not export ") + name);
        }
        return reinterpret_cast<Function*>(address);
    }
    /// Of a variable. 0 where there is none
    [[nodiscard]] unsigned number(const std::string& name) const {
        for (std::size_t i = 0; i < packed.content.variables.size(); ++i) {
            if (packed.content.variables[i].name == name) {
                return static_cast<unsigned>(i) + 1;
            }
        }
        return 0;
    }
    [[nodiscard]] std::vector<unsigned> outputs() const {
        std::vector<unsigned> numbers;
        for (std::size_t i = 0; i < packed.content.variables.size(); ++i) {
            if (packed.content.variables[i].role == post::FmuVariable::Role::output) {
                numbers.push_back(static_cast<unsigned>(i) + 1);
            }
        }
        return numbers;
    }

    post::PackedFmu packed;
    Scratch folder{};
    void* library = nullptr;
};

/// A message that an instance has logged.
struct LoggedMessage {
    int status = 0;
    std::string category;
    std::string text;
};
using Log = std::vector<LoggedMessage>;

enum FmiStatus : int { ok = 0, discard = 2, error = 3 };

/// FMI 2.0.
struct Fmi2 {
    struct Callbacks {
        void (*logger)(void*, const char*, int, const char*, const char*, ...);
        void* (*allocate)(std::size_t, std::size_t);
        void (*free)(void*);
        void (*finished)(void*, int);
        void* environment;
    };
    explicit Fmi2(const UnpackedFmu& from)
        : fmu(from),
          instantiate(fmu.find<void*(const char*, int, const char*, const char*, const Callbacks*, int, int)>(
              "fmi2Instantiate")),
          free_instance(fmu.find<void(void*)>("fmi2FreeInstance")),
          set_up(fmu.find<int(void*, int, double, double, int, double)>("fmi2SetupExperiment")),
          enter(fmu.find<int(void*)>("fmi2EnterInitializationMode")),
          exit(fmu.find<int(void*)>("fmi2ExitInitializationMode")),
          terminate(fmu.find<int(void*)>("fmi2Terminate")),
          reset(fmu.find<int(void*)>("fmi2Reset")),
          get_real(fmu.find<int(void*, const unsigned*, std::size_t, double*)>("fmi2GetReal")),
          set_real(fmu.find<int(void*, const unsigned*, std::size_t, const double*)>("fmi2SetReal")),
          do_step(fmu.find<int(void*, double, double, int)>("fmi2DoStep")),
          get_state(fmu.find<int(void*, void**)>("fmi2GetFMUstate")),
          set_state(fmu.find<int(void*, void*)>("fmi2SetFMUstate")),
          free_state(fmu.find<int(void*, void**)>("fmi2FreeFMUstate")),
          state_size(fmu.find<int(void*, void*, std::size_t*)>("fmi2SerializedFMUstateSize")),
          serialise(fmu.find<int(void*, void*, char*, std::size_t)>("fmi2SerializeFMUstate")),
          deserialise(fmu.find<int(void*, const char*, std::size_t, void**)>("fmi2DeSerializeFMUstate")) {}

    static void take(void* into, const char*, int status, const char* category, const char* text, ...) {
        static_cast<Log*>(into)->push_back({status, category, text});
    }
    /// As most importers do it. @returns null when it is refused
    void* make(const std::string& name, bool logging = true) {
        callbacks.environment = &log;
        callbacks.logger = take;
        const std::string uri = "file://" + (fmu.folder / "resources").string();
        return instantiate(name.c_str(), 1, fmu.packed.content.token.c_str(), uri.c_str(), &callbacks, 0,
                           logging ? 1 : 0);
    }
    /// Up to the first step.
    void* start(const std::string& name) {
        void* it = make(name);
        if (it == nullptr || set_up(it, 0, 0.0, 0.0, 0, 0.0) != ok || enter(it) != ok || exit(it) != ok) {
            throw std::runtime_error("it does not start");
        }
        return it;
    }
    double value(void* it, unsigned number) const {
        double value = 0.0;
        return get_real(it, &number, 1, &value) == ok ? value : -1.0;
    }
    int set(void* it, unsigned number, double value) const { return set_real(it, &number, 1, &value); }

    const UnpackedFmu& fmu;
    Callbacks callbacks{};
    Log log{};
    void* (*instantiate)(const char*, int, const char*, const char*, const Callbacks*, int, int);
    void (*free_instance)(void*);
    int (*set_up)(void*, int, double, double, int, double);
    int (*enter)(void*);
    int (*exit)(void*);
    int (*terminate)(void*);
    int (*reset)(void*);
    int (*get_real)(void*, const unsigned*, std::size_t, double*);
    int (*set_real)(void*, const unsigned*, std::size_t, const double*);
    int (*do_step)(void*, double, double, int);
    int (*get_state)(void*, void**);
    int (*set_state)(void*, void*);
    int (*free_state)(void*, void**);
    int (*state_size)(void*, void*, std::size_t*);
    int (*serialise)(void*, void*, char*, std::size_t);
    int (*deserialise)(void*, const char*, std::size_t, void**);
};

/// FMI 3.0.
struct Fmi3 {
    using LogMessage = void (*)(void*, int, const char*, const char*);
    explicit Fmi3(const UnpackedFmu& from)
        : fmu(from),
          instantiate(fmu.find<void*(const char*, const char*, const char*, bool, bool, bool, bool, const unsigned*,
                                     std::size_t, void*, LogMessage, void*)>("fmi3InstantiateCoSimulation")),
          free_instance(fmu.find<void(void*)>("fmi3FreeInstance")),
          enter(fmu.find<int(void*, bool, double, double, bool, double)>("fmi3EnterInitializationMode")),
          exit(fmu.find<int(void*)>("fmi3ExitInitializationMode")),
          terminate(fmu.find<int(void*)>("fmi3Terminate")),
          reset(fmu.find<int(void*)>("fmi3Reset")),
          get(fmu.find<int(void*, const unsigned*, std::size_t, double*, std::size_t)>("fmi3GetFloat64")),
          set(fmu.find<int(void*, const unsigned*, std::size_t, const double*, std::size_t)>("fmi3SetFloat64")),
          do_step(fmu.find<int(void*, double, double, bool, bool*, bool*, bool*, double*)>("fmi3DoStep")) {}

    void* make(const std::string& name, bool event_mode = false) {
        return instantiate(
            name.c_str(), fmu.packed.content.token.c_str(), (fmu.folder / "resources/").c_str(), false, true,
            event_mode, false, nullptr, 0, &log,
            [](void* into, int status, const char* category, const char* text) {
                static_cast<Log*>(into)->push_back({status, category, text});
            },
            nullptr);
    }
    double value(void* it, unsigned number) const {
        double value = 0.0;
        return get(it, &number, 1, &value, 1) == ok ? value : -1.0;
    }
    int set_one(void* it, unsigned number, double value) const { return set(it, &number, 1, &value, 1); }
    struct Step {
        int status = 0;
        bool event = true;
        bool terminate = true;
        bool early = true;
        double last = -1.0;
    };
    Step step(void* it, double point, double size) const {
        Step done;
        done.status = do_step(it, point, size, true, &done.event, &done.terminate, &done.early, &done.last);
        return done;
    }

    const UnpackedFmu& fmu;
    Log log{};
    void* (*instantiate)(const char*, const char*, const char*, bool, bool, bool, bool, const unsigned*, std::size_t,
                         void*, LogMessage, void*);
    void (*free_instance)(void*);
    int (*enter)(void*, bool, double, double, bool, double);
    int (*exit)(void*);
    int (*terminate)(void*);
    int (*reset)(void*);
    int (*get)(void*, const unsigned*, std::size_t, double*, std::size_t);
    int (*set)(void*, const unsigned*, std::size_t, const double*, std::size_t);
    int (*do_step)(void*, double, double, bool, bool*, bool*, bool*, double*);
};

inline std::string library_case(const std::string& name) { return TIRETHERM_SOURCE_DIR "/cases/" + name + ".toml"; }
inline const std::string tires = library_case("two_node/4000N_100kmh");

/// A case with two parameters, of which one is an initial temperature.
inline std::string with_parameters(const sample::Scratch& scratch) {
    post::replace_file(scratch / "parameters.toml",
                       "include = \"" + tires +
                           "\"\n[[parameter]]\neffect = \"air_convection\"\nkey = \"lambda_h\"\nlow = 0.1\nhigh = 10\n"
                           "[[parameter]]\ninitial = \"temperature\"\n");
    return (scratch / "parameters.toml").string();
}

/// Instances that are freed at the end.
struct Instances {
    explicit Instances(Fmi2& of) : fmi(of) {}
    ~Instances() {
        for (void* it : all) {
            fmi.free_instance(it);
        }
    }
    void* start(const std::string& name) { return all.emplace_back(fmi.start(name)); }
    Fmi2& fmi;
    std::vector<void*> all{};
};

}  // namespace tiretherm::sample
