// SPDX-License-Identifier: BSD-3-Clause
// Logs in other encodings, with other line ends and quotes, and degrees that were written in some way.

#include <array>

#include <gtest/gtest.h>

#include "input/loggers/ld_writer.hpp"
#include "input/loggers/read_back.hpp"
#include "input/text/encoding.hpp"

namespace tiretherm::input {

namespace {

/// Letters of Latin text, each with a zero before or behind it.
std::string as_utf16(std::string_view text, bool low_first, std::string mark = "") {
    for (const char c : text) {
        mark += low_first ? std::string{c, '\0'} : std::string{'\0', c};
    }
    return mark;
}

}  // namespace

// B0 is the sign of degrees in Latin-1, F8 in DOS, A1 on the Macintosh; C2 B0 is UTF-8, C3 82 C2 B0 that of its two bytes taken for letters; BA and
// CB 9A are other signs that look like it, and EF BF BD stands for a lost byte. 50 degC are 323.15 K.
TEST(CsvLog, HasDegreesHoweverTheyAreWritten) {
    for (const char* sign : {"\xB0", "\xBA", "\xF8", "\xA1", "\xC2\xB0", "\xC3\x82\xC2\xB0", "\xC2\xBA", "\xCB\x9A",
                             "\xEF\xBF\xBD", "\xC2\xB0 ", "deg", "deg "}) {
        for (const auto& [open, close] : {std::pair{"(", ")"}, std::pair{"[", "]"}}) {
            const std::string heading = std::string("Tire Temp ") + open + sign + "C" + close;
            ReadBack file("log.csv", "Time [s]," + heading + "\n0,50\n1,51\n");
            EXPECT_EQ(file.column("Tire Temp", "K"), (std::vector<double>{323.15, 324.15})) << heading;
        }
    }
    ReadBack one("log.csv", "Time [s],Tire Temp (\u2103)\n0,50\n");
    EXPECT_EQ(one.column("Tire Temp", "K"), std::vector<double>{323.15});
}

// In a line of units, as AiM writes it, and beside a heading that is UTF-8.
TEST(AimCsv, MayBeInWindowsLetters) {
    ReadBack file("aim.csv",
                  "\"Format\",\"AiM CSV File\"\n\n\"Time\",\"Reifen \xFC\",\"Stra\u00DFe\"\n\"s\",\"\xB0"
                  "C\",\"\xB0/s\"\n\n\"0\",\"50\",\"180\"\n");
    EXPECT_EQ(file.column("Reifen \u00FC", "K"), std::vector<double>{323.15});
    EXPECT_NEAR(file.column("Stra\u00DFe", "rad s-1").at(0), 3.14159265358979, 1e-12);
}

TEST(MotecLd, MayHaveUnitsInLatinLetters) {
    using made_up::integers;
    ReadBack file("session.ld", made_up::LdWriter::file({integers("Reifen \xFC",
                                                                  "\xB0"
                                                                  "C",
                                                                  1, {50, 51})}));
    EXPECT_EQ(file.column("Reifen \u00FC", "K"), (std::vector<double>{323.15, 324.15}));
}

TEST(CsvLog, MayBeUtf16WithAndWithoutAMark) {
    const std::string text = "Time [s];speed [km/h]\r\n0;36\r\n1;72\r\n";
    for (const std::string& bytes : {as_utf16(text, true), as_utf16(text, false), as_utf16(text, true, "\xFF\xFE"),
                                     as_utf16(text, false, "\xFE\xFF")}) {
        ReadBack file("log.csv", bytes);
        EXPECT_EQ(file.column("speed", "m s-1"), (std::vector<double>{10.0, 20.0}));
    }
}

// A pair of surrogates is one letter: U+1F697 is D83D DE97; half of one is none, and is replaced.
TEST(Encoding, OfPairsAndHalvesOfUtf16) {
    EXPECT_EQ(as_utf8(std::string("\xFF\xFE\x3D\xD8\x97\xDE\x20\xAC\x3D\xD8", 10)),
              "\xF0\x9F\x9A\x97\xEA\xB0\xA0\xEF\xBF\xBD");
    EXPECT_EQ(as_utf8("\x80"), "\xE2\x82\xAC");  // the euro of Windows-1252
    EXPECT_EQ(as_utf8("5 \xC2\xB5m \xB5m"), "5 \xC2\xB5m \xC2\xB5m");
}

// A logger that lost its power leaves the room that it had reserved.
TEST(CsvLog, MayEndInZeros) {
    ReadBack file("log.csv", "Time [s],speed [km/h]\n0,36\n1,72\n" + std::string(4096, '\0'));
    EXPECT_EQ(file.column("speed", "m s-1"), (std::vector<double>{10.0, 20.0}));
}

TEST(CsvLog, LinesMayEndWithCarriageReturnsAlone) {
    ReadBack file("log.csv", "# by an old program\rTime [s],speed [km/h]\r0,36\r1,72\r");
    EXPECT_EQ(file.column("speed", "m s-1"), (std::vector<double>{10.0, 20.0}));
}

// A quote within quotes is written twice.
TEST(CsvLog, QuotesMayHaveQuotesWithin) {
    ReadBack file("log.csv",
                  "\"Time [s]\",\"the \"\"fast\"\", one [km/h]\",\"note\"\n\"0\",\"36\",\"he said \"\"go, "
                  "go\"\"\"\n\"1\",\"72\",\"\"\n");
    EXPECT_EQ(file.column("the \"fast\", one", "m s-1"), (std::vector<double>{10.0, 20.0}));
}

}  // namespace tiretherm::input
