// SPDX-License-Identifier: BSD-3-Clause
// Opens ZIP archives with libzip for the .xlsx reader; parts above a size limit are refused.

#include <memory>

#include <fmt/format.h>
#include <zip.h>

#include "input/spreadsheet/sheet_formats.hpp"
#include "input/text/regular_file.hpp"

namespace tiretherm::input {

namespace {

struct Discarded {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct ClosedFile {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};

/// A sheet of parameters has kilobytes; what claims to unpack to more than this is none.
constexpr zip_uint64_t largest = 64U << 20U;

/// @param too_much out: the part that is too large, where one is
std::optional<std::string> part(zip_t* archive, const std::string& name, std::optional<ErrorText>& too_much) {
    zip_stat_t about{};
    if (zip_stat(archive, name.c_str(), 0, &about) != 0 || (about.valid & ZIP_STAT_SIZE) == 0) {
        return std::nullopt;
    }
    if (about.size > largest) {
        const ErrorText reason = too_large(about.size, largest);
        too_much = {fmt::format("the workbook's part {} {}", name, reason.what),
                    "save a workbook with the sheets of the parameters alone"};
        return std::nullopt;
    }
    const std::unique_ptr<zip_file_t, ClosedFile> file(zip_fopen(archive, name.c_str(), 0));
    std::string bytes(about.size, '\0');
    if (!file || zip_fread(file.get(), bytes.data(), about.size) != static_cast<zip_int64_t>(about.size)) {
        return std::nullopt;
    }
    return bytes;
}

}  // namespace

std::optional<ErrorText> with_zip(const std::filesystem::path& path,
                                  const std::function<std::optional<ErrorText>(const ZipParts&)>& use) {
    int status = 0;
    const std::unique_ptr<zip_t, Discarded> archive(zip_open(path.c_str(), ZIP_RDONLY, &status));
    if (!archive) {
        zip_error_t error;
        zip_error_init_with_code(&error, status);
        ErrorText reason{fmt::format("the .xlsx workbook is damaged: {}", zip_error_strerror(&error)), "save it anew"};
        zip_error_fini(&error);
        return reason;
    }
    std::optional<ErrorText> too_much;
    std::optional<ErrorText> error = use([&](const std::string& name) { return part(archive.get(), name, too_much); });
    return too_much ? too_much : error;
}

}  // namespace tiretherm::input
