// The words and keys of services as GCNP writes them.
#include "geminga/service.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "base/text.hpp"

namespace geminga {
namespace {

constexpr std::array<std::pair<ChannelMode, std::string_view>, 4> modes{{
    {ChannelMode::one_to_one, "oto"},
    {ChannelMode::one_to_many_stream, "otm/stream"},
    {ChannelMode::one_to_many_pubsub, "otm/pubsub"},
    {ChannelMode::participant, "participant"},
}};

constexpr std::array<std::pair<RequiredReach, std::string_view>, 2> reaches{{
    {RequiredReach::routed, "routed"},
    {RequiredReach::any, "any"},
}};

constexpr std::array<std::pair<Degree, std::string_view>, 6> degrees{{
    {Degree::exact, "exact"},
    {Degree::equivalent, "equivalent"},
    {Degree::narrower, "narrower"},
    {Degree::broader, "broader"},
    {Degree::converted, "converted"},
    {Degree::overlapping, "overlapping"},
}};

template <typename Table, typename Value>
std::string_view word_of(const Table& table, Value value) {
  return std::ranges::find(table, value, [](const auto& row) { return row.first; })->second;
}

template <typename Value, typename Table>
std::optional<Value> value_of(const Table& table, std::string_view word) {
  const auto row = std::ranges::find(table, word, [](const auto& entry) { return entry.second; });
  return row == table.end() ? std::nullopt : std::optional<Value>(row->first);
}

}  // namespace

std::string_view to_string(ChannelMode mode) { return word_of(modes, mode); }
std::optional<ChannelMode> channel_mode(std::string_view word) { return value_of<ChannelMode>(modes, word); }

std::string_view to_string(RequiredReach reach) { return word_of(reaches, reach); }

std::optional<RequiredReach> required_reach(std::string_view word) { return value_of<RequiredReach>(reaches, word); }

std::string_view to_string(Degree degree) { return word_of(degrees, degree); }
std::optional<Degree> degree(std::string_view word) { return value_of<Degree>(degrees, word); }

std::string to_string(ParticipantId id) { return base::to_hex(std::to_underlying(id), 8); }

std::string to_string(const ServiceKey& key) { return peer_word(key) + '/' + std::to_string(key.number); }

std::string peer_word(const ServiceKey& key) {
  return to_string(key.participant) + '/' + std::to_string(std::to_underlying(key.peer));
}

std::optional<ParticipantId> participant_id(std::string_view text) {
  if (text.size() != 8 || text.find_first_not_of("0123456789abcdef") != std::string_view::npos) return std::nullopt;
  std::uint32_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number, 16);
  return ParticipantId{number};
}

std::optional<ServiceKey> service_key(std::string_view text) {
  const auto first = text.find('/');
  const auto second = first == std::string_view::npos ? first : text.find('/', first + 1);
  if (second == std::string_view::npos) return std::nullopt;
  const auto participant = participant_id(text.substr(0, first));
  const auto peer = base::parse_number<std::uint32_t>(text.substr(first + 1, second - first - 1));
  const auto number = base::parse_number<std::uint32_t>(text.substr(second + 1));
  if (!participant || !peer || !number) return std::nullopt;
  return ServiceKey{*participant, PeerId{*peer}, *number};
}

}  // namespace geminga
