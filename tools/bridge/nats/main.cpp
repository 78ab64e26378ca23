// geminga-bridge-nats: a server of NATS as a link between daemons that have no other.
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "base/text.hpp"
#include "bridge/cnats/nats_server.hpp"
#include "bridge/words/daemon_socket.hpp"
#include "bridge/words/word_options.hpp"
#include "shell/options.hpp"
#include "shell/report.hpp"
#include "shell/stop_signals.hpp"
#include "shell/whole_lines.hpp"

namespace geminga::bridge {
namespace {

constexpr std::string_view program = "geminga-bridge-nats";

constexpr const char* examples = R"(Examples:
  geminga-bridge-nats nats://base.local --team rescue --site hall
  geminga-bridge nats tls://hub.example --ca team.pem --credentials robot1.creds
  gemingad --interface wlan0 --interface lo --peer 127.0.0.1:4720 --key-file team.key

The daemon names the bridge as its peer. The server then acts as a link: the daemons of all sites hear each other through it. The
bridge sends the daemon's datagrams as they are, sealed with the team's key where there is one. The server sees their sizes and
times; without a key it could also forge them. A server with JetStream keeps the last state of hosts behind a relay, sealed, in the bucket geminga_TEAM, so
that a site that joins later learns it at once. Daemons believe it when the relay has vouched for it, and drop a host at its
deadline. Accounts, clusters and leaf nodes are configured at the server.

Exit status: 0 ended by a signal, 2 wrong usage, or the address of --listen is taken.)";

int fail(const std::string& text) {
  shell::complain(program, text);
  return static_cast<int>(shell::ExitStatus::wrong_use);
}

int run(int argc, char** argv) {
  CLI::App app("Carries the announcements of daemons over a NATS server.", std::string(program));
  app.footer(examples);
  WordOptions options;
  options.add_to(app, std::string(program), "nats|tls");
  NatsServer::Credentials credentials;
  app.add_option("--credentials", credentials.file, "A file with NATS' user credentials (a JWT and an NKey)")
      ->type_name("FILE")
      ->check(CLI::ExistingFile, "", "");
  app.add_option("--nkey", credentials.nkey, "The public NKey by which the bridge logs in; needs --nkey-seed")
      ->type_name("KEY");
  app.add_option("--nkey-seed", credentials.nkey_seed, "A file with the seed of --nkey")
      ->type_name("FILE")
      ->check(CLI::ExistingFile, "", "");
  app.add_option(
         "--jetstream-domain", credentials.domain,
         "The JetStream domain that keeps the states, such as a hub's behind a leaf node (default: the server's own)")
      ->type_name("NAME");
  if (const auto status = shell::parse(app, argc, argv)) return static_cast<int>(*status);
  const auto settings = options.settings("nats", "tls", 4222, 4222);
  if (!settings) return fail(settings.error());
  if (!credentials.domain.empty() &&
      (!base::is_key(credentials.domain) || credentials.domain.find('.') != std::string::npos)) {
    return fail("--jetstream-domain: " + base::printable(credentials.domain) + " is no name: letters, digits, - and _");
  }
  if (credentials.nkey.empty() != credentials.nkey_seed.empty()) return fail("--nkey and --nkey-seed go together");
  if (!credentials.nkey.empty() && !credentials.file.empty()) return fail("--credentials or --nkey, not both");

  const auto log = [](const std::string& line) { shell::complain(program, line); };
  const shell::StopSignals signals;
  client::Reactor reactor(log);
  Tally tally(reactor, log);
  std::optional<NatsServer> server;
  auto daemon = DaemonSocket::open(settings->own, settings->daemon, reactor, tally,
                                   {.word = [&server](DaemonSocket::Word word) { server->say(word); },
                                    .frame = [&server](DaemonSocket::Word frame) { server->keeper().on_frame(frame); },
                                    .began = [&server] { server->keeper().on_daemon_began(); }});
  if (!daemon) return fail(daemon.error());
  server.emplace(reactor, *settings, credentials, tally, **daemon, log);
  const auto started = server->start();
  while (started && signals.wait(reactor.descriptor(), std::nullopt) != shell::StopSignals::Woken::stopped) {
    reactor.process();
  }
  server->leave();
  server.reset();  // its threads give words to the socket
  return started ? static_cast<int>(shell::ExitStatus::found) : fail(started.error());
}

}  // namespace
}  // namespace geminga::bridge

int main(int argc, char** argv) {
  const geminga::shell::WholeLines lines;
  return geminga::bridge::run(argc, argv);
}
