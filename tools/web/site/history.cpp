#include "web/site/history.hpp"

#include <algorithm>
#include <boost/json/array.hpp>
#include <boost/json/serialize.hpp>
#include <cstdlib>
#include <memory>
#include <utility>

#include "answers/questions.hpp"
#include "shell/json.hpp"
#include "shell/timestamp.hpp"

namespace geminga::web {
namespace {

constexpr std::array<std::string_view, 3> kind_words{"participants", "services", "requests"};
constexpr std::size_t of_daemon = kind_words.size();

std::string json_of(const boost::json::value& value) { return boost::json::serialize(value); }
std::string text_json(std::string_view text) { return json_of(boost::json::value(text)); }

std::string_view event_word(answers::Difference::Kind kind) {
  switch (kind) {
    case answers::Difference::Kind::add:
      return "add";
    case answers::Difference::Kind::modify:
      return "modify";
    case answers::Difference::Kind::del:
      break;
  }
  return "del";
}

double number_of(std::string_view text) { return std::strtod(std::string(text).c_str(), nullptr); }

}  // namespace

std::size_t History::Happening::octets() const {
  return happening_cost + event.size() + key.size() + reason.size() + record.size();
}

void History::look(Time now) {
  if (!keeps_anything() || is_looking_) return;
  is_looking_ = true;
  const auto look = std::make_shared<Look>();  // lives as long as one answer is missing
  look->at = now;
  for (std::size_t at = 0; at < kinds; ++at) {
    asker_.ask({std::string(kind_words[at])}, [this, look, at](Outcome outcome) {
      look->outcomes[at] = std::move(outcome);
      if (--look->missing > 0) return;
      is_looking_ = false;
      take(*look);
    });
  }
}

void History::take(const Look& look) {
  std::array<answers::Known, kinds> now;
  for (std::size_t at = 0; at < kinds; ++at) {
    const auto& outcome = *look.outcomes[at];
    if (!outcome) return miss(look.at, outcome.error().text);
    now[at] = answers::known_by(answers::find_kind(kind_words[at])->id, outcome->records);
  }
  observe(look.at, std::move(now));
  if (looks_++ % sample_every == 0) sample(look.at);
}

void History::observe(Time at, std::array<answers::Known, kinds> now) {
  at = std::max(at, end_);  // the clock of the host may be set back
  drop_old(at);
  end_ = at;
  if (has_begun_) {
    if (!absence_.empty()) {
      absence_.clear();
      keep({.at = at, .kind = of_daemon, .event = "add", .key = "", .reason = "", .record = "null"});
    }
    return compare(at, std::move(now));
  }
  has_begun_ = true;
  begin_ = at;
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    for (const auto& [key, record] : now[kind]) before_[kind].emplace(key, json_of(shell::to_json(record)));
  }
  known_ = std::move(now);
}

void History::miss(Time at, const std::string& reason) {
  at = std::max(at, end_);
  drop_old(at);
  if (!has_begun_ || !absence_.empty()) return;
  end_ = at;
  absence_ = reason;
  keep({.at = at, .kind = of_daemon, .event = "del", .key = "", .reason = reason, .record = "null"});
}

void History::compare(Time at, std::array<answers::Known, kinds> now) {
  answers::Reasons reasons;
  for (const auto& [id, record] : now[0]) reasons.participants.insert(id);
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    for (const auto& difference : answers::differences(known_[kind], now[kind], reasons)) {
      keep({.at = at,
            .kind = kind,
            .event = std::string(event_word(difference.kind)),
            .key = std::string((*difference.record)[answers::find_kind(kind_words[kind])->id]),
            .reason = kind == 0 ? "" : std::string(difference.reason),
            .record = json_of(shell::to_json(*difference.record))});
    }
  }
  known_ = std::move(now);
}

void History::sample(Time at) {
  asker_.ask({"status"}, [this, at](const Outcome& status) { take_sample(at, status); });
}

void History::take_sample(Time at, const Outcome& status) {
  if (!status->has_value() || (*status)->records.empty()) return;
  double worst = 0;
  double sum = 0;
  std::size_t others = 0;
  for (const auto& [id, record] : known_[0]) {
    if (record["self"] == "1") continue;
    const double loss = number_of(record["loss"]);
    worst = std::max(worst, loss);
    sum += loss;
    ++others;
  }
  const auto unserved = std::ranges::count_if(known_[2], [](const auto& one) { return one.second["served"] == "0"; });
  const boost::json::array numbers{known_[1].size(),
                                   known_[2].size(),
                                   unserved,
                                   worst,
                                   others == 0 ? 0 : sum / static_cast<double>(others),
                                   number_of((*status)->records.front()["datagrams_received"])};
  samples_.push_back({at, json_of(numbers)});
}

void History::keep(Happening happening) {
  octets_ += happening.octets();
  happenings_.push_back(std::move(happening));
  while (happenings_.size() > max_happenings || octets_ > max_history_octets) {
    is_cut_ = true;
    drop_eldest();
  }
}

/// The state before the first happening becomes the one behind it.
void History::drop_eldest() {
  Happening& eldest = happenings_.front();
  octets_ -= eldest.octets();
  begin_ = eldest.at;
  if (eldest.kind == of_daemon) {
    absence_before_ = eldest.reason;
  } else if (eldest.event == "del") {
    before_[eldest.kind].erase(eldest.key);
  } else {
    before_[eldest.kind].insert_or_assign(eldest.key, std::move(eldest.record));
  }
  happenings_.pop_front();
}

void History::drop_old(Time now) {
  while (!happenings_.empty() && happenings_.front().at + span_ < now) drop_eldest();
  while (!samples_.empty() && samples_.front().at + span_ < now) samples_.pop_front();
  if (has_begun_) begin_ = std::max(begin_, now - span_);
}

std::string History::document() const {
  if (!has_begun_) return R"({"begin":null,"before":{},"changes":[],"samples":[]})";
  std::string text = "{";
  if (!recording_.empty()) {
    text += "\"recording\":" + text_json(recording_) + ",\"end\":" + text_json(shell::timestamp(end_)) + ',';
  }
  text += "\"begin\":" + text_json(shell::timestamp(begin_)) + ",\"before\":{\"absence\":" + text_json(absence_before_);
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    text += ",\"" + std::string(kind_words[kind]) + "\":[";
    for (const auto& [key, record] : before_[kind]) text += (text.back() == '[' ? "" : ",") + record;
    text += ']';
  }
  text += "},\"changes\":[";
  for (const Happening& one : happenings_) {
    text += (text.back() == '[' ? "{\"of\":\"" : ",{\"of\":\"") +
            std::string(one.kind == of_daemon ? "daemon" : kind_words[one.kind]) + "\",\"event\":\"" + one.event +
            "\",\"time\":" + text_json(shell::timestamp(one.at)) + ",\"reason\":" + text_json(one.reason) +
            ",\"record\":" + one.record + '}';
  }
  text += "],\"samples\":[";
  for (const Sample& one : samples_) {
    text += (text.back() == '[' ? "[" : ",[") + text_json(shell::timestamp(one.at)) + ',' + one.numbers.substr(1);
  }
  return text + "]}";
}

}  // namespace geminga::web
