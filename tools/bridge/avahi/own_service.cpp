#include "bridge/avahi/own_service.hpp"

#include <algorithm>
#include <string_view>

#include "base/text.hpp"
#include "base/utf8.hpp"
#include "bridge/avahi/found_service.hpp"
#include "bridge/avahi/limits.hpp"
#include "bridge/team/foreign_services.hpp"

namespace geminga::bridge {
namespace {

std::string shown_identity(const Record& line) {
  for (const char* key : {"concept", "text"}) {
    if (!line[key].empty()) return base::printable(line[key], max_label_bytes);
  }
  return "id " + std::string(line["id"]);
}

std::string label_of(const Record& line) {
  const std::string word(line["service"]);
  const std::size_t room = max_label_bytes - std::min(max_label_bytes - 1, word.size() + 1);
  return std::string(base::first_characters(shown_identity(line), room)) + ' ' + word;
}

/// Adds a string of the TXT record, if it fits.
void add_txt(OwnService& service, std::size_t& octets, std::string_view key, std::string_view value) {
  std::string one = std::string(key) + '=' + std::string(value);
  if (one.size() > max_txt_string_bytes || octets + one.size() + 1 > max_txt_bytes) {
    service.is_cut = true;
    return;
  }
  octets += one.size() + 1;
  service.txt.push_back(std::move(one));
}

}  // namespace

std::optional<OwnService> own_service(const Record& line, const std::set<std::string>& addresses) {
  const auto port = base::parse_number<std::uint16_t>(line["port"]);
  if (!port || *port == 0 || line["service"].empty() || line.attributes.contains(bridge_attribute)) return std::nullopt;
  OwnService service;
  service.label = label_of(line);
  service.type = line["protocol"] == "tcp" ? own_tcp_type : own_udp_type;
  service.port = *port;
  const std::string address(line["address"]);
  if (!address.empty() && !addresses.contains(address)) {
    service.address = address;
    service.host = "geminga-" + std::string(line["service"]);
    std::ranges::replace(service.host, '/', '-');
  }
  std::size_t octets = 0;
  add_txt(service, octets, "txtvers", "1");
  for (const char* key : {"concept", "representation", "text", "id", "mode", "protocol", "priority", "service", "name",
                          "participant_name"}) {
    if (!line[key].empty()) add_txt(service, octets, key, line[key]);
  }
  for (const auto& [key, value] : line.attributes) add_txt(service, octets, "attr." + key, value);
  return service;
}

}  // namespace geminga::bridge
