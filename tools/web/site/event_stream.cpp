#include "web/site/event_stream.hpp"

#include <boost/json/object.hpp>
#include <sstream>
#include <utility>

#include "shell/json.hpp"
#include "web/site/api.hpp"

namespace geminga::web {
namespace {

/// One event. A document has no line ends within it.
std::string message(std::string_view name, const boost::json::value& value) {
  std::ostringstream out;
  if (!name.empty()) out << "event: " << name << '\n';
  out << "data: ";
  shell::print(out, value);
  out << '\n';
  return std::move(out).str();
}

}  // namespace

EventStream::EventStream(Asker& asker, Query question)
    : asker_(asker), question_(std::move(question)), key_(key_of(question_.kind)) {}

void EventStream::next(Then then) {
  asker_.ask(question_, [self = shared_from_this(), then = std::move(then)](const Outcome& outcome) {
    self->take(outcome, then);
  });
}

void EventStream::take(const Outcome& outcome, const Then& then) {
  if (!outcome->has_value()) return then(tell_daemon(outcome->error().text));
  answers::Known now = answers::known_by(key_, outcome->value().records);
  if (!answers::has_gone(known_, now) || key_ == "id") return then(tell_daemon("") + tell(std::move(now), {}));
  explain(std::move(now), then);
}

void EventStream::explain(answers::Known now, Then then) {
  const Query all{key_ == "service" ? "services" : "requests"};
  asker_.ask(all, [self = shared_from_this(), now = std::move(now), then = std::move(then)](const Outcome& there) {
    // Without an answer the reason is `gone`, and the next call tells that the daemon is away.
    answers::Reasons reasons;
    if (there->has_value()) {
      for (const Record& record : there->value().records) reasons.there.emplace(record[self->key_]);
    }
    self->asker_.ask({"participants"}, [self, now, then, reasons](const Outcome& participants) mutable {
      if (participants->has_value()) {
        for (const Record& record : participants->value().records) reasons.participants.emplace(record["id"]);
      }
      then(self->tell_daemon("") + self->tell(std::move(now), reasons));
    });
  });
}

std::string EventStream::tell(answers::Known now, const answers::Reasons& reasons) {
  std::string events;
  for (const auto& difference : answers::differences(known_, now, reasons)) {
    events += message("", answers::to_json(difference));
  }
  known_ = std::move(now);
  return events;
}

std::string EventStream::tell_daemon(const std::string& absence) {
  const bool is_up = absence.empty();
  if (is_up == std::exchange(was_up_, is_up)) return {};
  boost::json::object object{{"up", is_up}};
  if (!is_up) object["reason"] = absence;
  return message("daemon", object);
}

}  // namespace geminga::web
