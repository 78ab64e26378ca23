// geminga-query --watch: asks again and again, and prints the differences.
#include <iostream>
#include <utility>

#include "answers/differences.hpp"
#include "query/listing.hpp"
#include "shell/changes.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/stop_signals.hpp"
#include "shell/timestamp.hpp"

namespace geminga::query {
namespace {

using answers::Difference;
using answers::Known;

class Printer {
 public:
  Printer(const Context& context, const Listing& listing) : context_(context), listing_(listing) {}

  void operator()(const Difference& difference) const {
    if (context_.common.is_json) return shell::print(std::cout, answers::to_json(difference));
    switch (difference.kind) {
      case Difference::Kind::add:
        return print("+", shell::Colour::green, *difference.record, {});
      case Difference::Kind::modify:
        return print("~", shell::Colour::yellow, *difference.record, "  (" + shell::words_of(difference.former) + ')');
      case Difference::Kind::del:
        return print("-", shell::Colour::red, *difference.record, "  " + std::string(difference.reason));
    }
  }

 private:
  void print(std::string_view sign, shell::Colour colour, const Record& record, const std::string& words) const {
    const std::string stamp = context_.has_timestamps ? shell::timestamp() + ' ' : "";
    const std::string line = stamp + std::string(sign) + ' ' + shell::printable(listing_.line(record) + words);
    std::cout << shell::coloured(context_.terminal, colour, shell::encoded(context_.terminal, line)) << '\n'
              << std::flush;
  }

  const Context& context_;
  const Listing& listing_;
};

/// The reasons why records left the listing. The daemon is asked where a record is gone.
answers::Reasons reasons_of(Client& client, const Listing& listing, bool has_gone) {
  answers::Reasons reasons;
  if (!has_gone || listing.key == "id") return reasons;
  // Without an answer (the daemon may be ending) the reason is "gone", and the next round reports the error.
  if (const auto all = client.query(listing.key == "service" ? "services" : "requests")) {
    for (const Record& record : all->records) reasons.there.emplace(record[listing.key]);
  }
  if (const auto all = client.query("participants")) {
    for (const Record& record : all->records) reasons.participants.emplace(record["id"]);
  }
  return reasons;
}

}  // namespace

shell::ExitStatus watch(const Context& context, Client& client, const Listing& listing) {
  const shell::StopSignals signals;
  const Printer print(context, listing);
  Known known;
  while (true) {
    auto records = ask(client, listing);
    if (!records) return shell::report(program, records.error());
    Known now = answers::known_by(listing.key, std::move(*records));
    const auto reasons = reasons_of(client, listing, answers::has_gone(known, now));
    for (const Difference& difference : answers::differences(known, now, reasons)) print(difference);
    known = std::move(now);
    if (!std::cout) return shell::ExitStatus::wrong_use;
    if (signals.wait(client.file_descriptor(), answers::watch_pause) == shell::StopSignals::Woken::stopped) {
      return shell::ExitStatus::found;
    }
  }
}

}  // namespace geminga::query
