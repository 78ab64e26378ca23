// geminga-bridge-mqtt: a server of MQTT as a link between daemons that have no other.
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "bridge/mosquitto/mqtt_server.hpp"
#include "bridge/words/daemon_socket.hpp"
#include "bridge/words/word_options.hpp"
#include "shell/options.hpp"
#include "shell/report.hpp"
#include "shell/stop_signals.hpp"
#include "shell/whole_lines.hpp"

namespace geminga::bridge {
namespace {

constexpr std::string_view program = "geminga-bridge-mqtt";

constexpr const char* examples = R"(Examples:
  geminga-bridge-mqtt mqtt://base.local --team rescue --site hall
  geminga-bridge mqtt mqtts://broker.example --ca team.pem --user robot1
  gemingad --interface wlan0 --interface lo --peer 127.0.0.1:4720 --key-file team.key

The daemon names the bridge as its peer. The server then acts as a link: the daemons of all sites hear each other through it. The
bridge sends the daemon's datagrams as they are, sealed with the team's key where there is one. The server sees their sizes and
times; without a key it could also forge them. The broker retains the last state of hosts behind a relay, sealed, below geminga/TEAM/kept, so that a
site that joins later learns it at once. Daemons believe it when the relay has vouched for it, and drop a host at its deadline. The
names of the sites are retained below geminga/TEAM/site, and removed by last wills.

Exit status: 0 ended by a signal, 2 wrong usage, or the address of --listen is taken.)";

int fail(const std::string& text) {
  shell::complain(program, text);
  return static_cast<int>(shell::ExitStatus::wrong_use);
}

int run(int argc, char** argv) {
  CLI::App app("Carries the announcements of daemons over an MQTT server.", std::string(program));
  app.footer(examples);
  WordOptions options;
  options.add_to(app, std::string(program), "mqtt|mqtts");
  std::string version = "3.1.1";
  app.add_option("--mqtt", version, "The version of MQTT that the server speaks (default: 3.1.1)")
      ->type_name("3.1.1|5")
      ->check(CLI::IsMember({"3.1.1", "5"}), "", "");
  if (const auto status = shell::parse(app, argc, argv)) return static_cast<int>(*status);
  const auto settings = options.settings("mqtt", "mqtts", 1883, 8883);
  if (!settings) return fail(settings.error());

  const auto log = [](const std::string& line) { shell::complain(program, line); };
  const shell::StopSignals signals;
  client::Reactor reactor(log);
  Tally tally(reactor, log);
  std::unique_ptr<DaemonSocket> daemon;
  MqttServer server(reactor, *settings, version == "5" ? MqttServer::Version::v5 : MqttServer::Version::v3_1_1, tally,
                    {.word =
                         [&](DaemonSocket::Word word) {
                           const auto given = daemon->give(word);
                           if (given == DaemonSocket::Given::too_long) tally.count("words of no size that a word has");
                           if (given == DaemonSocket::Given::too_many) tally.count("words over the limit of a second");
                         },
                     .log = log});
  auto opened = DaemonSocket::open(settings->own, settings->daemon, reactor, tally,
                                   {.word = [&server](DaemonSocket::Word word) { server.say(word); },
                                    .frame = [&server](DaemonSocket::Word frame) { server.keeper().on_frame(frame); },
                                    .began = [&server] { server.keeper().on_daemon_began(); }});
  if (!opened) return fail(opened.error());
  daemon = std::move(*opened);
  server.keeper().set_daemon(*daemon);
  if (const auto started = server.start(); !started) return fail(started.error());
  while (signals.wait(reactor.descriptor(), std::nullopt) != shell::StopSignals::Woken::stopped) reactor.process();
  server.leave();
  return static_cast<int>(shell::ExitStatus::found);
}

}  // namespace
}  // namespace geminga::bridge

int main(int argc, char** argv) {
  const geminga::shell::WholeLines lines;
  return geminga::bridge::run(argc, argv);
}
