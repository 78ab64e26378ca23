// geminga-web: metrics, health and the daemon's answers over HTTP.
#include <CLI/CLI.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <chrono>
#include <csignal>
#include <iostream>
#include <string>

#include "answers/differences.hpp"
#include "client/channels/reactor.hpp"
#include "shell/report.hpp"
#include "shell/whole_lines.hpp"
#include "web/asking/daemon_asker.hpp"
#include "web/examining/background_doctor.hpp"
#include "web/recording.hpp"
#include "web/server/event_loop.hpp"
#include "web/server/server.hpp"
#include "web/settings.hpp"
#include "web/site/history.hpp"
#include "web/site/site.hpp"

namespace geminga::web {
namespace {

constexpr const char* examples = R"(Examples:
  geminga-web --connect /run/geminga/gcnp
  curl http://127.0.0.1:4780/metrics
  curl 'http://127.0.0.1:4780/api/match?concept=soccer:TrackedObject&limit=3'
  curl -N 'http://127.0.0.1:4780/api/events?of=services'
  geminga-web --socket /run/geminga-web/http
  geminga-web --recording field-test.jsonl
  geminga-web --rules alerts.toml
  geminga-web --listen 192.0.2.7:4780 --token-file /etc/geminga/web.token --host robot2.local

/ is a live page of the team for a browser, which shows problems first. /metrics is in OpenMetrics. /livez answers 200 while the
program runs; /readyz answers 200 while the daemon answers and is up to date, else 503 and the reason. /api/participants, services,
requests, match, explain, why, ontology, status and security print what geminga-query --json prints, with the keys of query, as in
/api/requests?unmatched=1. /api/concepts, taxonomy and hearing answer the queries of these names. /api/doctor prints what
geminga-query --json doctor prints. /api/events?of=services (or participants, requests) sends the objects of geminga-query --watch
--json as server-sent events. /api/history is what has changed in the last hour, and /api/alerts the state of each rule of --rules.

It also runs without a daemon, and connects when there is one. HTTP changes nothing and encrypts nothing: on a shared network, put a
tunnel or a TLS proxy before it.

Exit status: 0 ended by a signal, 2 wrong usage, or the address is taken.)";

int serve(const Flags& flags, const Settings& settings) {
  boost::asio::io_context context(1);
  client::Reactor reactor([](const std::string& reason) { shell::complain(program, reason); });
  DaemonAsker asker(reactor, settings.daemon, flags.common.timeout_or(std::chrono::seconds(5)));
  History history(asker, settings.history);
  if (!settings.recording.empty()) {
    if (const auto read = read_recording(settings.recording, history); !read) {
      shell::complain(program, "--recording: " + read.error());
      return static_cast<int>(shell::ExitStatus::wrong_use);
    }
  }
  ClientOptions connection;
  connection.connect = flags.common.connect;
  connection.name = std::string(program);
  connection.timeout = flags.common.timeout_or(std::chrono::seconds(5));
  BackgroundDoctor doctor(context, connection, GEMINGA_VERSION);
  Alerting alerting(asker, settings.alert_rules);
  Site site(
      asker, history, settings.rules,
      [&doctor](auto then) { doctor.ask([then](const Examined& examined) { then(*examined); }); }, &alerting);
  Server server(context, site);
  std::string places;
  if (settings.listen) {
    if (const auto listening = server.listen(*settings.listen); !listening) {
      shell::complain(program, listening.error());
      return static_cast<int>(shell::ExitStatus::wrong_use);
    }
    places = "http://" + env::to_string(*settings.listen) + '/';
  }
  if (!settings.socket.empty()) {
    if (const auto listening = server.listen(settings.socket); !listening) {
      shell::complain(program, "--socket: " + listening.error());
      return static_cast<int>(shell::ExitStatus::wrong_use);
    }
    places += (places.empty() ? "" : " and ") + settings.socket;
  }
  boost::asio::signal_set signals(context, SIGINT, SIGTERM, SIGHUP);
  signals.async_wait([&context](const boost::system::error_code&, int) { context.stop(); });
  const EventLoop loop(context, reactor);
  client::Reactor::Timer looking(reactor, [&] {
    history.look(std::chrono::system_clock::now());
    looking.set(reactor.now() + history_pause);
  });
  client::Reactor::Timer alarming(reactor, [&] {
    alerting.look(reactor.now());
    alarming.set(reactor.now() + answers::watch_pause);
  });
  if (settings.recording.empty()) {
    asker.start();
    if (alerting.has_rules()) alarming.set(reactor.now());
    if (history.keeps_anything()) looking.set(reactor.now());
  }
  server.serve();
  shell::complain(program, "serving " + places);
  context.run();
  return static_cast<int>(shell::ExitStatus::found);
}

int run(int argc, char** argv) {
  CLI::App app("Serves metrics, health and the answers of the local Geminga daemon over HTTP.", std::string(program));
  app.footer(examples);
  Flags flags;
  flags.add_to(app);
  if (const auto status = shell::parse(app, argc, argv)) return static_cast<int>(*status);
  const auto settings = settings_of(flags);
  if (!settings) {
    shell::complain(program, settings.error());
    return static_cast<int>(shell::ExitStatus::wrong_use);
  }
  return serve(flags, *settings);
}

}  // namespace
}  // namespace geminga::web

int main(int argc, char** argv) {
  const geminga::shell::WholeLines lines;
  return geminga::web::run(argc, argv);
}
