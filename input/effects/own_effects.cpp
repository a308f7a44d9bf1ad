#include "input/effects/own_effects.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/model/draft.hpp"
#include "input/effects/own_formula.hpp"
#include "input/text/wanted.hpp"
#include "input/text/words.hpp"
#include "physics/own_place.hpp"

namespace tiretherm::input {

namespace {

constexpr std::string_view air = "air_temperature";

const std::vector<Node>& items_of(const Node& document, std::string_view list) {
    static const std::vector<Node> none;
    const Node* found = document.find(list);
    return found != nullptr ? found->items : none;
}

bool is_number(std::string_view text) { return leading_number(text).has_value(); }

/// Where a piece of a text in quotes stands, if the text is in one line without escapes; else the whole.
Place piece(const Place& text, const std::string& written, const Formula::Wrong& wrong) {
    if (wrong.length == 0 || text.length != static_cast<int>(written.size()) + 2) {
        return text;
    }
    return {.file = text.file,
            .line = text.line,
            .column = text.column + 1 + static_cast<int>(wrong.from),
            .length = static_cast<int>(std::min(wrong.length, written.size() - wrong.from))};
}

/// What a formula may speak of in this run.
std::vector<std::string> known_signals(const Draft& draft) {
    std::vector<std::string> known;
    for (const physics::Signal& signal : physics::signals()) {
        if (draft.given.contains(signal.name)) {
            known.emplace_back(signal.name);
        }
    }
    known.emplace_back("time");
    if (draft.run) {
        std::ranges::copy(draft.run->headings, std::back_inserter(known));
    }
    std::ranges::sort(known);
    known.erase(std::unique(known.begin(), known.end()), known.end());
    std::erase(known, "");
    return known;
}

const OwnColumn* find_column(const Draft& draft, std::string_view name) {
    for (const std::vector<OwnColumn>* columns : {draft.run ? &draft.run->columns : &draft.columns, &draft.columns}) {
        if (const auto found = std::ranges::find(*columns, name, &OwnColumn::name); found != columns->end()) {
            return &*found;
        }
    }
    return nullptr;
}

/// Whether a signal can be followed. What is missing is a mistake; what could not be read has been complained about.
bool can_follow(const Section& section, std::string_view key, const std::string& signal, const Draft& draft) {
    if (signal == "time") {
        return true;
    }
    if (const OwnColumn* column = find_column(draft, signal)) {
        return !column->course.time.empty();
    }
    if (const physics::Signal* input = physics::find_signal(signal); input != nullptr && draft.given.contains(signal)) {
        return draft.problem.drive.gives(*input);
    }
    if (draft.run && draft.run->unreadable) {
        return false;
    }
    const std::string remedy = suggest(signal, known_signals(draft), "signals");
    if (draft.run) {
        section.mistakes().add(
            draft.run->place,
            fmt::format("run {}: neither its file nor [drive] gives {}, which {} at {} follows", draft.run->name,
                        signal, section.title(), section.mistakes().spell(section.place(key))),
            remedy);
    } else {
        section.mistake(key, fmt::format("[drive] gives no signal \"{}\"", signal), remedy);
    }
    return false;
}

/// The course of a formula under a key.
std::optional<solver::Course> read_course(Section& section, std::string_view key, const std::string& text,
                                          const Draft& draft) {
    Formula::Wrong wrong;
    const std::optional<Formula> formula =
        find_column(draft, text) != nullptr ? Formula::of_signal(text) : Formula::read(text, key, wrong);
    if (!formula) {
        section.mistakes().add(piece(section.place(key), text, wrong), wrong.fault);
        return std::nullopt;
    }
    bool known = true;
    for (const std::string& signal : formula->signals()) {
        known = can_follow(section, key, signal, draft) && known;
    }
    if (!known) {
        return std::nullopt;
    }
    std::vector<OwnColumn> columns = draft.columns;
    if (draft.run) {
        columns.insert(columns.begin(), draft.run->columns.begin(), draft.run->columns.end());
    }
    return course_of(*formula, draft.problem.drive, columns, draft.problem.settings);
}

/// The temperature of the surroundings: an input, a column or a constant. @returns false after a mistake
bool read_surroundings(Section& section, const Draft& draft, solver::OwnEffect& own) {
    own.temperature = section.text("temperature").value_or(std::string(air));
    if (is_number(own.temperature)) {
        const auto constant = section.quantity("temperature", wanted::temperature);
        own.surroundings = {{draft.problem.settings.start}, {constant.value_or(0.0)}};
        return constant.has_value();
    }
    const auto course = read_course(section, "temperature", own.temperature, draft);
    const physics::Signal* input = physics::find_signal(own.temperature);
    const OwnColumn* column = find_column(draft, own.temperature);
    // Spelled out: a choice between a text and a literal would be a text of its own, gone before it is looked at.
    std::string_view unit;
    if (input != nullptr) {
        unit = input->unit;
    } else if (column != nullptr) {
        unit = column->unit;
    }
    if (course && unit != "K") {
        section.mistake("temperature", fmt::format("{} is not a temperature", own.temperature),
                        "name an input or a column in degC or K, or write a value such as \"25 degC\"");
        return false;
    }
    if (course && own.temperature != air) {  // the air's is taken from the drive, its drift included
        own.surroundings = *course;
    }
    return course.has_value();
}

void read_places(Section& section, const Draft& draft, solver::OwnEffect& own) {
    const std::vector<Word> words = section.texts("at", Need::required);
    if (section.has("at") && words.empty()) {
        section.mistake("at", "at names no place", "write at = \"surface\"");
    }
    for (const Word& word : words) {
        own.places.push_back(word.text);
        if (draft.has_mesh && physics::nodes_of_place(draft.problem.mesh, word.text).empty()) {
            section.mistakes().add(word.place, fmt::format("the mesh has no place \"{}\"", word.text),
                                   suggest(word.text, physics::names_of_places(draft.problem.mesh), "places"));
        }
    }
}

/// A name that nothing else has.
std::string read_name(Section& section, const std::vector<solver::OwnEffect>& before) {
    const std::string name = section.name("name", Need::required).value_or("");
    if (physics::find_effect(name) != nullptr) {
        section.mistake("name", fmt::format("{} is an effect of the catalogue", name), "choose another name");
    }
    if (std::ranges::count(before, name, &solver::OwnEffect::name) > 0 && !name.empty()) {
        section.mistake("name", fmt::format("a second effect is called \"{}\"", name), "choose another name");
    }
    return name;
}

void read_list(Section& root, Draft& draft, const OwnKind& kind, std::vector<solver::OwnEffect>& sound,
               std::vector<solver::OwnEffect>& all) {
    root.each(kind.list, [&](Section& section) {
        const std::size_t before = section.mistakes().count();
        solver::OwnEffect own;
        own.exchange = kind.list == own_exchange.list;
        own.name = read_name(section, all);
        read_places(section, draft, own);
        const physics::Parameter& number = physics::find_effect(kind.effect)->parameters.front();
        own.amount = section.quantity(kind.number, wanted::of(number), Need::required).value_or(0.0);
        own.follows = section.text("follows", own.exchange ? Need::optional : Need::required).value_or("1");
        all.push_back(own);
        const bool readable = section.has("follows") || own.exchange;
        const auto course = readable ? read_course(section, "follows", own.follows, draft) : std::nullopt;
        const bool surrounded = !own.exchange || read_surroundings(section, draft, own);
        if (!course || !surrounded || !draft.has_mesh || section.mistakes().count() != before) {
            return;
        }
        own.course = *course;
        for (const std::string& sentence : solver::objections(draft.problem, own)) {
            section.mistakes().add(
                section.place(), fmt::format("{}: {}", own.name, sentence),
                sentence.starts_with("the signal is -")
                    ? fmt::format("follow what is never negative, such as \"max(0, {})\"", own.follows)
                    : "");
        }
        if (section.mistakes().count() == before) {
            sound.push_back(std::move(own));
        }
    });
}

}  // namespace

std::vector<std::string> followed_names(const Node& document) {
    std::vector<std::string> names;
    const auto add_name = [&](const std::string& name) {
        if (std::ranges::find(names, name) == names.end()) {
            names.push_back(name);
        }
    };
    const auto add = [&](const std::string& text) {
        add_name(text);  // which may be the name of a column, whatever it looks like
        Formula::Wrong wrong;
        if (const std::optional<Formula> formula = Formula::read(text, "follows", wrong)) {
            std::ranges::for_each(formula->signals(), add_name);
        }
    };
    for (const OwnKind& kind : {own_source, own_exchange}) {
        for (const Node& item : items_of(document, kind.list)) {
            for (const std::string_view key : {"follows", "temperature"}) {
                const Node* text = item.find(key);
                if (text != nullptr && text->kind == Node::Kind::text) {
                    add(text->text);
                }
            }
            if (kind.list == own_exchange.list && item.find("temperature") == nullptr) {
                add(std::string(air));
            }
        }
    }
    return names;
}

std::vector<std::string> own_names(const Node& document, std::string_view list) {
    std::vector<std::string> names;
    for (const Node& item : items_of(document, list)) {
        if (const Node* name = item.find("name"); name != nullptr) {
            names.push_back(name->text);
        }
    }
    return names;
}

/// All courses are read before the first effect is on: its samples are no business of the others.
void read_own_effects(Section& root, Draft& draft) {
    std::vector<solver::OwnEffect> sound;
    std::vector<solver::OwnEffect> all;
    for (const OwnKind& kind : {own_source, own_exchange}) {
        read_list(root, draft, kind, sound, all);
    }
    for (const solver::OwnEffect& own : sound) {
        solver::add_own_effect(draft.problem, own);
    }
}

}  // namespace tiretherm::input
