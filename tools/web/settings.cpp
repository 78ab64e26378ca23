#include "web/settings.hpp"

#include "base/text.hpp"
#include "client/cpp/stated_endpoints.hpp"
#include "shell/secret_file.hpp"
#include "web/site/gate.hpp"

namespace geminga::web {

void Flags::add_to(CLI::App& app) {
  common.add_without_json_to(app, "How long a request waits for the daemon's answer (default: 5)");
  app.add_option("--listen", listen,
                 "Where to listen (default: 127.0.0.1:4780, or with --socket no address). An address that other hosts "
                 "reach needs --token-file")
      ->type_name("ADDRESS:PORT");
  app.add_option(
         "--socket", socket,
         "Listen at a Unix socket, which this user and group may use; requests need the token there, too, if there is "
         "one")
      ->type_name("PATH");
  app.add_option("--token-file", token_file,
                 "A file with the secret that each request has to bring as Authorization: Bearer TOKEN, except for "
                 "/livez: 16 to 256 characters, readable by its owner only")
      ->type_name("FILE");
  app.add_option(
         "--host", names,
         "A name of this host that requests may use, beside localhost and its numeric addresses; may be given several "
         "times")
      ->type_name("NAME")
      ->allow_extra_args(false);
  app.add_option("--rules", alert_rules,
                 "Alert rules in TOML (geminga-query alerts --help): those that do not hold are on the page, in "
                 "/api/alerts and in /metrics")
      ->type_name("FILE");
  CLI::Option* shown = app.add_option("--recording", this->recording,
                                      "Show this recording (geminga-query record) on the page instead of a daemon; the "
                                      "page can go back and forth in it")
                           ->type_name("FILE");
  app.add_option("--history", history_minutes,
                 "How long the page can look back (default: 60, 1440 at most). 0: nothing is kept, and the daemon is "
                 "asked only when a request comes")
      ->type_name("MINUTES")
      ->check(shell::whole_number(0, std::chrono::duration_cast<std::chrono::minutes>(longest_history).count()), "", "")
      ->excludes(shown);
}

std::expected<Settings, std::string> settings_of(const Flags& flags) {
  Settings settings{.listen = std::nullopt,
                    .socket = flags.socket,
                    .rules = {},
                    .daemon = {},
                    .recording = flags.recording,
                    .alert_rules = {},
                    .history = std::chrono::minutes(flags.history_minutes)};
  if (!settings.recording.empty()) settings.history = whole_recording;
  if (!flags.listen.empty() || flags.socket.empty()) {
    const std::string text = flags.listen.empty() ? std::string(usual_listen) : flags.listen;
    const auto endpoint = env::parse_endpoint(text);
    if (!endpoint) return std::unexpected("--listen: " + endpoint.error());
    settings.listen = *endpoint;
  }
  for (const std::string& name : flags.names) {
    const auto host = host_of(name);
    if (!host) return std::unexpected("--host: " + name + " is no name of a host: write it without port");
    settings.rules.names.push_back(*host);
  }
  if (!flags.token_file.empty()) {
    auto token = shell::read_secret(flags.token_file);
    if (!token) return std::unexpected("--token-file: " + token.error());
    if (const auto complaint = complaint_about_token(*token); !complaint.empty()) {
      return std::unexpected("--token-file: " + flags.token_file + ": the token " + complaint +
                             ": make one with openssl rand -hex 32");
    }
    settings.rules.token = std::move(*token);
  }
  if (settings.listen && !env::is_loopback(settings.listen->address) && settings.rules.token.empty()) {
    return std::unexpected("--listen: other hosts reach " + settings.listen->address +
                           ": give --token-file, too, or listen on 127.0.0.1");
  }
  if (!flags.alert_rules.empty()) {
    auto rules = query::alerts::read_rules_file(flags.alert_rules);
    if (!rules) return std::unexpected("--rules: " + base::joined(rules.error(), "; "));
    settings.alert_rules = std::move(*rules);
  }
  const auto daemon = client::stated_endpoints(flags.common.connect);
  if (!daemon) return std::unexpected(daemon.error().text);
  settings.daemon = *daemon;
  return settings;
}

}  // namespace geminga::web
