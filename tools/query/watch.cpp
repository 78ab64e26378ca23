// geminga-query --watch: asks again and again, and prints what is different.
#include <algorithm>
#include <array>
#include <iostream>
#include <map>

#include "query/listing.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/stop_signals.hpp"

namespace geminga::query {
namespace {

/// Shorter: changes are seen sooner, more work for the daemon. Longer: the reverse. A reader sees no delay below this.
constexpr std::chrono::milliseconds pause{250};

/// Fields that change with every announcement and tell nothing by it.
constexpr std::array<std::string_view, 3> restless{"age", "heard", "loss"};

using Known = std::map<std::string, Record, std::less<>>;

bool is_same(const Record& a, const Record& b) {
  const auto counts = [](const auto& field) { return std::ranges::find(restless, field.first) == restless.end(); };
  std::vector<std::pair<std::string, std::string>> left;
  std::vector<std::pair<std::string, std::string>> right;
  std::ranges::copy_if(a.fields, std::back_inserter(left), counts);
  std::ranges::copy_if(b.fields, std::back_inserter(right), counts);
  return left == right && a.attributes == b.attributes;
}

class Printer {
 public:
  Printer(const Context& context, const Listing& listing) : context_(context), listing_(listing) {}

  void print(std::string_view event, std::string_view sign, shell::Colour colour, const Record& record) const {
    if (context_.common.is_json) {
      boost::json::object object{{"event", event}};
      if (event == "del") {
        object[listing_.key] = record[listing_.key];
      } else {
        for (auto& member : shell::to_json(record)) object[member.key()] = member.value();
      }
      shell::print(std::cout, object);
      return;
    }
    const std::string line = std::string(sign) + ' ' + shell::printable(listing_.line(record));
    std::cout << shell::coloured(context_.terminal, colour, line) << std::endl;
  }

 private:
  const Context& context_;
  const Listing& listing_;
};

void print_changes(const Printer& printer, const Known& before, const Known& after) {
  for (const auto& [key, record] : before) {
    if (!after.contains(key)) printer.print("del", "-", shell::Colour::red, record);
  }
  for (const auto& [key, record] : after) {
    const auto old = before.find(key);
    if (old == before.end()) {
      printer.print("add", "+", shell::Colour::green, record);
    } else if (!is_same(old->second, record)) {
      printer.print("modify", "~", shell::Colour::yellow, record);
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
    print_changes(printer, known, now);
    known = std::move(now);
    if (signals.wait(client.file_descriptor(), pause) == shell::StopSignals::Woken::stopped) {
      return shell::ExitStatus::found;
    }
  }
}

}  // namespace geminga::query
