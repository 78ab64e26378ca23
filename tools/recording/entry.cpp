#include "recording/entry.hpp"

#include <array>
#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <boost/json/parse.hpp>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include "base/text.hpp"
#include "recording/moment.hpp"
#include "recording/record_json.hpp"
#include "shell/json.hpp"
#include "shell/timestamp.hpp"

namespace geminga::recording {
namespace {

namespace json = boost::json;

constexpr std::array<std::string_view, 3> changes{"there", "add", "modify"};

/// The longest time from the beginning: a century, so that no sum of times can overflow.
constexpr double most_seconds = 100.0 * 366 * 24 * 3600;

/// Writes the members of an event behind `event`, `time` and `at`.
struct Members {
  json::object& line;

  void operator()(const Snapshot& snapshot) const {
    line["format"] = format_name;
    line["version"] = format_version;
    line["participant"] = snapshot.participant;
    line["name"] = snapshot.name;
    line["ontology"] = snapshot.ontology;
    line["records"] = snapshot.records;
  }
  void operator()(const Present& present) const {
    line["kind"] = present.record.kind;
    line["record"] = shell::to_json(present.record);
  }
  void operator()(const Gone& gone) const {
    line["kind"] = gone.kind;
    line["key"] = gone.key;
    line["reason"] = gone.reason;
  }
  void operator()(const Heard& heard) const { line["records"] = shell::to_json(heard.records); }
  void operator()(const Answered& answered) const {
    line["kind"] = answered.kind;
    if (!answered.subscription.empty()) line["subscription"] = answered.subscription;
    line["records"] = shell::to_json(answered.answer.records);
    line["end"] = shell::to_json(answered.answer.end);
  }
  void operator()(const Skipped& skipped) const { line["rounds"] = skipped.rounds; }
  void operator()(const Lost& lost) const { line["text"] = lost.text; }
  void operator()(const End& end) const { line["reason"] = end.reason; }
  void operator()(const Unknown&) const {}
};

std::string_view name_of(const Event& event) {
  if (const auto* present = std::get_if<Present>(&event)) return changes[static_cast<std::size_t>(present->change)];
  static constexpr std::array<std::string_view, 9> names{"snapshot", "",     "del", "heard",  "answer",
                                                         "skipped",  "lost", "end", "unknown"};
  return names[event.index()];
}

/// An object whose members are asked for one by one. After the first that is missing or of another type it says which.
class Fields {
 public:
  explicit Fields(const json::object& object) : object_(object) {}

  std::string text(std::string_view key) {
    const auto* value = find(key);
    const auto* text = value == nullptr ? nullptr : value->if_string();
    if (text == nullptr) return complain(key, "is no text"), std::string();
    return std::string(std::string_view(*text));
  }
  std::size_t count(std::string_view key) {
    const auto* value = find(key);
    const auto* number = value == nullptr ? nullptr : value->if_int64();
    if (number == nullptr || *number < 0) return complain(key, "is no count"), std::size_t{0};
    return static_cast<std::size_t>(*number);
  }
  At seconds(std::string_view key) {
    const auto* value = find(key);
    const double number = value == nullptr || !value->is_number() ? -1 : value->to_number<double>();
    if (!(number >= 0 && number <= most_seconds)) return complain(key, "is no time in seconds"), At();
    return At(std::llround(number * 1000));
  }
  Record record(std::string_view kind, std::string_view key) {
    const auto* value = find(key);
    const auto* object = value == nullptr ? nullptr : value->if_object();
    if (object == nullptr) return complain(key, "is no object"), Record();
    return taken(kind, *object);
  }
  std::vector<Record> records(std::string_view kind, std::string_view key) {
    std::vector<Record> records;
    const auto* value = find(key);
    const auto* list = value == nullptr ? nullptr : value->if_array();
    if (list == nullptr) return complain(key, "is no list"), records;
    for (const json::value& one : *list) {
      if (!one.is_object()) return complain(key, "has an element that is no object"), records;
      records.push_back(taken(kind, one.get_object()));
    }
    return records;
  }
  [[nodiscard]] bool has(std::string_view key) const { return object_.contains(key); }
  [[nodiscard]] const std::string& complaint() const { return complaint_; }

 private:
  const json::value* find(std::string_view key) const { return object_.if_contains(key); }
  void complain(std::string_view key, std::string_view what) {
    if (complaint_.empty()) complaint_ = "'" + std::string(key) + "' " + std::string(has(key) ? what : "is missing");
  }
  Record taken(std::string_view kind, const json::object& object) {
    auto record = record_of(kind, object);
    if (record) return std::move(*record);
    if (complaint_.empty()) complaint_ = record.error();
    return {};
  }

  const json::object& object_;
  std::string complaint_;
};

/// The event of this name; the members that it lacks are complained about in `fields`.
Event event_of(std::string_view name, Fields& fields) {
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (name != changes[i]) continue;
    return Present{static_cast<Present::Change>(i), fields.record(fields.text("kind"), "record")};
  }
  if (name == "snapshot") {
    return Snapshot{fields.text("participant"), fields.text("name"), fields.text("ontology"), fields.count("records")};
  }
  if (name == "del") return Gone{fields.text("kind"), fields.text("key"), fields.text("reason")};
  if (name == "heard") return Heard{fields.records("participants", "records")};
  if (name == "answer") {
    Answered answered{fields.text("kind"), fields.has("subscription") ? fields.text("subscription") : "", {}};
    answered.answer = {fields.records(answered.kind, "records"), fields.record("end", "end")};
    return answered;
  }
  if (name == "skipped") return Skipped{fields.count("rounds")};
  if (name == "lost") return Lost{fields.text("text")};
  if (name == "end") return End{fields.text("reason")};
  return Unknown{};
}

/// The reason why an event of which nothing is missing cannot be used; empty: it can.
std::string fault_of(const Event& event) {
  if (const auto* present = std::get_if<Present>(&event)) {
    const std::string_view key = key_field(present->record.kind);
    if (key.empty()) return "'kind' is not participants, services or requests";
    if (present->record[key].empty()) return "the record has no '" + std::string(key) + "'";
  }
  if (const auto* gone = std::get_if<Gone>(&event); gone != nullptr && key_field(gone->kind).empty()) {
    return "'kind' is not participants, services or requests";
  }
  if (const auto* answered = std::get_if<Answered>(&event); answered != nullptr && !base::is_key(answered->kind)) {
    return "'kind' is no word";
  }
  return "";
}

/// The version where the line is a snapshot of another one.
std::optional<BadLine> other_version(const json::object& object) {
  const auto* format = object.if_contains("format");
  const auto* version = object.if_contains("version");
  if (format == nullptr || *format != json::value(format_name) || version == nullptr) return std::nullopt;
  if (version->is_int64() && version->get_int64() == format_version) return std::nullopt;
  const std::string number = version->is_int64() ? ' ' + std::to_string(version->get_int64()) : "";
  return BadLine{"the recording has another version" + number + ", and this program reads version " +
                     std::to_string(format_version) + ": use the geminga-query that made it",
                 true};
}

}  // namespace

std::string_view key_field(std::string_view kind) {
  if (kind == "participants") return "id";
  if (kind == "services") return "service";
  return kind == "requests" ? "subscription" : "";
}

std::string line_of(const Entry& entry) {
  json::object line;
  line["event"] = name_of(entry.event);
  line["time"] = shell::timestamp(entry.time);
  line["at"] = static_cast<double>(entry.at.count()) / 1000;
  std::visit(Members{line}, entry.event);
  std::ostringstream out;
  shell::print(out, line);
  return std::move(out).str();
}

std::expected<Entry, BadLine> read_line(std::string_view line) {
  boost::system::error_code error;
  const json::value value = json::parse(line, error);
  if (error || !value.is_object()) return std::unexpected(BadLine{"is no JSON object, or only the beginning of one"});
  const json::object& object = value.get_object();
  if (auto bad = other_version(object)) return std::unexpected(std::move(*bad));
  Fields fields(object);
  Entry entry;
  const std::string name = fields.text("event");
  entry.at = fields.seconds("at");
  const std::string time = fields.text("time");
  entry.event = event_of(name, fields);
  if (!fields.complaint().empty()) return std::unexpected(BadLine{fields.complaint()});
  if (name == "snapshot" && !fields.has("version")) return std::unexpected(BadLine{"'version' is missing"});
  const auto instant = parse_time(time);
  if (!instant) return std::unexpected(BadLine{"'time' is no time of RFC 3339 in UTC"});
  entry.time = *instant;
  if (std::string fault = fault_of(entry.event); !fault.empty()) return std::unexpected(BadLine{std::move(fault)});
  return entry;
}

}  // namespace geminga::recording
