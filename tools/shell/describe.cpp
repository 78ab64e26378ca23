#include "shell/describe.hpp"

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <map>
#include <set>

namespace geminga::shell {
namespace {

std::string sign(Change change) {
  switch (change) {
    case Change::add:
      return "+ ";
    case Change::modify:
      return "~ ";
    case Change::del:
      return "- ";
  }
  return "";
}

std::string port_word(std::uint16_t port) { return port == 0 ? "" : std::to_string(port); }

/// The words of both kinds of events behind the peer's name.
template <typename Event, typename Service>
std::string details(const Event& event, const Service& service) {
  std::string line = "  " + identity_words(service.identity) + "  " + std::string(to_string(event.degree)) + ' ' +
                     std::to_string(event.distance) + "  " + std::string(to_string(service.mode));
  const std::string where = place(service.address, port_word(service.port));
  if (!where.empty()) line += "  " + where;
  if (service.priority != 0) line += "  priority " + std::to_string(service.priority);
  if (!service.attributes.empty()) line += "  " + attribute_words(service.attributes);
  return line;
}

/// A reason with `it` for the identity that it is about; as it is where it names none.
std::string reason_of_it(const Record& record) {
  std::string_view rest = record["because"];
  for (const std::string_view begin : {"nobody offers ", "nobody asks for "}) {
    if (!rest.starts_with(begin)) continue;
    rest.remove_prefix(begin.size());
    for (const std::string_view key : {"concept", "text", "id"}) {
      const std::string said = std::string(key) + '=' + std::string(record[key]);
      if (record[key].empty() || !rest.starts_with(said)) continue;
      rest.remove_prefix(said.size());
      const std::string as = " representation=" + std::string(record["representation"]);
      if (!record["representation"].empty() && rest.starts_with(as)) rest.remove_prefix(as.size());
      return std::string(begin) + "it" + std::string(rest);
    }
  }
  return std::string(record["because"]);
}

}  // namespace

std::vector<std::string> reasons_of(const std::vector<Record>& records) {
  std::vector<std::string> shared;
  std::map<std::string, std::set<std::string_view>> reasons;  // by what they have in common
  for (const Record& record : records) {
    shared.push_back(reason_of_it(record));
    reasons[shared.back()].insert(record["because"]);
  }
  for (std::size_t one = 0; one < records.size(); ++one) {
    if (reasons[shared[one]].size() == 1) shared[one] = records[one]["because"];
  }
  return shared;
}

std::string who(std::string_view peer_word, std::string_view peer_name, std::string_view participant_name) {
  const auto slash = peer_word.find('/');
  const std::string_view id = peer_word.substr(0, slash);
  const std::string_view peer = slash == std::string_view::npos ? "" : peer_word.substr(slash + 1);
  std::string words(peer_name.empty() ? peer : peer_name);
  words += '@';
  words += participant_name.empty() ? id : participant_name;
  return words;
}

std::string identity_words(const NamedIdentity& identity) {
  if (const auto* number = std::get_if<NumericIdentity>(&identity)) return std::to_string(number->number);
  if (const auto* text = std::get_if<TextIdentity>(&identity)) return '"' + text->text + '"';
  const auto& names = std::get<ConceptNames>(identity);
  if (names.representation_name.empty()) return names.concept_name;
  return names.concept_name + " in " + names.representation_name;
}

std::string identity_words(const Record& record) {
  if (const auto id = record["id"]; !id.empty()) return std::string(id);
  if (const auto text = record["text"]; !text.empty()) return '"' + std::string(text) + '"';
  return identity_words(ConceptNames{std::string(record["concept"]), std::string(record["representation"])});
}

std::string place(std::string_view address, std::string_view port) {
  if (port.empty()) return std::string(address);
  const bool is_six = address.find(':') != std::string_view::npos;
  return (is_six ? '[' + std::string(address) + ']' : std::string(address)) + ':' + std::string(port);
}

std::string attribute_words(const Attributes& attributes) {
  std::string words;
  for (const auto& [key, value] : attributes) {
    if (!words.empty()) words += ' ';
    words += key;
    if (value.empty()) continue;
    const bool has_space = value.find(' ') != std::string::npos;
    words += has_space ? "=\"" + value + '"' : '=' + value;
  }
  return words;
}

std::string number_words(double value, const char* unit) {
  char text[64];
  std::snprintf(text, sizeof text, value < 10 ? "%.1f %s" : "%.0f %s", value, unit);
  return text;
}

std::string duration_words(std::string_view seconds) {
  double value = 0;
  const auto read = std::from_chars(seconds.data(), seconds.data() + seconds.size(), value);
  if (seconds.empty() || read.ec != std::errc() || read.ptr != seconds.data() + seconds.size()) {
    return std::string(seconds);
  }
  if (value < 120) return number_words(value, "s");
  if (value < 120 * 60) return number_words(value / 60, "min");
  if (value < 48 * 3600) return number_words(value / 3600, "h");
  return number_words(value / 86400, "d");
}

std::string name_of(const ServiceEvent& event) {
  return who(peer_word(event.service), event.peer_name, event.participant_name) + "  " +
         identity_words(event.publication.identity);
}

std::string name_of(const ConsumerEvent& event) {
  return who(peer_word(event.subscription), event.peer_name, event.participant_name) + "  " +
         identity_words(event.subscribed.identity);
}

std::string gone_line(std::string_view name, const ServiceKey& key, std::string_view reason) {
  std::string line = sign(Change::del);
  if (!name.empty()) line += std::string(name) + "  ";
  return line + to_string(key) + "  " + std::string(reason);
}

std::string line_of(const ServiceEvent& event) {
  if (event.change == Change::del) return gone_line("", event.service, event.reason);
  return sign(event.change) + who(peer_word(event.service), event.peer_name, event.participant_name) +
         details(event, event.publication) +
         (event.convert.empty() ? "" : "  by " + event.convert + " cost " + std::to_string(event.cost)) +
         (event.via.empty() ? "" : " via " + event.via) + (event.reachable ? "" : "  not reachable from here") + "  " +
         to_string(event.service);
}

std::string line_of(const ConsumerEvent& event) {
  if (event.change == Change::del) return gone_line("", event.subscription, event.reason);
  return sign(event.change) + who(peer_word(event.subscription), event.peer_name, event.participant_name) +
         details(event, event.subscribed) + "  " + to_string(event.subscription);
}

}  // namespace geminga::shell
