#include "doctor/report.hpp"

#include <algorithm>
#include <boost/json/array.hpp>
#include <map>
#include <string>
#include <vector>

#include "shell/json.hpp"

namespace geminga::doctor {
namespace {

using boost::json::value;

boost::json::object to_json(const Finding& finding) {
  return {
      {"severity", word(finding.severity)}, {"code", finding.code},      {"what", finding.what}, {"seen", finding.seen},
      {"remedy", finding.remedy},           {"command", finding.command}};
}

boost::json::array to_json(const Host& host) {
  boost::json::array interfaces;
  for (const HostInterface& interface : host.interfaces) {
    interfaces.push_back({{"name", interface.name},
                          {"up", interface.is_up},
                          {"carrier", interface.has_carrier},
                          {"multicast", interface.can_multicast},
                          {"wireless", interface.is_wireless},
                          {"power_save", interface.saves_power},
                          {"rp_filter_strict", interface.is_strict},
                          {"mtu", interface.mtu},
                          {"addresses", boost::json::array(interface.addresses.begin(), interface.addresses.end())}});
  }
  return interfaces;
}

/// Puts numbers in the place of names.
class Numbering {
 public:
  /// Two letters and less are left alone: they occur in words that are no names.
  void add(std::string_view name) {
    if (name.size() > 2) numbers_.try_emplace(std::string(name), numbers_.size() + 1);
  }

  void apply(value& in) const {
    if (auto* object = in.if_object()) {
      for (auto& member : *object) apply(member.value());
    } else if (auto* array = in.if_array()) {
      for (value& element : *array) apply(element);
    } else if (auto* text = in.if_string()) {
      in = numbered(*text);
    }
  }

 private:
  static bool is_part_of_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
  }

  [[nodiscard]] std::string numbered(std::string_view text) const {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
      const bool begins_word = at == 0 || !is_part_of_word(text[at - 1]);
      const auto& longest = begins_word ? name_at(text, at) : none_;
      if (longest.empty()) {
        result += text[at++];
      } else {
        result += "name" + std::to_string(numbers_.at(longest));
        at += longest.size();
      }
    }
    return result;
  }

  [[nodiscard]] const std::string& name_at(std::string_view text, std::size_t at) const {
    const std::string* longest = &none_;
    for (const auto& [name, number] : numbers_) {
      if (name.size() <= longest->size() || !text.substr(at).starts_with(name)) continue;
      const std::size_t end = at + name.size();
      if (end == text.size() || !is_part_of_word(text[end])) longest = &name;
    }
    return *longest;
  }

  std::map<std::string, std::size_t> numbers_;
  std::string none_;
};

void add_names(Numbering& numbering, const std::vector<Record>& records) {
  for (const Record& record : records) {
    numbering.add(record["name"]);
    numbering.add(record["participant_name"]);
  }
}

boost::json::array without_attributes(std::vector<Record> records) {
  for (Record& record : records) record.attributes.clear();
  return shell::to_json(records);
}

}  // namespace

std::string_view word(Severity severity) { return severity == Severity::failure ? "failure" : "risk"; }

boost::json::object to_json(const Findings& findings) {
  boost::json::array list;
  for (const Finding& finding : findings) list.push_back(to_json(finding));
  return {{"healthy", findings.empty()}, {"findings", std::move(list)}};
}

boost::json::object to_json(const OtherView& other) {
  return {{"participant", other.id},
          {"answered", other.is_answered},
          {"status", shell::to_json(other.answers.status)},
          {"interfaces", shell::to_json(other.answers.interfaces)},
          {"participants", shell::to_json(other.answers.participants)}};
}

boost::json::object report_of(const Findings& findings, const Host& host, const std::optional<Answers>& answers,
                              const std::optional<OtherView>& other, Names names) {
  boost::json::object report = to_json(findings);
  if (other) report["with"] = to_json(*other);
  report["interfaces_of_host"] = to_json(host);
  Numbering numbering;
  numbering.add(host.user);
  if (answers) {
    report["status"] = shell::to_json(answers->status);
    report["interfaces"] = shell::to_json(answers->interfaces);
    report["participants"] = shell::to_json(answers->participants);
    report["security"] = shell::to_json(answers->security);
    report["ontology"] = shell::to_json(answers->ontology);
    report["services"] = without_attributes(answers->services);
    report["unmatched"] = without_attributes(answers->unmatched);
    numbering.add(answers->status["name"]);
    for (const auto* records : {&answers->participants, &answers->security, &answers->services, &answers->unmatched})
      add_names(numbering, *records);
  }
  if (names == Names::as_they_are) return report;
  value whole = std::move(report);
  numbering.apply(whole);
  return std::move(whole.get_object());
}

}  // namespace geminga::doctor
