// SPDX-License-Identifier: BSD-3-Clause
// Finds the shared object as the program finds its others, and puts the archive together.

#include "post/fmu/fmu_file.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>

#include "post/fmu/zip_archive.hpp"
#include "post/report/file.hpp"

// The licences go with each FMU; the build says where they are.
asm(".section .rodata\n"
    ".global tiretherm_own_licence, tiretherm_all_licences, tiretherm_licences_end\n"
    "tiretherm_own_licence:\n.incbin \"" TIRETHERM_SOURCE
    "/LICENSE\"\n"
    "tiretherm_all_licences:\n.incbin \"" TIRETHERM_SOURCE
    "/docs/licences.md\"\n"
    "tiretherm_licences_end:\n"
    ".byte 0\n"
    ".previous\n");
extern "C" const char tiretherm_own_licence[];
extern "C" const char tiretherm_all_licences[];
extern "C" const char tiretherm_licences_end[];

namespace tiretherm::post {

namespace {

constexpr const char* shared_object = "tiretherm_fmu.so";

/// The shared object's bytes. It is opened to be found beside the program or where that is installed, and to know that it is sound.
std::string read_shared_object() {
    void* module = dlopen(shared_object, RTLD_NOW | RTLD_LOCAL);
    if (module == nullptr) {
        throw std::runtime_error(fmt::format("the shared object of FMUs cannot be opened: {}", dlerror()));
    }
    const link_map* place = nullptr;
    const bool found = dlinfo(module, RTLD_DI_LINKMAP, &place) == 0;
    const std::string path = found ? place->l_name : "";
    dlclose(module);
    return read_text(path);
}

/// A name in C of the case's name: "tire_4000N_100kmh" of "two_node/4000N_100kmh".
std::string identifier_of(const std::string& name) {
    std::string identifier = name.substr(name.rfind('/') + 1);
    std::ranges::replace_if(
        identifier, [](unsigned char c) { return std::isalnum(c) == 0 || c > 127; }, '_');
    return std::isalpha(static_cast<unsigned char>(identifier.empty() ? '0' : identifier.front())) != 0
               ? identifier
               : "tire_" + identifier;
}

}  // namespace

PackedFmu pack_fmu(const solver::SessionModel& model, const FmuParts& parts) {
    const std::string session = solver::to_bytes(model);
    const solver::Problem& problem = model.problem;
    const double length = problem.settings.end - problem.settings.start;
    PackedFmu packed{.content = {.version = parts.version,
                                 .identifier = identifier_of(problem.name),
                                 .token = solver::token_of(session),
                                 .name = problem.name,
                                 .title = problem.title,
                                 .program = "tiretherm " TIRETHERM_VERSION,
                                 .end = length > 0.0 ? length : 1.0,
                                 .variables = fmu_variables(model)},
                     .bytes = {}};
    const std::string folder = parts.version == FmiVersion::fmi2 ? "linux64" : "x86_64-linux";
    packed.bytes = zip({
        {"modelDescription.xml", model_description(packed.content)},
        {fmt::format("binaries/{}/{}.so", folder, packed.content.identifier), read_shared_object()},
        {"resources/session.bin", session},
        {"resources/case.toml", parts.case_text},
        {"documentation/index.html", fmu_page(packed.content)},
        {"documentation/licenses/license.txt", {tiretherm_own_licence, tiretherm_all_licences}},
        {"documentation/licenses/libraries.md", {tiretherm_all_licences, tiretherm_licences_end}},
    });
    return packed;
}

}  // namespace tiretherm::post
