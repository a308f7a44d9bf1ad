// SPDX-License-Identifier: BSD-3-Clause
// Reads the GNU build ID from the ELF notes of the program, or of the module that this code is part of
// (dl_iterate_phdr).

#include "calls/build_identity.hpp"

#include <link.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>

#include <fmt/format.h>

namespace tiretherm::calls {

namespace {

/// The build ID in the notes of a segment; empty where it has none.
std::string build_id(const char* at, const char* end) {
    const auto padded = [](std::size_t length) { return (length + 3) / 4 * 4; };
    while (at + sizeof(ElfW(Nhdr)) <= end) {
        const auto* note = reinterpret_cast<const ElfW(Nhdr)*>(at);
        const char* name = at + sizeof *note;
        const char* bytes = name + padded(note->n_namesz);
        if (note->n_type == NT_GNU_BUILD_ID && std::string_view(name, note->n_namesz) == std::string_view("GNU", 4)) {
            std::string id;
            for (std::size_t b = 0; b < note->n_descsz; ++b) {
                id += fmt::format("{:02x}", static_cast<unsigned char>(bytes[b]));
            }
            return id;
        }
        at = bytes + padded(note->n_descsz);
    }
    return {};
}

/// The notes of the object that holds this code: the program, or the module of another; ends there.
int read_notes(dl_phdr_info* object, std::size_t /*size*/, void* into) {
    const std::span headers(object->dlpi_phdr, object->dlpi_phnum);
    const auto address = reinterpret_cast<ElfW(Addr)>(&read_notes);
    const bool is_ours = std::ranges::any_of(headers, [&](const ElfW(Phdr) & header) {
        const ElfW(Addr) begin = object->dlpi_addr + header.p_vaddr;
        return header.p_type == PT_LOAD && address >= begin && address < begin + header.p_memsz;
    });
    for (const ElfW(Phdr) & header : headers) {
        if (is_ours && header.p_type == PT_NOTE) {
            const char* at = reinterpret_cast<const char*>(object->dlpi_addr + header.p_vaddr);
            *static_cast<std::string*>(into) += build_id(at, at + header.p_memsz);
        }
    }
    return is_ours ? 1 : 0;
}

}  // namespace

std::string build_identity() {
    std::string build;
    dl_iterate_phdr(&read_notes, &build);
    return fmt::format("{} {}", TIRETHERM_VERSION, build.substr(0, 16));
}

}  // namespace tiretherm::calls
