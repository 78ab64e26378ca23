#include "doctor/steady.hpp"

#include <algorithm>
#include <string_view>

#include "doctor/checks.hpp"

namespace geminga::doctor {
namespace {

const Record* find(const std::vector<Record>& records, std::string_view key, std::string_view value) {
  const auto found = std::ranges::find_if(records, [&](const Record& one) { return one[key] == value; });
  return found == records.end() || value.empty() ? nullptr : &*found;
}

void take_out(Record& record, std::string_view key) {
  std::erase_if(record.fields, [&](const auto& field) { return field.first == key; });
}

/// Takes a field out of the records that do not have the same value in both looks.
void keep_equal(const std::vector<Record>& earlier, std::vector<Record>& later, std::string_view key,
                std::string_view field) {
  for (Record& record : later) {
    const Record* before = find(earlier, key, record[key]);
    if (before == nullptr || (*before)[field] != record[field]) take_out(record, field);
  }
}

void keep_quiet(const Answers& earlier, Answers& later) {
  const double interval = number(later.status["interval"]);
  const bool is_due = later.asked_from - earlier.asked_until >= interval;
  for (Record& record : later.interfaces) {
    const Record* before = find(earlier.interfaces, "name", record["name"]);
    const bool has_spoken = before != nullptr && number(record["sent"]) > number((*before)["sent"]);
    if (before == nullptr || (is_due && !has_spoken) || number((*before)["quiet"]) <= quiet_intervals * interval)
      take_out(record, "quiet");
  }
}

}  // namespace

Answers steady(const Answers& earlier, Answers later) {
  std::erase_if(later.unmatched, [&](const Record& request) {
    return find(earlier.unmatched, "subscription", request["subscription"]) == nullptr;
  });
  keep_equal(earlier.participants, later.participants, "id", "hears_us");
  keep_equal(earlier.participants, later.participants, "id", "ontology");
  keep_equal(earlier.security, later.security, "participant", "lacks");
  if (earlier.status["ontology_loading"] == "1" || later.status["ontology_loading"] == "1") {
    for (Record& participant : later.participants) take_out(participant, "ontology");
  }
  keep_quiet(earlier, later);
  later.earlier_status = earlier.status;
  return later;
}

}  // namespace geminga::doctor
