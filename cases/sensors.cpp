#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "cases/draft.hpp"
#include "cases/probes.hpp"
#include "cases/wanted.hpp"

namespace tiretherm::cases {

namespace {

struct Kind {
    std::string_view name;
    Where (*read)(Section& sensor, const mesh::Mesh& mesh);
};
constexpr std::array kinds{Kind{"point", read_point}, Kind{"spot", read_spot}, Kind{"patch", read_patch},
                           Kind{"layer", read_layer}, Kind{"region", read_region}};

}  // namespace

void read_sensors(Section& root, Draft& draft) {
    std::array<std::string_view, kinds.size()> names;
    std::transform(kinds.begin(), kinds.end(), names.begin(), [](const Kind& kind) { return kind.name; });
    std::vector<solver::Channel>& channels = draft.problem.channels;
    root.each("sensor", [&](Section& sensor) {
        const std::optional<std::string> name = sensor.name("name", Need::required);
        const std::optional<std::string> meaning = sensor.text("meaning");
        const std::optional<std::size_t> kind = sensor.choice("kind", names, Need::required);
        for (const solver::Channel& other : channels) {
            if (name && other.name == *name) {
                sensor.mistake("name", fmt::format("a second sensor is called \"{}\"", *name), "rename one");
            }
        }
        Where where;
        if (kind && draft.has_mesh) {
            where = kinds[*kind].read(sensor, draft.problem.mesh);
        } else {
            for (const std::string_view key : {"depth", "x", "y", "radius"}) {
                sensor.quantity(key, wanted::coordinate);
            }
            sensor.forgive();
        }
        solver::Channel channel = where.value_or(solver::Channel{});
        channel.name = name.value_or("");
        channel.meaning = meaning.value_or(channel.meaning);
        channels.push_back(std::move(channel));
    });
    if (channels.empty()) {
        root.mistakes().warn(root.place(), "the case has no [[sensor]]: the run records fields only");
    }
}

}  // namespace tiretherm::cases
