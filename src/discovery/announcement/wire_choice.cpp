#include "discovery/announcement/wire_choice.hpp"

#include <cstddef>
#include <utility>

#include "discovery/announcement/limits.hpp"

namespace geminga::announcement {
namespace {

void write_groups(const std::vector<ServiceKey>& chosen, wire::Subscription& message) {
  int group = 0;  // where the size of the last group stands
  for (const ServiceKey& key : chosen) {
    const auto participant = std::to_underlying(key.participant);
    if (message.chosen_hosts().empty() || *message.chosen_hosts().rbegin() != participant) {
      message.add_chosen_hosts(participant);
      group = message.chosen_services_size();
      message.add_chosen_services(0);
    }
    message.set_chosen_services(group, message.chosen_services(group) + 1);
    message.add_chosen_services(std::to_underlying(key.peer));
    message.add_chosen_services(key.number);
  }
}

std::optional<std::vector<ServiceKey>> read_groups(const wire::Subscription& message) {
  std::vector<ServiceKey> chosen;
  const auto& numbers = message.chosen_services();
  int next = 0;
  for (const std::uint32_t participant : message.chosen_hosts()) {
    if (next == numbers.size()) return std::nullopt;
    const std::uint32_t count = numbers[next++];
    if (count == 0 || count > max_announced_choice || 2 * static_cast<int>(count) > numbers.size() - next) {
      return std::nullopt;
    }
    for (std::uint32_t i = 0; i < count; ++i, next += 2) {
      chosen.push_back({ParticipantId{participant}, PeerId{numbers[next]}, numbers[next + 1]});
    }
    if (chosen.size() > max_announced_choice) return std::nullopt;
  }
  if (next != numbers.size()) return std::nullopt;
  return chosen;
}

}  // namespace

void write_choice(const std::vector<ServiceKey>& chosen, wire::Subscription& message) {
  if (chosen.size() > max_listed_choice) return write_groups(chosen, message);
  for (const ServiceKey& key : chosen) {
    auto* one = message.add_chosen();
    one->set_participant(std::to_underlying(key.participant));
    one->set_peer(std::to_underlying(key.peer));
    one->set_number(key.number);
  }
}

std::optional<std::vector<ServiceKey>> read_choice(const wire::Subscription& message) {
  if (message.chosen().empty()) return read_groups(message);
  const auto count = static_cast<std::size_t>(message.chosen_size());
  if (count > max_listed_choice || !message.chosen_hosts().empty() || !message.chosen_services().empty()) {
    return std::nullopt;
  }
  std::vector<ServiceKey> chosen;
  for (const auto& one : message.chosen()) {
    chosen.push_back({ParticipantId{one.participant()}, PeerId{one.peer()}, one.number()});
  }
  return chosen;
}

}  // namespace geminga::announcement
