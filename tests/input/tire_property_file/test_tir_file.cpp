// SPDX-License-Identifier: BSD-3-Clause
// Tire property files (.tir): coefficients and dimensions in SI, Magic Formula versions, and all errors at once.

#include "input/tire_property_file/tir_file.hpp"

#include <sstream>

#include <gtest/gtest.h>

#include "support/written.hpp"

namespace tiretherm::input {

namespace {

std::filesystem::path data(const std::string& name) { return source_folder() / "tests" / "input" / "data" / name; }

struct Read {
    std::optional<TirFile> tire;
    std::string report;  ///< all errors, as they are shown
    std::vector<std::string> warnings;
};

Read read(const std::filesystem::path& path) {
    InputErrors errors;
    Read result;
    result.tire = read_tir_file(path, {}, errors);
    for (const InputError& error : errors.in_order()) {
        result.report += render(error);
    }
    result.warnings = render(errors.warnings(), 0);
    return result;
}

Read read_text_as_file(std::string_view text) {
    const Written written;
    return read(written.add("tire.tir", text));
}

/// Necessary keys only. @param model the lines of [MODEL]
std::string shortest(const std::string& model) {
    return "[MODEL]\n" + model +
           "\n[DIMENSION]\nUNLOADED_RADIUS = 0.33\nWIDTH = 0.225\n[VERTICAL]\nFNOMIN = 4000\n"
           "[LONGITUDINAL_COEFFICIENTS]\nPCX1 = 1.6\nPDX1 = 1.1\nPKX1 = 22\n"
           "[LATERAL_COEFFICIENTS]\nPCY1 = 1.3\nPDY1 = 1\nPKY1 = -20\nPKY2 = 2\n";
}

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

/// One warning, and that part is in it.
void expect_warning(const Read& result, std::string_view part) {
    ASSERT_EQ(result.warnings.size(), 1U);
    EXPECT_TRUE(contains(result.warnings[0], part)) << result.warnings[0];
}

}  // namespace

TEST(TirFile, ReadsCoefficientsAndDimensionsInSi) {
    // The file writes millimetres and seconds: 330.8 mm, 225 mm, 16700 mm/s.
    const Read result = read(data("made_up.tir"));
    ASSERT_TRUE(result.tire) << result.report;
    EXPECT_TRUE(result.warnings.empty()) << result.warnings.front();
    EXPECT_DOUBLE_EQ(result.tire->unloaded_radius, 0.3308);
    EXPECT_DOUBLE_EQ(result.tire->width, 0.225);
    ASSERT_TRUE(result.tire->vertical_range);
    EXPECT_DOUBLE_EQ(result.tire->vertical_range->low, 200.0);
    EXPECT_DOUBLE_EQ(result.tire->vertical_range->high, 9000.0);
    const physics::MagicFormula& law = result.tire->law;
    EXPECT_EQ(law.version, physics::MagicFormulaVersion::mf52);
    EXPECT_DOUBLE_EQ(law.nominal_load, 4000.0);
    EXPECT_DOUBLE_EQ(law.reference_speed, 16.7);
    EXPECT_DOUBLE_EQ(law.pCy1, 1.3);
    EXPECT_DOUBLE_EQ(law.pDy2, -0.2);
    EXPECT_DOUBLE_EQ(law.pHy3, 0.03);
    EXPECT_DOUBLE_EQ(law.pKx3, 0.2);
    EXPECT_DOUBLE_EQ(law.lambda.muy, 0.9);
    EXPECT_EQ(law.pEy2, 0.0);
    // -20 * 4000 * sin(2 atan(1/2)) * (1 - 0.5 * 0.1) * 1.05 = -64000 * 0.95 * 1.05 = -63840 N/rad
    EXPECT_NEAR(law.cornering_stiffness(4000.0, 0.1), -63840.0, 1e-8);
}

TEST(TirFile, EverythingThatIsWrongIsToldAtOnce) {
    const Read result = read(data("wrong.tir"));
    EXPECT_FALSE(result.tire);
    for (const std::string_view part :
         {"wrong.tir:4:9: FORCE is 'kilogram', a mass; a force is wanted", "remedy: write a unit, such as 'newton'",
          "wrong.tir:7:10: FITTYP 52 is not supported", "supported are 5, 6 and 21 (MF 5.2), 61 and 62 (MF 6.1)",
          "wrong.tir:8:1: the line is neither [SECTION] nor KEY = value nor a comment",
          "wrong.tir:9:24: the quotes round PROPERTY_FILE_FORMAT are not closed",
          "wrong.tir:11:19: UNLOADED_RADIUS is 0,33; a number is wanted", "remedy: write a decimal point",
          "wrong.tir:12:9: WIDTH is -0.2 m; 0.001 to 2 m are possible",
          "wrong.tir:14:10: FNOMIN is many; a number is wanted", "wrong.tir:17:9: FZMAX is 200, not above FZMIN = 9000",
          "wrong.tir: PKX1 is missing", "remedy: write PKX1 = a number in [LONGITUDINAL_COEFFICIENTS]",
          "wrong.tir:22:1: the section's name does not end with ]", "wrong.tir:25:1: PDY1 stands twice in",
          "wrong.tir:27:8: PKY2 is 0", "wrong.tir:31:1: PKY1 stands in two sections, first at"}) {
        EXPECT_TRUE(contains(result.report, part)) << part << "\nis not in\n" << result.report;
    }
    // Twelve places and the missing key.
    std::size_t count = 0;
    std::istringstream lines(result.report);
    for (std::string line; std::getline(lines, line);) {
        count += contains(line, "wrong.tir:") && line[0] != ' ' ? 1U : 0U;
    }
    EXPECT_EQ(count, 13U) << result.report;
    std::string warnings;
    for (const std::string& warning : result.warnings) {
        warnings += warning + "\n";
    }
    EXPECT_TRUE(contains(warnings, "wrong.tir:21: PKX11 is unknown and not used; did you mean PKX1?")) << warnings;
    EXPECT_TRUE(contains(warnings, "wrong.tir:28: PKY5 is not used by MF 5.2")) << warnings;
    EXPECT_TRUE(contains(warnings, "wrong.tir:30: LFZ0 is unknown and not used; did you mean LFZO?")) << warnings;
    EXPECT_TRUE(contains(warnings, "wrong.tir:5: the coefficients of the Magic Formula are taken per radian"))
        << warnings;
}

TEST(TirFile, ShortestFileIsEnough) {
    for (const char* model : {"FITTYP = 5", "FITTYP = 6", "FITTYP = 21", "PROPERTY_FILE_FORMAT = 'PAC2002'"}) {
        const Read result = read_text_as_file(shortest(model));
        ASSERT_TRUE(result.tire) << result.report;
        EXPECT_EQ(result.tire->law.version, physics::MagicFormulaVersion::mf52) << model;
        EXPECT_FALSE(result.tire->vertical_range);
        EXPECT_TRUE(result.warnings.empty());
    }
}

TEST(TirFile, FormulaVersion61BringsItsOwnCoefficients) {
    for (const char* model : {"FITTYP = 61", "FITTYP = 62"}) {
        const Read result = read_text_as_file(shortest(model) + "PKY4 = 1.9\nPKY6 = -0.8\nPEY5 = 0.1\nPPY1 = 0.3\n");
        ASSERT_TRUE(result.tire) << result.report;
        EXPECT_EQ(result.tire->law.version, physics::MagicFormulaVersion::mf61);
        EXPECT_DOUBLE_EQ(result.tire->law.pKy4, 1.9);
        EXPECT_DOUBLE_EQ(result.tire->law.pKy6, -0.8);
        expect_warning(result, "PPY1 is not used, as no term of the pressure: NOMPRES is missing");
    }
}

TEST(TirFile, CoefficientsOfTheOtherVersionAreWarnedOfAndLeft) {
    const Read old = read_text_as_file(shortest("FITTYP = 6") + "PKY4 = 1.9\n");
    ASSERT_TRUE(old.tire);
    EXPECT_EQ(old.tire->law.pKy4, 2.0);
    expect_warning(old, "PKY4 is not used by MF 5.2");
    const Read recent = read_text_as_file(shortest("FITTYP = 61") + "PHY3 = 0.1\n");
    ASSERT_TRUE(recent.tire);
    EXPECT_EQ(recent.tire->law.pHy3, 0.0);
    expect_warning(recent, "PHY3 is not used by MF 6.1");
}

// A file in millimetres and newtons has pressures in N/mm2: 0.22 and 0.28 are 220 and 280 kPa, dp = 0.272727. PKY1 = -20 and PKY2 =
// 2 make 64000 N/rad at 220 kPa and -80000 0.890909 sin(2 atan(1/1.672727)) = -62780 at 280 kPa.
TEST(TirFile, TermsOfThePressureActAboutTheNominalOne) {
    const std::string terms = "PPY1 = -0.4\nPPY2 = -0.6\n[OPERATING_CONDITIONS]\nINFLPRES = 280000\nNOMPRES = 220000\n";
    const Read result = read_text_as_file(shortest("FITTYP = 61") + terms);
    ASSERT_TRUE(result.tire) << result.report;
    EXPECT_TRUE(result.warnings.empty());
    EXPECT_NEAR(result.tire->law.cornering_stiffness(4000.0, 0.0), -62780.0, 1.0);
    EXPECT_NEAR(result.tire->law.cornering_stiffness(4000.0, 0.0, 220e3), -64000.0, 1e-9);
    std::string text = shortest("FITTYP = 61\n[UNITS]\nLENGTH = 'mm'\nFORCE = 'newton'\n");
    text.replace(text.find("= 0.33"), 6, "= 330");
    text.replace(text.find("= 0.225"), 7, "= 225");
    const Read in_mm = read_text_as_file(text + "NOMPRES = 0.22\nPPY1 = -0.4\n");
    ASSERT_TRUE(in_mm.tire) << in_mm.report;
    EXPECT_NEAR(in_mm.tire->law.nominal_pressure, 220e3, 1e-6);
    const Read bar = read_text_as_file(shortest("FITTYP = 61") + "NOMPRES = 2.2\n");
    EXPECT_TRUE(contains(bar.report, "NOMPRES is 2.2 Pa; 10000 to 3e+06 Pa are possible")) << bar.report;
}

TEST(TirFile, WithoutLongitudinalCoefficientsThereIsNoLongitudinalForce) {
    std::string text = shortest("FITTYP = 6");
    const std::size_t from = text.find("[LONGITUDINAL");
    text.erase(from, text.find("[LATERAL") - from);
    const Read result = read_text_as_file(text);
    ASSERT_TRUE(result.tire) << result.report;
    EXPECT_EQ(result.tire->law.longitudinal({.load = 4000.0, .slip = 0.1}).force, 0.0);
    expect_warning(result, "the longitudinal force is 0");
}

TEST(TirFile, UnitsAreThoseThatFilesWrite) {
    const std::string model = "FITTYP = 6\n[UNITS]\n";
    for (const char* units : {"LENGTH = 'METER'\nFORCE = 'NEWTON'\nANGLE = 'RADIANS'\nMASS = 'KG'\nTIME = 'SECOND'",
                              "LENGTH = 'm'\nFORCE = 'N'\nANGLE = 'rad'\nMASS = 'kg'\nTIME = 's'"}) {
        const Read result = read_text_as_file(shortest(model + units));
        ASSERT_TRUE(result.tire) << result.report;
        EXPECT_DOUBLE_EQ(result.tire->unloaded_radius, 0.33);
        EXPECT_DOUBLE_EQ(result.tire->law.nominal_load, 4000.0);
    }
    // 0.33 inch = 8.382 mm; 4000 pounds of force = 17792.886 N
    const Read imperial = read_text_as_file(shortest(model + "LENGTH = 'inch'\nFORCE = 'pound_force'"));
    ASSERT_TRUE(imperial.tire) << imperial.report;
    EXPECT_NEAR(imperial.tire->unloaded_radius, 8.382e-3, 1e-12);
    EXPECT_NEAR(imperial.tire->law.nominal_load, 17792.886, 1e-3);
}

TEST(TirFile, CarriageReturnsAndAByteOrderMarkAreAccepted) {
    std::string text = "\xEF\xBB\xBF";
    for (const char c : shortest("FITTYP = 6")) {
        text += c == '\n' ? std::string("\r\n") : std::string(1, c);
    }
    const Read result = read_text_as_file(text);
    EXPECT_TRUE(result.tire) << result.report;
}

TEST(TirFile, MissingFileIsAnErrorOfItsPlace) {
    const Read result = read("no_such_file.tir");
    EXPECT_FALSE(result.tire);
    EXPECT_TRUE(contains(result.report, "no_such_file.tir: the file cannot be read")) << result.report;
}

// A value of 30 000 characters is shown by its two ends; who reads it must find the rest of the message.
TEST(TirFile, AVeryLongValueIsShownByItsEnds) {
    const Read result =
        read_text_as_file(shortest("FITTYP = 5") + "PDX2 = first" + std::string(30'000, 'x') + "last\n");
    EXPECT_LT(result.report.size(), 1500U);
    EXPECT_TRUE(contains(result.report, "PDX2 is first")) << result.report;
    EXPECT_TRUE(contains(result.report, "xlast; a number is wanted")) << result.report;
    EXPECT_TRUE(contains(result.report, "characters) ...")) << result.report;
}

// D sin(C atan(K x / (C D))) is even in D: a file with a peak below 0 has the force of its size.
TEST(TirFile, ANegativePeakHasTheForceOfItsSize) {
    const Read plus = read_text_as_file(shortest("FITTYP = 5") + "PDY2 = -0.2\n");
    const std::string text = shortest("FITTYP = 5") + "PDY2 = 0.2\n";
    const Read minus =
        read_text_as_file(text.substr(0, text.find("PDY1 = 1")) + "PDY1 = -1" + text.substr(text.find("PDY1 = 1") + 8));
    ASSERT_TRUE(plus.tire && minus.tire) << minus.report;
    expect_warning(minus, "PDY1 is below 0: the force does not depend on the sign of D, and is that of 1");
    const physics::PureSlipState state{.load = 6000.0, .slip = 0.1};
    EXPECT_DOUBLE_EQ(minus.tire->law.lateral(state).force, plus.tire->law.lateral(state).force);
    EXPECT_LT(minus.tire->law.lateral(state).force, -4000.0);
}

// Each of these was taken as it stands, and turned the force off, reversed it or made it of another planet's size.
TEST(TirFile, SignsAndSizesThatNoTireHasAreErrors) {
    const auto with = [](const std::string& from, const std::string& to) {
        std::string text = shortest("FITTYP = 5");
        const std::size_t at = text.find(from);
        return read_text_as_file(text.replace(at, from.size(), to));
    };
    EXPECT_TRUE(
        contains(with("PCY1 = 1.3", "PCY1 = 0").report,
                 "PCY1 is 0; 0.1 to 3 are possible\n    PCY1 = 0\n           ^\n    remedy: correct it: PCY1 is a "
                 "shape factor C, 1 to 2 for tires"));
    EXPECT_TRUE(
        contains(with("PDY1 = 1", "PDY1 = 1e300").report, "PDY1 is 1e300; 0.1 to 5 of either sign are possible"));
    EXPECT_TRUE(contains(with("PKY2 = 2\n", "PKY2 = 2\n[SCALING_COEFFICIENTS]\nLMUY = -1\n").report,
                         "LMUY is -1; 0.01 to 10 are possible"));
    EXPECT_TRUE(
        contains(with("FNOMIN = 4000", "FNOMIN = 1e-300").report, "FNOMIN is 1e-300 N; 10 to 1e+06 N are possible"));
    EXPECT_TRUE(contains(with("[DIMENSION]", "[UNITS]\nLENGTH = 'parsec'\n[DIMENSION]").report,
                         "remedy: correct it, or LENGTH in [UNITS]"));
}

// [SHAPE] has rows of numbers with or without braces above them, contact models lines of their own.
TEST(TirFile, SectionsThatAreNotReadArePassedOver) {
    const Read result = read_text_as_file(shortest("FITTYP = 5") +
                                          "[SHAPE]\n 1.0 0.0\n 0.9 0.5\n[BOTTOMING_CURVE]\n{pen fz}\n0 0\n"
                                          "[CONTACT_COEFFICIENTS]\nellipse 12 3.5\n");
    EXPECT_TRUE(result.tire) << result.report;
    const Read broken = read_text_as_file(shortest("FITTYP = 5") + "PEY1 0.3\n");
    EXPECT_TRUE(contains(broken.report, "the line is neither [SECTION] nor KEY = value")) << broken.report;
}

// The tire on the left is the mirror image: F(alpha) on the right is -F(-alpha) of the left one, at every camber.
TEST(TirFile, ATireOfTheLeftSideIsTurnedForTheRight) {
    const std::string shifts = "PHY1 = 0.004\nPVY1 = 0.05\nPVY3 = 0.3\nPEY3 = 0.2\nPHY3 = 0.02\n";
    const Read left = read_text_as_file(shortest("FITTYP = 5\nTYRESIDE = 'LEFT'") + shifts);
    const Read right = read_text_as_file(shortest("FITTYP = 5\nTYRESIDE = 'Right'") + shifts);
    ASSERT_TRUE(left.tire && right.tire) << left.report;
    EXPECT_TRUE(left.tire->is_left && !right.tire->is_left);
    for (const double slip : {-0.08, 0.0, 0.05}) {
        const physics::PureSlipState state{.load = 5000.0, .slip = slip, .camber = 0.03};
        const physics::PureSlipState turned{.load = 5000.0, .slip = -slip, .camber = -0.03};
        EXPECT_NEAR(left.tire->law_on_the_right().lateral(state).force, -left.tire->law.lateral(turned).force, 1e-9);
        EXPECT_EQ(right.tire->law_on_the_right().lateral(state).force, right.tire->law.lateral(state).force);
    }
    expect_warning(read_text_as_file(shortest("FITTYP = 5\nTYRESIDE = 'NEARSIDE'")), "neither LEFT nor RIGHT");
}

TEST(TirFile, TermsOfThePressureNeedTheNominalOne) {
    expect_warning(read_text_as_file(shortest("FITTYP = 61") + "PPY2 = 0\nPPY3 = -0.1\n"),
                   "PPY3 is not used, as no term of the pressure: NOMPRES is missing");
}

}  // namespace tiretherm::input
