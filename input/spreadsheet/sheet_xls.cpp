// SPDX-License-Identifier: BSD-3-Clause
// Reads Excel 97 to 2003 workbooks (BIFF) with FreeXL, in a process of its own: FreeXL 1.0.6 reads beside its buffers
// where a file is damaged. The only file that includes it.

#include <cstring>
#include <memory>

#include <fmt/format.h>
#include <freexl.h>

#include "input/spreadsheet/sheet_formats.hpp"
#include "input/tables/own_process.hpp"

namespace tiretherm::input {

namespace {

struct ClosedBook {
    void operator()(const void* book) const { freexl_close(book); }
};

/// More than any sheet of parameters has; a broken file may claim a table of millions.
constexpr unsigned most_xls_rows = 10'000;
constexpr unsigned short most_xls_columns = 256;

std::string text_of(const FreeXL_CellValue& cell) {
    switch (cell.type) {
        case FREEXL_CELL_INT:
            return cell_text(cell.value.int_value);
        case FREEXL_CELL_DOUBLE:
            return cell_text(cell.value.double_value);
        case FREEXL_CELL_TEXT:
        case FREEXL_CELL_SST_TEXT:
        case FREEXL_CELL_DATE:
        case FREEXL_CELL_DATETIME:
        case FREEXL_CELL_TIME:
            return cell.value.text_value != nullptr ? cell.value.text_value : "";
        default:
            return {};
    }
}

std::optional<RawSheet> read_worksheet(const void* book, unsigned short number) {
    const char* name = nullptr;
    unsigned rows = 0;
    unsigned short columns = 0;
    if (freexl_get_worksheet_name(book, number, &name) != FREEXL_OK || name == nullptr ||
        freexl_select_active_worksheet(book, number) != FREEXL_OK ||
        freexl_worksheet_dimensions(book, &rows, &columns) != FREEXL_OK) {
        return std::nullopt;
    }
    RawSheet sheet{.name = name, .rows = {}};
    for (unsigned r = 0; r < std::min(rows, most_xls_rows); ++r) {
        std::vector<std::string>& row = sheet.rows.emplace_back();
        for (unsigned short c = 0; c < std::min(columns, most_xls_columns); ++c) {
            FreeXL_CellValue cell{};
            row.push_back(freexl_get_cell_value(book, r, c, &cell) == FREEXL_OK ? text_of(cell) : std::string());
        }
    }
    return sheet;
}

RawBook broken(std::string_view why, std::string remedy = "save it anew, as .xls or .xlsx") {
    return {.sheets = {}, .error = ErrorText{fmt::format("the .xls workbook {}", why), std::move(remedy)}};
}

RawBook read_here(const std::filesystem::path& path) {
    const void* opened = nullptr;
    const int status = freexl_open(path.c_str(), &opened);
    const std::unique_ptr<const void, ClosedBook> book(opened);
    if (status == FREEXL_BIFF_WORKBOOK_NOT_FOUND || status == FREEXL_BIFF_INVALID_BOF) {
        return broken("is none: the file is another document, or of another program");
    }
    if (status != FREEXL_OK) {
        return broken(fmt::format("is damaged (FreeXL's error {})", status));
    }
    unsigned encrypted = FREEXL_UNKNOWN;
    if (freexl_get_info(book.get(), FREEXL_BIFF_PASSWORD, &encrypted) == FREEXL_OK &&
        encrypted == FREEXL_BIFF_OBFUSCATED) {
        return broken("has a password", "save it without one");
    }
    unsigned sheets = 0;
    if (freexl_get_info(book.get(), FREEXL_BIFF_SHEET_COUNT, &sheets) != FREEXL_OK || sheets == 0) {
        return broken("has no sheets");
    }
    RawBook read;
    read.hides_formulas = true;
    for (unsigned i = 0; i < sheets; ++i) {
        if (std::optional<RawSheet> sheet = read_worksheet(book.get(), static_cast<unsigned short>(i))) {
            read.sheets.push_back(std::move(*sheet));
        } else {
            return broken(fmt::format("is damaged at its sheet {}", i + 1));
        }
    }
    return read;
}

/// Numbers and texts one after the other, each text behind its length: from process to process of one program.
class Parcel {
public:
    void put(std::size_t number) { bytes.append(reinterpret_cast<const char*>(&number), sizeof number); }
    void put(const std::string& text) {
        put(text.size());
        bytes += text;
    }
    [[nodiscard]] std::size_t number() {
        std::size_t number = 0;
        std::memcpy(&number, bytes.data() + at, sizeof number);
        at += sizeof number;
        return number;
    }
    [[nodiscard]] std::string text() {
        const std::size_t size = number();
        at += size;
        return bytes.substr(at - size, size);
    }

    std::string bytes;
    std::size_t at = 0;
};

std::string pack(const RawBook& book) {
    Parcel parcel;
    parcel.put(book.error ? 1 : 0);
    if (book.error) {
        parcel.put(book.error->what);
        parcel.put(book.error->remedy);
        return std::move(parcel.bytes);
    }
    parcel.put(book.sheets.size());
    for (const RawSheet& sheet : book.sheets) {
        parcel.put(sheet.name);
        parcel.put(sheet.rows.size());
        for (const std::vector<std::string>& row : sheet.rows) {
            parcel.put(row.size());
            for (const std::string& cell : row) {
                parcel.put(cell);
            }
        }
    }
    return std::move(parcel.bytes);
}

RawBook unpack(std::string bytes) {
    Parcel parcel;
    parcel.bytes = std::move(bytes);
    RawBook book;
    if (parcel.number() != 0) {
        std::string what = parcel.text();
        book.error = ErrorText{std::move(what), parcel.text()};
        return book;
    }
    book.hides_formulas = true;
    book.sheets.resize(parcel.number());
    for (RawSheet& sheet : book.sheets) {
        sheet.name = parcel.text();
        sheet.rows.resize(parcel.number());
        for (std::vector<std::string>& row : sheet.rows) {
            row.resize(parcel.number());
            for (std::string& cell : row) {
                cell = parcel.text();
            }
        }
    }
    return book;
}

}  // namespace

RawBook read_xls(const std::filesystem::path& path) {
    std::optional<std::string> packed = in_own_process([&] { return pack(read_here(path)); });
    return packed ? unpack(std::move(*packed)) : broken("is damaged");
}

}  // namespace tiretherm::input
