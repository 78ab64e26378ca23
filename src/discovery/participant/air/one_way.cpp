#include "discovery/participant/air/one_way.hpp"

#include <string>

#include "base/text.hpp"

namespace geminga::participant {

void OneWay::hear(const announcement::Announcement& presence, const membership::NeighbourTable& table,
                  std::string_view source, std::string_view interface, base::LogSink& log) {
  const bool is_deaf = table.witnesses().is_surely_deaf_to_us(presence.participant);
  if (is_deaf == told_.contains(presence.participant)) return;
  const auto known = table.neighbours().find(presence.participant);
  const std::string id = to_string(presence.participant);
  const std::string name = base::printable(known ? known->name : id);
  if (!is_deaf) {
    told_.erase(presence.participant);
    log.write(base::LogLevel::info, name + " hears us again", {.participant = id, .code = "hears_us"});
    return;
  }
  if (told_.size() >= max_named_deaf) {
    std::erase_if(told_, [&](ParticipantId one) { return !table.neighbours().is_known(one); });
    if (told_.size() >= max_named_deaf) return;
  }
  told_.insert(presence.participant);
  log.write(base::LogLevel::warning,
            name + " (" + std::string(source) + " on " + std::string(interface) +
                ") is heard, and says that it does not hear us: look at the firewall of both hosts (UDP, multicast and "
                "its port), and at what forwards multicast between them",
            {.participant = id, .code = "deaf_to_us"});
}

}  // namespace geminga::participant
