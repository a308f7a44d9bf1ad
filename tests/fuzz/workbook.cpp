// SPDX-License-Identifier: BSD-3-Clause
// Replaces a part of a ZIP archive with libzip.

#include "fuzz/workbook.hpp"

#include <zip.h>

#include <fstream>
#include <iterator>
#include <string>

#include "fuzz/promises.hpp"

namespace tiretherm::fuzz {

std::filesystem::path workbook_with_sheet(std::string_view bytes) {
    static const std::string sound = [] {
        std::ifstream file(shipped("convert/thesis_225_50_R17.xlsx"), std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    }();
    std::filesystem::path path = scratch_file("sheet_xml.xlsx", sound);
    zip_t* archive = zip_open(path.c_str(), 0, nullptr);
    promise(archive != nullptr, "the shipped workbook cannot be opened");
    const zip_int64_t at = zip_name_locate(archive, "xl/worksheets/sheet4.xml", 0);
    zip_source_t* source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
    const bool replaced = at >= 0 && source != nullptr &&
                          zip_file_replace(archive, static_cast<zip_uint64_t>(at), source, 0) == 0 &&
                          zip_set_file_compression(archive, static_cast<zip_uint64_t>(at), ZIP_CM_STORE, 0) == 0;
    promise(replaced && zip_close(archive) == 0, "the shipped workbook cannot be changed");
    return path;
}

}  // namespace tiretherm::fuzz
