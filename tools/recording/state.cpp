#include "recording/state.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

namespace geminga::recording {
namespace {

std::string* field_of(Record& record, std::string_view key) {
  const auto field = std::ranges::find(record.fields, key, &std::pair<std::string, std::string>::first);
  return field == record.fields.end() ? nullptr : &field->second;
}

template <typename Map>
const typename Map::mapped_type* find(const Map& map, std::string_view key) {
  const auto at = map.find(key);
  return at == map.end() ? nullptr : &at->second;
}

}  // namespace

void State::apply(const Entry& entry) {
  last_ = entry.at;
  last_time_ = entry.time;
  now_ = entry.at;
  std::visit([&](const auto& event) { take(event); }, entry.event);
}

void State::take(const Snapshot& snapshot) {
  source_ = snapshot;
  lost_.clear();
  named_.emplace();
  if (snapshot.records == 0) finish_snapshot();
}

State::Sign State::sign_of(const Record& record) const {
  return {.heard = std::string(record["heard"]),
          .loss = std::string(record["loss"]),
          .loss_least = std::string(record["loss_least"]),
          .at = last_};
}

void State::take(const Present& present) {
  const Record& record = present.record;
  const std::string key(record[key_field(record.kind)]);
  records_[record.kind].insert_or_assign(key, record);
  if (record.kind == "participants") {
    signs_.insert_or_assign(key, sign_of(record));
  }
  if (present.change != Present::Change::there) {
    named_.reset();  // the snapshot was not whole: a line of it is missing
  } else if (named_ && named_->emplace(record.kind, key).second && named_->size() == source_.records) {
    finish_snapshot();
  }
}

void State::finish_snapshot() {
  for (auto& [kind, records] : records_) {
    std::erase_if(records, [&](const auto& one) { return !named_->contains({kind, one.first}); });
  }
  for (auto* answers : {&whys_, &matches_})
    std::erase_if(*answers, [&](const auto& one) { return !of("requests").contains(one.first); });
  std::erase_if(signs_, [&](const auto& one) { return !of("participants").contains(one.first); });
  named_.reset();
}

void State::take(const Gone& gone) {
  named_.reset();
  records_[gone.kind].erase(gone.key);
  if (gone.kind == "requests") {
    whys_.erase(gone.key);
    matches_.erase(gone.key);
  }
  if (gone.kind == "participants") signs_.erase(gone.key);
}

void State::take(const Heard& heard) {
  for (const Record& record : heard.records) {
    const auto sign = signs_.find(record["id"]);
    if (sign != signs_.end()) sign->second = sign_of(record);
  }
}

void State::take(const Answered& answered) {
  const bool is_of_request = answered.kind == "why" || answered.kind == "match";
  if (!is_of_request) {
    answers_.insert_or_assign(answered.kind, answered.answer);
  } else if (of("requests").contains(answered.subscription)) {
    (answered.kind == "why" ? whys_ : matches_).insert_or_assign(answered.subscription, answered.answer);
  }
}

const Records& State::of(std::string_view kind) const {
  static const Records none;
  const Records* records = find(records_, kind);
  return records == nullptr ? none : *records;
}

std::optional<std::string> State::heard(std::string_view participant) const {
  const Sign* sign = find(signs_, participant);
  const Record* record = find(of("participants"), participant);
  if (sign == nullptr || record == nullptr) return std::nullopt;
  if ((*record)["self"] == "1") return "0.000";
  const double seconds =
      std::strtod(sign->heard.c_str(), nullptr) + std::chrono::duration<double>(now_ - sign->at).count();
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.3f", std::clamp(seconds, 0.0, 1e12));
  return text.data();
}

Record State::aged(const Record& record) const {
  Record aged = record;
  const bool is_participant = record.kind == "participants";
  std::string participant(record[key_field(record.kind)]);
  participant.erase(std::min(participant.find('/'), participant.size()));
  const auto sign = heard(participant);
  if (!sign) return aged;
  if (std::string* field = field_of(aged, is_participant ? "heard" : "age")) {
    *field = !is_participant && record["local"] == "1" ? "0.000" : *sign;
  }
  if (!is_participant) return aged;
  const Sign& last = *find(signs_, participant);
  if (std::string* loss = field_of(aged, "loss")) *loss = last.loss;
  if (std::string* least = field_of(aged, "loss_least")) *least = last.loss_least;
  return aged;
}

const Answer* State::answer(std::string_view kind) const { return find(answers_, kind); }

const Answer* State::why(std::string_view subscription) const { return find(whys_, subscription); }

const Answer* State::matches(std::string_view subscription) const { return find(matches_, subscription); }

}  // namespace geminga::recording
