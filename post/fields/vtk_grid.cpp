// SPDX-License-Identifier: BSD-3-Clause
// Opens the module beside the program, or where the program was installed, and keeps it open.

#include "post/fields/vtk_grid.hpp"

#include <stdexcept>

#include <dlfcn.h>
#include <fmt/format.h>

namespace tiretherm::post {

std::unique_ptr<VtkGrid> make_vtk_grid(const VtkGridParts& parts) {
    using Make = VtkGrid* (*)(const VtkGridParts&);
    static const Make make = [] {
        constexpr const char* module = "tiretherm_vtk.so";  // found by the program's run path
        void* library = dlopen(module, RTLD_NOW | RTLD_LOCAL);
        void* symbol = library != nullptr ? dlsym(library, "tiretherm_make_vtk_grid") : nullptr;
        if (symbol == nullptr) {
            throw std::runtime_error(fmt::format(
                "files for ParaView cannot be written: {}; install it again, or leave them out with --no-vtk",
                dlerror()));
        }
        return reinterpret_cast<Make>(symbol);
    }();
    return std::unique_ptr<VtkGrid>(make(parts));
}

}  // namespace tiretherm::post
