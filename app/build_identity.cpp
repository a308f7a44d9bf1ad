// SPDX-License-Identifier: BSD-3-Clause
// Reads the GNU build ID from the ELF notes of the running program (dl_iterate_phdr).

#include "app/build_identity.hpp"

#include <link.h>

#include <cstddef>
#include <string_view>

#include <fmt/format.h>

namespace tiretherm::app {

namespace {

/// The notes of the program itself, which is the first object that the loader knows; ends there.
int read_notes(dl_phdr_info* object, std::size_t /*size*/, void* into) {
    for (int i = 0; i < object->dlpi_phnum; ++i) {
        const ElfW(Phdr)& header = object->dlpi_phdr[i];
        if (header.p_type != PT_NOTE) {
            continue;
        }
        const auto padded = [](std::size_t length) { return (length + 3) / 4 * 4; };
        const char* at = reinterpret_cast<const char*>(object->dlpi_addr + header.p_vaddr);
        const char* end = at + header.p_memsz;
        while (at + sizeof(ElfW(Nhdr)) <= end) {
            const auto* note = reinterpret_cast<const ElfW(Nhdr)*>(at);
            const char* name = at + sizeof *note;
            const char* bytes = name + padded(note->n_namesz);
            if (note->n_type == NT_GNU_BUILD_ID &&
                std::string_view(name, note->n_namesz) == std::string_view("GNU", 4)) {
                for (std::size_t b = 0; b < note->n_descsz; ++b) {
                    *static_cast<std::string*>(into) += fmt::format("{:02x}", static_cast<unsigned char>(bytes[b]));
                }
                return 1;
            }
            at = bytes + padded(note->n_descsz);
        }
    }
    return 1;
}

}  // namespace

std::string build_identity() {
    std::string build;
    dl_iterate_phdr(&read_notes, &build);
    return fmt::format("{} {}", TIRETHERM_VERSION, build.substr(0, 16));
}

}  // namespace tiretherm::app
