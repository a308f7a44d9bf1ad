// SPDX-License-Identifier: BSD-3-Clause
// Wrong spreadsheets: every error with its cell and remedy, all reported at once.

#include <gtest/gtest.h>

#include "input/model/expected.hpp"
#include "input/spreadsheet/sheet_book.hpp"
#include "input/spreadsheet/sheets.hpp"

// Wrong sheets: everything that is wrong at once, each with its place and what to do.
namespace tiretherm::input {

namespace {

std::string rendered(const sheets::Texts& texts) {
    const SheetCase made = sheets::convert(texts);
    EXPECT_TRUE(made.text.empty());
    return sheets::report(made);
}

void expect_reported(const std::string& report, std::string_view sentence) {
    EXPECT_NE(report.find(sentence), std::string::npos) << sentence << "\nin\n" << report;
}

std::filesystem::path example(const std::string& ending) {
    return source_folder() / "cases" / "convert" / ("thesis_225_50_R17" + ending);
}

}  // namespace

TEST(SheetBad, AllErrorsAreReportedAtOnceWithTheirPlaces) {
    sheets::Texts texts = sheets::complete();
    texts["PARA"] += "Surface Mass,-1,kg\n";
    sheets::replace(texts["PARA"], "Hc,450,[W/m2K]", "Hc,450,[W/m]");
    sheets::replace(texts["PARA"], "Unloaded Radius,0.317,m", "Unloaded Radius,-0.317,m");
    sheets::replace(texts["PARA"], "Tread Thickness,13,mm", "Tread Thickness,13,");
    sheets::replace(texts["SEL"], "C1,-8.8", "C1,minus nine");
    sheets::replace(texts["SEL"], "Reference Frequency", "Referense Frequency");
    texts["INFO"] += "Road Temperature,25,degC\n";
    texts["SF"] = "";
    sheets::replace(texts["SWITCH"], "Air-Tire Exchange,OFF", "Air-Tire Exchange,perhaps");
    texts["Radus"] = texts["Radius"];
    texts.erase("Radius");
    const std::string report = rendered(texts);
    expect_reported(report, "INFO.csv:10:1: Track Temperature stands twice, here as \"Road Temperature\", first at ");
    expect_reported(report, "PARA.csv:14:17: Tread Thickness has no unit\n");
    expect_reported(report, "    remedy: write mm\n");
    expect_reported(report,
                    "PARA.csv:15:17: Unloaded Radius is \"-0.317 m\"; it must be between 0.01 m and 5 m\n"
                    "    Unloaded Radius,-0.317,m\n                    ^~~~~~\n");
    expect_reported(report, ": Hc is in \"W/m\", a quantity in m.kg.s-3; a heat transfer coefficient is wanted\n");
    expect_reported(report, ": Surface Mass is -1; it must be above 0\n");
    expect_reported(report, ": SEL has no parameter \"Referense Frequency\"\n");
    expect_reported(report, "    remedy: did you mean `Reference Frequency`?\n");
    expect_reported(report, ": C1 is \"minus nine\"; a number is wanted\n");
    expect_reported(report, "SF.csv: the file is empty\n");
    expect_reported(report, ": Switch on/off Air-Tire Exchange is \"perhaps\"\n");
    expect_reported(report, "tire: there is no sheet Radius.csv\n    remedy: rename Radus.csv?\n");
    EXPECT_EQ(sheets::convert(texts).errors.size(), 10U) << report;
}

// Made of tests/input/data/wrong_sheets by cases/convert/make_workbooks. C2 is a formula, =100+1.6: its value stands in the
// .xlsx; of the .xls FreeXL gives an empty cell, which must not pass for a parameter that is left out.
TEST(SheetBad, WorkbookIsToldByItsCells) {
    for (const std::string ending : {".xls", ".xlsx"}) {
        const std::string file = "wrong_sheets" + ending;
        const SheetCase made = convert_sheet(source_folder() / "tests" / "input" / "data" / file);
        EXPECT_TRUE(made.text.empty());
        const std::string report = sheets::report(made);
        expect_reported(report,
                        file +
                            ", INFO!A10: Air Temperature stands twice, first at INFO!A7\n"
                            "    remedy: remove one of them\n" +
                            file + ", PARA!B3: Unloaded Radius is \"-0.3308 m\"; it must be between 0.01 m and 5 m\n" +
                            file +
                            ", PARA!C9: Hc is in \"W/m\", a quantity in m.kg.s-3; a heat transfer coefficient is "
                            "wanted\n    remedy: write W/m2K\n" +
                            file +
                            ", SEL!A4: SEL has no parameter \"Referense Frequency\"\n"
                            "    remedy: did you mean `Reference Frequency`?\n" +
                            file + ", SEL!B8: C1 is \"abc\"; a number is wanted\n");
        expect_reported(report, file + ", ContactPatch!B9: Contact Length is \"9x6\"; a number is wanted\n");
        const bool formula = report.find(", SEL!A9: the value of C2 is empty or a formula") != std::string::npos;
        EXPECT_EQ(formula, ending == ".xls") << report;
        EXPECT_EQ(made.errors.size(), formula ? 7U : 6U) << report;
    }
    // Columns beyond Z have two letters.
    const SheetBook book{.shown = "tire.xls", .is_folder = false, .sheets = {}};
    const std::vector<InputError> named = with_cells(
        {{.file = "tire.xls, SEL", .line = 1, .column = 28, .length = 1, .what = "wrong", .remedy = "", .source = ""}},
        book);
    EXPECT_EQ(render(named[0]), "tire.xls, SEL!AB1: wrong\n");
}

TEST(SheetBad, WorkbookThatWasCutShortIsDamaged) {
    const Written written;
    for (const std::string ending : {".xls", ".xlsx"}) {
        const std::string bytes = expected::text_of(example(ending));
        const SheetCase cut = convert_sheet(written.add("cut" + ending, bytes.substr(0, 5000)));
        ASSERT_EQ(cut.errors.size(), 1U);
        EXPECT_NE(cut.errors[0].what.find(ending + " workbook is damaged"), std::string::npos) << cut.errors[0].what;
    }
}

TEST(SheetBad, WhatIsNoSpreadsheetIsRefused) {
    const Written written;
    std::filesystem::create_directory(written.folder() / "nothing");
    const auto what = [](const std::filesystem::path& path) {
        const SheetCase made = convert_sheet(path);
        EXPECT_TRUE(made.text.empty());
        return made.errors.empty() ? "" : made.errors[0].what;
    };
    EXPECT_EQ(what(written.add("text.xls", "no workbook")), "the file is not a spreadsheet");
    EXPECT_EQ(what(written.add("empty.xlsx", "")), "the file is empty");
    EXPECT_EQ(what(written.add("SEL.csv", "C1,1\n")), "a single CSV file is not the whole spreadsheet");
    EXPECT_EQ(what(written.folder() / "absent.xls"), "the file cannot be read: No such file or directory");
    EXPECT_EQ(what(written.folder() / "nothing"), "there is no CSV file in the folder");
    // An archive without anything in it: the end of the central directory alone.
    EXPECT_EQ(what(written.add("archive.xlsx", std::string("PK\x05\x06", 4) + std::string(18, '\0'))),
              "the file is a ZIP archive, but not an .xlsx workbook");
    const SheetCase strange = sheets::convert({{"prices", "bread,3\n"}});
    ASSERT_EQ(strange.errors.size(), 1U);
    EXPECT_EQ(strange.errors[0].what, "none of the ten sheets is there; there is prices");
}

TEST(SheetBad, ParameterInTheWrongSheetIsSentToItsOwn) {
    sheets::Texts texts = sheets::complete();
    texts["SEL"] += "Tire Rubber Density,1100,kg/m3\n";
    const std::string report = rendered(texts);
    expect_reported(report, "SEL has no parameter \"Tire Rubber Density\"");
    expect_reported(report, "remedy: it belongs into the sheet PARA\n");
}

TEST(SheetBad, DecimalCommasAreRefusedWithAHint) {
    sheets::Texts texts = sheets::complete();
    texts["SEL"] = "Parameter;Value;Units\nC1;-8,86;[-]\n";
    const std::string report = rendered(texts);
    expect_reported(report, "SEL.csv:2:4: C1 is \"-8,86\", with a comma in the number\n");
    expect_reported(report, "remedy: write a decimal point\n");
}

TEST(SheetBad, WrongTablesAreToldByTheirCells) {
    sheets::Texts texts = sheets::complete();
    sheets::drop(texts["Radius"], "Loaded");
    texts["Radius"] += "\nVertical Load [N],Loaded Radius [m],Speed [km/h]\n4000,0.30,80\n2000,x,80\n3000,0.31,80\n";
    sheets::drop(texts["ContactPatch"], "Contact Length");
    texts["ContactPatch"] += "\nVertical Load [N],Contact Length [kg]\n2000,55\n";
    const std::string report = rendered(texts);
    expect_reported(report, "Radius.csv:6:37: Radius has no column \"Speed\"\n");
    expect_reported(report, "Radius.csv:8:6: Loaded Radius is \"x\"; a number is wanted\n");
    expect_reported(report, "Radius.csv:9:6: Loaded Radius: load must ascend from row to row\n");
    expect_reported(report, "ContactPatch.csv:6:19: Contact Length is in \"kg\", a mass; a length is wanted\n");
}

TEST(SheetBad, SizeHasNoDefault) {
    sheets::Texts texts = sheets::complete();
    sheets::drop(texts["INFO"], "Size");
    EXPECT_EQ(rendered(texts), "INFO.csv: the sheet has no Size\n    remedy: add a row: Size, 225/50 R17\n");
}

TEST(SheetBad, LawNeedsItsConstantTerm) {
    sheets::Texts texts = sheets::complete();
    sheets::drop(texts["THRCOND"], "Thermal Conductivity coeff. C");
    expect_reported(rendered(texts), "THRCOND.csv:4:1: Thermal Conductivity coeff. A is given without coeff. C\n");
    sheets::Texts cold = sheets::complete();
    sheets::replace(cold["THRCOND"], "0.12,W/mK\n", "-0.3,W/mK\n");
    expect_reported(rendered(cold),
                    "THRCOND.csv:6:31: the law of THRCOND: value is \"-0.3 W/mK\"; it must be above 0 W/mK");
}

TEST(SheetBad, SheetOfAnotherNameIsWarnedOf) {
    sheets::Texts texts = sheets::switched_on();
    texts["Plots"] = "a,b\n";
    const SheetCase made = sheets::convert(texts);
    EXPECT_TRUE(made.errors.empty()) << sheets::report(made);
    ASSERT_EQ(made.warnings.size(), 1U);
    EXPECT_NE(made.warnings[0].find("the sheet Plots is none of the ten and is not read"), std::string::npos);
}

// An archive of one part that claims to unpack to 3 GB: a record of the part and a directory that lists it, by hand after
// the ZIP specification (APPNOTE 6.3, 4.3.7 to 4.3.16). It is not damaged, it is too large.
TEST(SheetBad, APartThatUnpacksToGigabytesIsCalledTooLarge) {
    const auto number = [](std::uint64_t value, int bytes) {
        std::string text;
        for (int i = 0; i < bytes; ++i) {
            text += static_cast<char>(value >> (8 * i) & 0xFFU);
        }
        return text;
    };
    const std::string name = "xl/workbook.xml";
    const std::string local = "PK\3\4" + number(20, 2) + number(0, 2) + number(8, 2) + number(0, 4) + number(0, 4) +
                              number(2, 4) + number(3'000'000'000, 4) + number(name.size(), 2) + number(0, 2) + name +
                              "\3" + std::string(1, '\0');
    const std::string entry = "PK\1\2" + number(20, 2) + number(20, 2) + number(0, 2) + number(8, 2) + number(0, 4) +
                              number(0, 4) + number(2, 4) + number(3'000'000'000, 4) + number(name.size(), 2) +
                              number(0, 2) + number(0, 2) + number(0, 2) + number(0, 2) + number(0, 4) + number(0, 4) +
                              name;
    const std::string end = "PK\5\6" + number(0, 4) + number(1, 2) + number(1, 2) + number(entry.size(), 4) +
                            number(local.size(), 4) + number(0, 2);
    const Written written;
    InputErrors errors;
    EXPECT_FALSE(read_sheet_book(written.add("bomb.xlsx", local + entry + end), errors));
    ASSERT_EQ(errors.in_order().size(), 1U);
    EXPECT_EQ(errors.in_order().front().what,
              "the workbook's part xl/workbook.xml is too large: it has 2.79 GB, and at most 64 MB are read");
    EXPECT_EQ(errors.in_order().front().remedy, "save a workbook with the sheets of the parameters alone");
}

}  // namespace tiretherm::input
