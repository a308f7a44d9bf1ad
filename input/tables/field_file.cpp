// SPDX-License-Identifier: BSD-3-Clause
// Checks which columns belong together, divides the rows into frames and computes the density at each point.

#include "input/tables/field_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

using physics::FieldOf;

constexpr double turn = 2.0 * std::numbers::pi;

/// A column, or dataset, that a field of a structural code may have.
struct FieldColumn {
    std::string_view name;
    QuantitySpec spec;
    std::string_view usual_unit;
    Purpose purpose = Purpose::point;
};
constexpr std::array field_columns{
    FieldColumn{"time", {.unit = "s", .low = -1e10, .high = 1e10}, "s", Purpose::frame},
    FieldColumn{"wheel_angle", {.unit = "rad", .low = -1e3, .high = 1e3}, "deg", Purpose::frame},
    FieldColumn{"x", {.unit = "m", .low = -10.0, .high = 10.0}, "mm"},
    FieldColumn{"y", {.unit = "m", .low = -10.0, .high = 10.0}, "mm"},
    FieldColumn{"depth", {.unit = "m", .low = 0.0, .high = 10.0}, "mm"},
    FieldColumn{"cell", {.unit = "1", .low = 0.0, .high = 1e9}, "1"},
    FieldColumn{"area", {.unit = "m2", .low = 0.0, .high = 1e3, .above = true}, "mm2"},
    FieldColumn{"volume", {.unit = "m3", .low = 0.0, .high = 1e3, .above = true}, "mm3"},
    FieldColumn{"pressure", {.unit = "Pa", .low = 0.0, .high = 1e9}, "kPa"},
    FieldColumn{"sliding_velocity", {.unit = "m s-1", .low = -1e3, .high = 1e3}, "m/s"},
    FieldColumn{"shear_stress", {.unit = "Pa", .low = -1e9, .high = 1e9}, "kPa"},
    FieldColumn{"friction_power", {.unit = "W m-2", .low = 0.0, .high = 1e12}, "W/m2"},
    FieldColumn{"loss_density", {.unit = "W m-3", .low = 0.0, .high = 1e12}, "W/m3"},
};

const FieldColumn& field_column(std::string_view name) {
    return *std::ranges::find(field_columns, name, &FieldColumn::name);
}

/// How to write its unit. @param in_text into a heading; otherwise into an attribute
std::string unit_remedy(const FieldColumn& column, bool in_text) {
    return in_text ? fmt::format("write \"{} [{}]\"", column.name, column.usual_unit)
                   : fmt::format("give the dataset an attribute units = \"{}\"", column.usual_unit);
}

class FieldReader {
public:
    FieldReader(std::shared_ptr<const DataFile> file, FieldOf of, bool watts, bool along_meridian, InputErrors& errors)
        : file_(std::move(file)), of_(of), watts_(watts), along_meridian_(along_meridian), errors_(&errors) {}

    std::optional<FieldFile> read() {
        const std::size_t before = errors_->count();
        check_names();
        request_places();
        request_values();
        if (errors_->count() != before) {
            // What is in the columns that are there is looked at all the same.
            static_cast<void>(file_->read(requests_, *errors_));
            return std::nullopt;
        }
        values_ = file_->read(requests_, *errors_);
        if (values_.empty()) {
            return std::nullopt;
        }
        FieldFile field{.file = file_, .against = against_, .frames = {}};
        split(field);
        if (errors_->count() == before) {
            check_sizes(field);
            check_revolution(field);
            check_cells();
            check_areas(field);
        }
        return errors_->count() == before ? std::optional(std::move(field)) : std::nullopt;
    }

private:
    [[nodiscard]] bool has(std::string_view name) const { return file_->find(name) >= 0; }
    [[nodiscard]] SourceLocation place_of(std::string_view name) const {
        return file_->heads()[static_cast<std::size_t>(file_->find(name))].place;
    }
    [[nodiscard]] SourceLocation top() const { return {.file = file_->number()}; }

    void check_names() {
        const std::vector<std::string> known = names_of(field_columns);
        std::set<std::string> seen;
        ErrorLimiter unknown(*errors_);
        for (const ColumnHead& head : file_->heads()) {
            const std::string& name = head.heading.name;
            if (name.empty() && &head == &file_->heads().back()) {
                continue;  // a separator at the end of the line, as some programs write it
            }
            if (std::ranges::find(known, name) == known.end()) {
                unknown.add(
                    head.place,
                    {name.empty() ? fmt::format("heading {} is empty", &head - file_->heads().data() + 1)
                                  : fmt::format("a field has no column \"{}\"", name),
                     name.empty() ? std::string("name the column, or remove it") : suggest(name, known, "columns")});
            } else if (seen.contains(name)) {
                errors_->add(head.place, fmt::format("a second column is called {}", name), "remove one of them");
            }
            seen.insert(name);
        }
        unknown.close("unknown columns");
    }

    void request(std::string_view name) {
        const int column = file_->find(name);
        const FieldColumn& known = field_column(name);
        if (column >= 0) {
            requests_.push_back({.column = column,
                                 .name = std::string(name),
                                 .spec = known.spec,
                                 .purpose = known.purpose,
                                 .unit_remedy = unit_remedy(known, file_->is_text())});
        }
    }
    void request_places() {
        if (has("time") && has("wheel_angle")) {
            errors_->add(place_of("wheel_angle"), "a field is given against time or against the wheel angle, not both",
                         "remove one of the columns");
        }
        against_ = has("time")          ? FieldFile::Against::time
                   : has("wheel_angle") ? FieldFile::Against::wheel_angle
                                        : FieldFile::Against::nothing;
        request("time");
        request("wheel_angle");
        const bool contact = of_ != FieldOf::loss;
        request("cell");
        if (!has("cell")) {
            if (!has("y") && along_meridian_) {
                errors_->add(top(), "the field has no coordinates: a column y or cell is required",
                             "add y, the arc length along the meridian from the centre plane");
            }
            request("y");
            if (contact) {
                request("x");
            } else {
                request("depth");
                if (has("x")) {
                    errors_->add(place_of("x"), "loss_density turns with the tire: x is no place of it",
                                 "give it against wheel_angle, or as a mean around the tire without x");
                }
            }
        }
        request(contact ? "area" : "volume");
    }

    void request_values() {
        switch (of_) {
            case FieldOf::nothing:
                return;
            case FieldOf::pressure:
                return require("pressure");
            case FieldOf::loss:
                return require("loss_density");
            case FieldOf::friction:
                break;
        }
        if (has("friction_power")) {
            return request("friction_power");
        }
        const bool by_stress = has("shear_stress") && has("sliding_velocity");
        if (!by_stress && watts_) {
            errors_->add(top(), "the field gives no power of friction",
                         "add friction_power [W/m2], or shear_stress [kPa] and sliding_velocity [m/s]; with use = "
                         "\"shape\" pressure and sliding_velocity do");
            return;
        }
        require("sliding_velocity");
        require(by_stress ? "shear_stress" : "pressure");
    }
    void require(std::string_view name) {
        if (!has(name)) {
            errors_->add(top(), fmt::format("the field has no {} {}", file_->is_text() ? "column" : "dataset", name),
                         fmt::format("add it, {}", unit_remedy(field_column(name), file_->is_text())));
        }
        request(name);
    }

    [[nodiscard]] const std::vector<double>* values(std::string_view name) const {
        const auto found = std::ranges::find(requests_, name, &ColumnRequest::name);
        return found == requests_.end() ? nullptr : &values_[static_cast<std::size_t>(found - requests_.begin())];
    }

    [[nodiscard]] double density(std::size_t row) const {
        double product = 1.0;
        for (const std::string_view name :
             {"pressure", "sliding_velocity", "shear_stress", "friction_power", "loss_density"}) {
            const std::vector<double>* factor = values(name);
            product *= factor != nullptr ? std::abs((*factor)[row]) : 1.0;
        }
        return product;
    }

    void split(FieldFile& field) const {
        const std::vector<double>* axis = values(against_ == FieldFile::Against::time ? "time" : "wheel_angle");
        for (std::size_t row = 0; row < values_.front().size(); ++row) {
            const double at = axis != nullptr ? (*axis)[row] : 0.0;
            if (field.frames.empty() || at != field.frames.back().at) {
                field.frames.push_back({.at = at, .first_row = row, .points = {}, .density = {}});
            }
            FieldFrame& frame = field.frames.back();
            const auto take = [&](std::string_view name, std::vector<double>& into) {
                if (const std::vector<double>* column = values(name)) {
                    into.push_back((*column)[row]);
                }
            };
            take("x", frame.points.along);
            take("y", frame.points.across);
            take("depth", frame.points.depth);
            take("area", frame.points.measure);
            take("volume", frame.points.measure);
            if (const std::vector<double>* cell = values("cell")) {
                frame.points.cell.push_back(static_cast<int>((*cell)[row]));
            } else if (values("y") == nullptr) {
                frame.points.across.push_back(0.0);
            }
            frame.density.push_back(density(row));
        }
    }

    void check_sizes(const FieldFile& field) const {
        for (const FieldFrame& frame : field.frames) {
            if (frame.points.size() != field.frames.front().points.size()) {
                const FieldLocation spot = file_->spot(frame.first_row);
                errors_->add(spot.place,
                             fmt::format("this frame has {} points, the first has {}{}", frame.points.size(),
                                         field.frames.front().points.size(), spot.aside),
                             "write every point in every frame; the file may be cut off");
                return;
            }
        }
    }

    void check_revolution(const FieldFile& field) const {
        if (against_ == FieldFile::Against::wheel_angle && field.shares_of_revolution().empty()) {
            const double degree = turn / 360.0;
            errors_->add(place_of("wheel_angle"),
                         fmt::format("wheel_angle goes from {:.4g} to {:.4g} deg, which is not a whole revolution",
                                     field.frames.front().at / degree, field.frames.back().at / degree),
                         "give frames from 0 to 360 deg, the last one 360 or a step before it");
        }
    }

    void check_cells() const {
        if (const std::vector<double>* cells = values("cell")) {
            const auto broken = std::ranges::find_if(*cells, [](double c) { return c != std::floor(c); });
            if (broken != cells->end()) {
                const FieldLocation spot = file_->spot(static_cast<std::size_t>(broken - cells->begin()));
                errors_->add(spot.place, fmt::format("cell is {:g}{}; a whole number is wanted", *broken, spot.aside));
            }
        }
    }

    /// What points of the contact stand for follows from their rows along x, where they stand in rows.
    void check_areas(const FieldFile& field) const {
        const physics::FieldPoints& points = field.frames.front().points;
        if (points.along.empty() || !points.measure.empty()) {
            return;
        }
        const auto widths = physics::spacings(points);
        if (widths.alone || (watts_ && widths.rows < 2)) {
            errors_->add(top(),
                         widths.alone ? "the points do not stand in rows: some y has one x only"
                                      : "all points stand at one y: the width of the contact is unknown",
                         "add area [mm2], what each point stands for");
        }
    }

    std::shared_ptr<const DataFile> file_;
    FieldOf of_;
    bool watts_;
    bool along_meridian_;
    InputErrors* errors_;
    FieldFile::Against against_ = FieldFile::Against::nothing;
    std::vector<ColumnRequest> requests_;
    std::vector<std::vector<double>> values_;
};

}  // namespace

std::vector<double> FieldFile::shares_of_revolution() const {
    const std::size_t n = frames.size();
    const double span = frames.back().at - frames.front().at;
    double widest = 0.0;
    for (std::size_t k = 1; k < n; ++k) {
        widest = std::max(widest, frames[k].at - frames[k - 1].at);
    }
    const bool closed = std::abs(span - turn) <= 1e-6;
    const double gap = closed ? 0.0 : turn - span;
    if (n < 2 || gap < 0.0 || gap > 1.01 * widest) {
        return {};
    }
    std::vector<double> shares(n);
    for (std::size_t k = 0; k < n; ++k) {
        const double before = k > 0 ? frames[k].at - frames[k - 1].at : gap;
        const double after = k + 1 < n ? frames[k + 1].at - frames[k].at : gap;
        shares[k] = 0.5 * (before + after) / (closed ? span : turn);
    }
    return shares;
}

std::optional<FieldFile> read_field_file(const std::filesystem::path& path, const SourceLocation& mentioned, FieldOf of,
                                         bool watts, bool along_meridian, InputErrors& errors) {
    std::optional<DataFile> file = DataFile::open(path, mentioned, errors);
    if (!file) {
        return std::nullopt;
    }
    return FieldReader(std::make_shared<const DataFile>(std::move(*file)), of, watts, along_meridian, errors).read();
}

}  // namespace tiretherm::input
