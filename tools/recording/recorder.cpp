#include "recording/recorder.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace geminga::recording {
namespace {

/// Fields that change with every announcement: they make no change of a record by themselves.
constexpr std::array<std::string_view, 4> restless{"age", "heard", "loss", "loss_least"};

bool is_same(const Record& one, const Record& other) {
  if (one.attributes != other.attributes || one.fields.size() != other.fields.size()) return false;
  for (std::size_t i = 0; i < one.fields.size(); ++i) {
    if (one.fields[i].first != other.fields[i].first) return false;
    if (std::ranges::find(restless, one.fields[i].first) != restless.end()) continue;
    if (one.fields[i].second != other.fields[i].second) return false;
  }
  return true;
}

Records by_key(const std::vector<Record>& records, std::string_view kind) {
  Records by_key;
  for (const Record& record : records) by_key.insert_or_assign(std::string(record[key_field(kind)]), record);
  return by_key;
}

/// A line, or nothing where it would be too long to be read again.
void append(std::string& lines, const Entry& entry) {
  const std::string line = line_of(entry);
  if (line.size() <= max_line_bytes + 1) lines += line;
}

/// The signs of life of all participants, in lines of at most so many of them.
void append_heard(std::string& lines, const Records& participants, At at, Time time) {
  constexpr std::size_t most_in_line = 1024;
  Heard heard;
  const auto write = [&] {
    append(lines, {at, time, heard});
    heard.records.clear();
  };
  for (const auto& [key, record] : participants) {
    heard.records.push_back({"participants",
                             {{"id", key},
                              {"heard", std::string(record["heard"])},
                              {"loss", std::string(record["loss"])},
                              {"loss_least", std::string(record["loss_least"])}},
                             {}});
    if (heard.records.size() == most_in_line) write();
  }
  if (!heard.records.empty()) write();
}

}  // namespace

std::string Recorder::snapshot_of(const Known& now, At at, Time time) const {
  std::string records;
  std::size_t count = 0;
  for (const auto& [kind, all] : now) {
    for (const auto& one : all) {
      const std::size_t before = records.size();
      append(records, {at, time, Present{Present::Change::there, one.second}});
      count += records.size() == before ? 0 : 1;
    }
  }
  std::string lines;
  if (skipped_ > 0) append(lines, {at, time, Skipped{skipped_}});
  Snapshot snapshot = source_;
  snapshot.records = count;
  append(lines, {at, time, snapshot});
  return lines + records;
}

std::string Recorder::changes_to(const Known& now, At at, Time time) const {
  std::string lines;
  // Records that go are told first.
  for (const auto& [kind, before] : known_) {
    const Records& after = now.find(kind)->second;
    const Records& participants = now.find("participants")->second;
    for (const auto& [key, record] : before) {
      if (after.contains(key)) continue;
      const bool is_withdrawn = kind != "participants" && participants.contains(key.substr(0, key.find('/')));
      append(lines, {at, time, Gone{kind, key, is_withdrawn ? "withdrawn" : "gone"}});
    }
  }
  for (const auto& [kind, after] : now) {
    const auto before = known_.find(kind);
    for (const auto& [key, record] : after) {
      const auto old = before->second.find(key);
      const bool is_new = old == before->second.end();
      if (!is_new && is_same(old->second, record)) continue;
      append(lines, {at, time, Present{is_new ? Present::Change::add : Present::Change::modify, record}});
    }
  }
  return lines;
}

void Recorder::mark_to_ask(const Known& now) {
  const Records& requests = now.find("requests")->second;
  const auto before = known_.find("requests");
  const auto services_before = known_.find("services");
  const Records& services = now.find("services")->second;
  const auto is_equal = [](const auto& one, const auto& other) {
    return one.first == other.first && is_same(one.second, other.second);
  };
  const bool is_everything_new =
      services_before == known_.end() || !std::ranges::equal(services_before->second, services, is_equal);
  std::erase_if(to_ask_, [&](const std::string& key) { return !requests.contains(key); });
  for (const auto& [key, record] : requests) {
    const auto* old =
        before == known_.end() || !before->second.contains(key) ? nullptr : &before->second.find(key)->second;
    if (is_everything_new || old == nullptr || !is_same(*old, record)) to_ask_.insert(key);
  }
}

void Recorder::skip() {
  ++skipped_;
  ++skipped_in_all_;
  needs_snapshot_ = true;
}

std::expected<std::string, std::string> Recorder::observe(const Observation& seen, At at, Time time) {
  const bool is_snapshot = needs_snapshot_ || at - last_snapshot_ >= snapshot_interval;
  if (needs_snapshot_ && !allowance_.has(snapshot_octets_, at)) {
    skip();
    return "";
  }
  Known now{{"participants", by_key(seen.participants, "participants")},
            {"services", by_key(seen.services, "services")},
            {"requests", by_key(seen.requests, "requests")}};
  std::string lines = is_snapshot ? snapshot_of(now, at, time) : changes_to(now, at, time);
  if (is_snapshot && lines.size() > allowance_.most()) {
    return std::unexpected(
        "the state of the team alone takes " + std::to_string(lines.size()) +
        " octets, more than the half of the limit that may be written at once: give a greater --limit");
  }
  if (is_snapshot || at - last_heard_ >= heard_interval) {
    append_heard(lines, now.find("participants")->second, at, time);
    last_heard_ = at;
  }
  if (is_snapshot) snapshot_octets_ = lines.size();
  if (!lines.empty() && !allowance_.take(lines.size(), at)) {
    skip();
    return "";
  }
  mark_to_ask(now);
  known_ = std::move(now);
  if (is_snapshot) {
    last_snapshot_ = at;
    needs_snapshot_ = false;
    skipped_ = 0;
    answers_.clear();  // they are written again, so that a reader who begins here has them
    for (const auto& one : known_.find("requests")->second) to_ask_.insert(one.first);
  }
  return lines;
}

std::string Recorder::answered(const Answered& answered, At at, Time time) {
  if (needs_snapshot_) return "";  // of which round it is would not be known
  std::string line;
  append(line, {At(), Time(), answered});
  std::string& last = answers_[answered.kind + ' ' + answered.subscription];
  if (line.empty() || last == line) return "";
  std::string written = line_of({at, time, answered});
  if (!allowance_.take(written.size(), at)) return "";
  last = std::move(line);
  return written;
}

std::vector<std::string> Recorder::requests_to_ask() {
  std::vector<std::string> keys;
  while (keys.size() < max_reasons_in_round && !to_ask_.empty()) {
    auto next = to_ask_.upper_bound(last_asked_);
    if (next == to_ask_.end()) next = to_ask_.begin();
    last_asked_ = *next;
    keys.push_back(last_asked_);
    to_ask_.erase(next);
  }
  return keys;
}

std::string Recorder::lost(const std::string& text, At at, Time time) {
  needs_snapshot_ = true;
  std::string line = line_of({at, time, Lost{text}});
  return allowance_.take(line.size(), at) ? line : "";
}

std::string Recorder::end(const std::string& reason, At at, Time time) {
  std::string lines;
  if (skipped_ > 0) append(lines, {at, time, Skipped{skipped_}});
  append(lines, {at, time, End{reason}});
  return allowance_.take(lines.size(), at) ? lines : "";
}

}  // namespace geminga::recording
