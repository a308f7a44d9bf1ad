// SPDX-License-Identifier: BSD-3-Clause
// Entry of libFuzzer: TIRETHERM_FUZZ_TARGET says which target takes the bytes. Started by `./test fuzz`.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>

#include "fuzz/targets.hpp"

namespace {

const tiretherm::fuzz::Target* target = nullptr;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
    const char* name = std::getenv("TIRETHERM_FUZZ_TARGET");
    target = name != nullptr ? tiretherm::fuzz::find_target(name) : nullptr;
    if (target == nullptr) {
        std::fputs("TIRETHERM_FUZZ_TARGET names no target; there are\n", stderr);
        for (const tiretherm::fuzz::Target& one : tiretherm::fuzz::targets()) {
            std::fprintf(stderr, "    %.*s\n", static_cast<int>(one.name.size()), one.name.data());
        }
        std::exit(2);
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        static_cast<void>(target->take({reinterpret_cast<const char*>(data), size}));
    } catch (const std::exception& broken) {
        std::fprintf(stderr, "broken promise: %s\n", broken.what());
        std::abort();
    }
    return 0;
}
