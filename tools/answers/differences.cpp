#include "answers/differences.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "shell/changes.hpp"
#include "shell/json.hpp"

namespace geminga::answers {
namespace {

/// Fields that change with every announcement, which is not told.
constexpr std::array<std::string_view, 4> restless{"age", "heard", "loss", "loss_least"};

/// The record as an object without the restless fields.
boost::json::object steady(const Record& record) {
  auto object = shell::to_json(record);
  for (const auto key : restless) object.erase(key);
  return object;
}

std::string_view word(Difference::Kind kind) {
  static constexpr std::array<std::string_view, 3> words{"add", "modify", "del"};
  return words[std::to_underlying(kind)];
}

}  // namespace

Known known_by(std::string_view key, std::vector<Record> records) {
  Known known;
  for (auto& record : records) {
    std::string name(record[key]);
    known.insert_or_assign(std::move(name), std::move(record));
  }
  return known;
}

bool has_gone(const Known& before, const Known& after) {
  return std::ranges::any_of(before, [&](const auto& one) { return !after.contains(one.first); });
}

std::vector<Difference> differences(const Known& before, const Known& after,
                                    const std::function<std::string_view(const std::string&)>& reason) {
  std::vector<Difference> found;
  for (const auto& [key, record] : before) {
    if (!after.contains(key))
      found.push_back({.kind = Difference::Kind::del, .record = &record, .reason = reason(key)});
  }
  for (const auto& [key, record] : after) {
    const auto old = before.find(key);
    if (old == before.end()) {
      found.push_back({.kind = Difference::Kind::add, .record = &record});
    } else if (auto former = shell::former(steady(old->second), steady(record)); !former.empty()) {
      found.push_back({.kind = Difference::Kind::modify, .record = &record, .former = std::move(former)});
    }
  }
  return found;
}

std::string_view Reasons::operator()(const std::string& key) const {
  if (there.contains(key)) return "changed";
  return participants.contains(key.substr(0, key.find('/'))) ? "withdrawn" : "gone";
}

boost::json::object to_json(const Difference& difference) {
  boost::json::object object{{"event", word(difference.kind)}};
  if (difference.kind == Difference::Kind::modify) object["former"] = difference.former;
  if (difference.kind == Difference::Kind::del) object["reason"] = difference.reason;
  for (const auto& member : shell::to_json(*difference.record)) object.insert(member);
  return shell::stamped(object);
}

}  // namespace geminga::answers
