#include "web/site/event_stream.hpp"

#include <boost/json/object.hpp>
#include <sstream>
#include <string_view>
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

EventStream::EventStream(Asker& asker, std::vector<Query> questions) : asker_(asker) {
  for (Query& question : questions) {
    std::string key(key_of(question.kind));
    listings_.push_back({.question = std::move(question), .key = std::move(key)});
  }
}

void EventStream::next(Then then) { proceed(0, {}, std::move(then)); }

void EventStream::proceed(std::size_t at, std::string told, Then then) {
  if (at == listings_.size()) {
    const bool is_first = !std::exchange(is_whole_, true);
    if (is_first && listings_.size() > 1) told += message("whole", boost::json::object());
    return then(std::move(told));
  }
  asker_.ask(listings_[at].question,
             [self = shared_from_this(), at, told = std::move(told), then = std::move(then)](
                 const Outcome& outcome) mutable { self->take(at, outcome, std::move(told), std::move(then)); });
}

void EventStream::take(std::size_t at, const Outcome& outcome, std::string told, Then then) {
  if (!outcome->has_value()) return then(told + tell_daemon(outcome->error().text));
  Listing& listing = listings_[at];
  answers::Known now = answers::known_by(listing.key, outcome->value().records);
  if (answers::has_gone(listing.known, now) && listing.key != "id") {
    return explain(at, std::move(now), std::move(told), std::move(then));
  }
  told += tell_daemon("") + tell(listing, std::move(now), {});
  proceed(at + 1, std::move(told), std::move(then));
}

void EventStream::explain(std::size_t at, answers::Known now, std::string told, Then then) {
  const Query all{listings_[at].key == "service" ? "services" : "requests"};
  asker_.ask(all, [self = shared_from_this(), at, now = std::move(now), told = std::move(told),
                   then = std::move(then)](const Outcome& there) {
    // Without an answer the reason is `gone`, and the next call tells that the daemon is away.
    answers::Reasons reasons;
    if (there->has_value()) {
      for (const Record& record : there->value().records) reasons.there.emplace(record[self->listings_[at].key]);
    }
    self->asker_.ask({"participants"}, [self, at, now, told, then, reasons](const Outcome& participants) mutable {
      if (participants->has_value()) {
        for (const Record& record : participants->value().records) reasons.participants.emplace(record["id"]);
      }
      told += self->tell_daemon("") + self->tell(self->listings_[at], std::move(now), reasons);
      self->proceed(at + 1, std::move(told), then);
    });
  });
}

std::string EventStream::tell(Listing& listing, answers::Known now, const answers::Reasons& reasons) {
  const std::string_view name = listings_.size() > 1 ? std::string_view(listing.question.kind) : std::string_view();
  std::string events;
  for (const auto& difference : answers::differences(listing.known, now, reasons)) {
    events += message(name, answers::to_json(difference));
  }
  listing.known = std::move(now);
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
