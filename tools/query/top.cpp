// geminga-query top: a live table of the team for a terminal.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <iostream>
#include <memory>
#include <optional>

#include "query/command.hpp"
#include "query/listing.hpp"
#include "query/top/raw_terminal.hpp"
#include "query/top/table_view.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/stop_signals.hpp"

namespace geminga::query {
namespace {

using top::TableView;

/// The least time between two rounds of questions, whatever the user wishes: an eye sees no more.
constexpr std::chrono::milliseconds least_interval{100};

struct TopFlags {
  top::Order order = top::Order::name;
  std::optional<double> interval;
};

/// Asks for all that the table shows.
Result<top::Round, ClientError> ask_round(Client& client) {
  auto status = client.query("status");
  if (!status) return std::unexpected(status.error());
  auto participants = client.query("participants");
  if (!participants) return std::unexpected(participants.error());
  auto unmatched = client.query("requests", {{"unmatched", "1"}});
  if (!unmatched) return std::unexpected(unmatched.error());
  return top::Round{status->records.empty() ? Record() : std::move(status->records.front()),
                    std::move(participants->records), std::move(unmatched->records)};
}

/// The table on a terminal until the user or a signal ends it. It goes on when a daemon that went is there again.
class LiveTable {
 public:
  LiveTable(const Context& context, const TopFlags& flags, Client client)
      : context_(context),
        interval_(std::max(shell::in_milliseconds(flags.interval.value_or(1)), least_interval)),
        view_(flags.order),
        client_(std::move(client)) {}

  shell::ExitStatus run() {
    ask();
    while (show()) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(next_ - Clock::now());
      const auto woken = signals_.wait(STDIN_FILENO, std::max(left, std::chrono::milliseconds(0)), terminal_.changes());
      if (woken == shell::StopSignals::Woken::stopped) break;
      if (terminal_.take_change()) screen_.forget();
      if (!take_keys()) break;
      if (Clock::now() >= next_) ask();
    }
    return shell::ExitStatus::found;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void lose(const ClientError& error) {
    trouble_ = error.text;
    if (error.kind != ClientError::Kind::refused) client_.reset();
  }

  void ask() {
    next_ = Clock::now() + interval_;
    if (!client_) {
      auto client = Client::connect(client_options(context_));
      if (!client) return lose(client.error());
      client_ = std::move(*client);
      tally_.begin_anew();
    }
    auto round = ask_round(*client_);
    if (!round) return lose(round.error());
    trouble_.clear();
    tally_.take(std::move(*round), std::chrono::duration_cast<top::Tally::Time>(Clock::now() - begin_));
  }

  /// False: the user quits, or the terminal is gone.
  bool take_keys() {
    std::string octets;
    if (!terminal_.read(octets)) return false;
    for (const top::Key key : keys_.read(octets)) {
      if (key == '\f') screen_.forget();  // Ctrl-L, as everywhere
      const TableView::Wish wish = view_.press(key, tally_.seen());
      if (wish == TableView::Wish::quit) return false;
      if (wish == TableView::Wish::ask_why) ask_why();
    }
    return true;
  }

  void ask_why() {
    if (!client_) return view_.explain(trouble_);
    const auto answer = client_->query("why", {{"subscription", view_.selected()}});
    if (answer) return view_.explain(tally_.seen(), *answer);
    view_.explain(shell::printable(answer.error().text));
    if (answer.error().kind != ClientError::Kind::refused) lose(answer.error());
  }

  bool show() {
    const top::Size size = top::RawTerminal::size();
    return terminal_.write(screen_.show(view_.lines(tally_.seen(), size, trouble_), size, context_.terminal));
  }

  const Context& context_;
  std::chrono::milliseconds interval_;
  TableView view_;
  std::optional<Client> client_;
  std::string trouble_;
  top::Tally tally_;
  top::Keys keys_;
  top::Screen screen_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point next_ = begin_;
  shell::StopSignals signals_;  // a signal that comes while the terminal is taken waits until it is given back
  top::RawTerminal terminal_;
};

shell::ExitStatus print_once(const Context& context, const TopFlags& flags, Client& client) {
  auto round = ask_round(client);
  if (!round) return shell::report(program, round.error());
  if (context.common.is_json) {
    boost::json::object document;
    document["status"] = shell::to_json(round->status);
    document["participants"] = shell::to_json(round->participants);
    document["unmatched"] = shell::to_json(round->unmatched);
    shell::print(std::cout, document);
    return shell::ExitStatus::found;
  }
  top::Tally tally;
  tally.take(std::move(*round), {});
  for (const top::Line& line : TableView(flags.order).whole(tally.seen())) std::cout << line.text << '\n';
  return shell::ExitStatus::found;
}

shell::ExitStatus run_top(const Context& context, const TopFlags& flags) {
  if (refuses_watch(context, "top")) return shell::ExitStatus::wrong_use;
  auto client = Client::connect(client_options(context));
  if (!client) return shell::report(program, client.error());
  if (context.common.is_json || !top::RawTerminal::is_there()) return print_once(context, flags, *client);
  return LiveTable(context, flags, std::move(*client)).run();
}

}  // namespace

void add_top(CLI::App& app, RunAlone& selected) {
  CLI::App* command =
      app.add_subcommand("top", "Show a live table of the team on a terminal: robots, loss, unmatched requests");
  const auto flags = std::make_shared<TopFlags>();
  command
      ->add_option_function<std::string>(
          "--sort",
          [flags](const std::string& word) {
            const auto order = top::order_of(word);
            if (!order) throw CLI::ValidationError("--sort", "must be name, heard, loss or services");
            flags->order = *order;
          },
          "The order of the robots at first (default: name)")
      ->type_name("name|heard|loss|services");
  shell::add_seconds(*command, "--interval", flags->interval, "The time between two rounds of questions (default: 1)");
  command->footer(
      "Examples:\n  geminga-query top\n  geminga-query top --sort loss --interval 5\n  geminga-query top | head\n"
      "Keys: q quits; n, h, l and s sort by name, time since heard, loss and services, r reverses; up and down (or k "
      "and "
      "j)\nselect a request, enter (or w) asks why nobody serves it. It goes on when a lost daemon is "
      "back. "
      "Without a\nterminal it prints one table and ends.");
  command->callback(
      [flags, &selected] { selected = [flags](const Context& context) { return run_top(context, *flags); }; });
}

}  // namespace geminga::query
