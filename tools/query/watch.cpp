// geminga-query --watch: asks again and again, and prints the differences.
#include <array>
#include <boost/json/object.hpp>
#include <iostream>
#include <map>
#include <set>

#include "query/listing.hpp"
#include "shell/changes.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/stop_signals.hpp"
#include "shell/timestamp.hpp"

namespace geminga::query {
namespace {

/// The pause between two questions. Shorter: changes are shown sooner, and the daemon has more work. Longer: the
/// reverse. A reader notices no shorter delay.
constexpr std::chrono::milliseconds pause{250};

/// Fields that change with every announcement, which is not shown.
constexpr std::array<std::string_view, 3> restless{"age", "heard", "loss"};

using Known = std::map<std::string, Record, std::less<>>;

/// The record as an object without the restless fields.
boost::json::object steady(const Record& record) {
  auto object = shell::to_json(record);
  for (const auto key : restless) object.erase(key);
  return object;
}

class Printer {
 public:
  Printer(const Context& context, const Listing& listing) : context_(context), listing_(listing) {}

  void tell_new(const Record& record) const { print("add", "+", shell::Colour::green, record); }

  void tell_changed(const Record& before, const Record& record) const {
    auto former = shell::former(steady(before), steady(record));
    if (former.empty()) return;
    const std::string words = "  (" + shell::words_of(former) + ')';
    print("modify", "~", shell::Colour::yellow, record, words, {{"former", std::move(former)}});
  }

  void tell_gone(const Record& record, std::string_view reason) const {
    print("del", "-", shell::Colour::red, record, "  " + std::string(reason), {{"reason", reason}});
  }

 private:
  void print(std::string_view event, std::string_view sign, shell::Colour colour, const Record& record,
             const std::string& words = {}, const boost::json::object& more = {}) const {
    if (context_.common.is_json) {
      boost::json::object object{{"event", event}};
      for (const auto& member : more) object.insert(member);
      for (const auto& member : shell::to_json(record)) object.insert(member);
      shell::print(std::cout, shell::stamped(object));
      return;
    }
    const std::string stamp = context_.has_timestamps ? shell::timestamp() + ' ' : "";
    const std::string line = stamp + std::string(sign) + ' ' + shell::printable(listing_.line(record) + words);
    std::cout << shell::coloured(context_.terminal, colour, shell::encoded(context_.terminal, line)) << '\n'
              << std::flush;
  }

  const Context& context_;
  const Listing& listing_;
};

/// Reasons why records left the listing. The daemon is asked once a round, and only where a record is gone.
class Reasons {
 public:
  Reasons(Client& client, const Listing& listing) : client_(client), listing_(listing) {}

  std::string_view operator()(const std::string& key) {
    if (listing_.key == "id") return "gone";
    if (!is_asked_) ask();
    is_asked_ = true;
    if (there_.contains(key)) return "changed";
    return participants_.contains(key.substr(0, key.find('/'))) ? "withdrawn" : "gone";
  }

 private:
  void ask() {
    // Without an answer (the daemon may be ending) the reason is "gone", and the next round reports the error.
    if (const auto all = client_.query(listing_.key == "service" ? "services" : "requests")) {
      for (const Record& record : all->records) there_.emplace(record[listing_.key]);
    }
    if (const auto all = client_.query("participants")) {
      for (const Record& record : all->records) participants_.emplace(record["id"]);
    }
  }

  Client& client_;
  const Listing& listing_;
  bool is_asked_ = false;
  std::set<std::string, std::less<>> there_;
  std::set<std::string, std::less<>> participants_;
};

void print_changes(const Printer& printer, const Known& before, const Known& after, Reasons reasons) {
  for (const auto& [key, record] : before) {
    if (!after.contains(key)) printer.tell_gone(record, reasons(key));
  }
  for (const auto& [key, record] : after) {
    const auto old = before.find(key);
    if (old == before.end()) {
      printer.tell_new(record);
    } else {
      printer.tell_changed(old->second, record);
    }
  }
}

}  // namespace

shell::ExitStatus watch(const Context& context, Client& client, const Listing& listing) {
  const shell::StopSignals signals;
  const Printer printer(context, listing);
  Known known;
  while (true) {
    auto records = ask(client, listing);
    if (!records) return shell::report(program, records.error());
    Known now;
    for (auto& record : *records) {
      std::string key(record[listing.key]);
      now.insert_or_assign(std::move(key), std::move(record));
    }
    print_changes(printer, known, now, Reasons(client, listing));
    known = std::move(now);
    if (!std::cout) return shell::ExitStatus::wrong_use;
    if (signals.wait(client.file_descriptor(), pause) == shell::StopSignals::Woken::stopped) {
      return shell::ExitStatus::found;
    }
  }
}

}  // namespace geminga::query
