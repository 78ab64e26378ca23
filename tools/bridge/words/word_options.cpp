#include "bridge/words/word_options.hpp"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <random>
#include <utility>

#include "base/text.hpp"
#include "env/asio/endpoint.hpp"
#include "shell/secret_file.hpp"

namespace geminga::bridge {
namespace {

/// The longest name of a team or site.
constexpr std::size_t max_name = 64;

bool is_name(const std::string& text) {
  return base::is_key(text) && text.size() <= max_name && text.find('.') == std::string::npos;
}

std::expected<client::Endpoint, std::string> endpoint_of(const std::string& flag, const std::string& text) {
  const auto read = env::parse_endpoint(text);
  if (!read) return std::unexpected(flag + ": " + read.error());
  return client::Endpoint{.address = read->address, .port = read->port};
}

}  // namespace

void WordOptions::add_to(CLI::App& app, const std::string& program, const std::string& schemes) {
  app.add_option("URL", url, "The server: " + schemes + "://HOST[:PORT]")->required();
  app.add_option("--team", team, "The name of the team on the server (default: geminga): letters, digits, - and _")
      ->type_name("NAME");
  app.add_option("--site", site, "The name of this site, for people who look at the server")->type_name("NAME");
  app.add_option("--listen", listen,
                 "Where the bridge listens; the daemon names it with --peer (default: 127.0.0.1:4720)")
      ->type_name("ADDRESS:PORT");
  app.add_option("--daemon", daemon, "The UDP port of the daemon (default: 127.0.0.1:4717)")->type_name("ADDRESS:PORT");
  app.add_option("--ca", ca_file, "Trust servers whose certificates these authorities have signed")->type_name("FILE");
  app.add_option("--certificate", certificate, "The certificate that the bridge shows the server, in PEM")
      ->type_name("FILE");
  app.add_option("--certificate-key", certificate_key, "The private key of --certificate, in PEM")->type_name("FILE");
  app.add_option(
         "--user", user,
         "The name by which the bridge logs in; the password is in --password-file, or $GEMINGA_BRIDGE_PASSWORD")
      ->type_name("NAME");
  app.add_option("--password-file", password_file, "The password of --user, in a file that nobody else can read")
      ->type_name("FILE");
  app.set_version_flag("--version", program + " " GEMINGA_VERSION, "Print the version and exit");
}

std::expected<WordSettings, std::string> WordOptions::settings(const std::string& scheme,
                                                               const std::string& secure_scheme, std::uint16_t port,
                                                               std::uint16_t secure_port) const {
  WordSettings made;
  const auto colon = url.find("://");
  const std::string given = url.substr(0, colon);
  made.is_secure = given == secure_scheme;
  if (colon == std::string::npos || (given != scheme && !made.is_secure)) {
    return std::unexpected(base::printable(url) + " is no server: write " + scheme + "://HOST or " + secure_scheme +
                           "://HOST");
  }
  const auto host = env::parse_host_port(url.substr(colon + 3), made.is_secure ? secure_port : port);
  if (!host) return std::unexpected(base::printable(url) + ' ' + host.error());
  made.host = host->host;
  made.port = host->port;
  if (!is_name(team))
    return std::unexpected("--team: " + base::printable(team) + " is no name: letters, digits, - and _");
  if (!is_name(site))
    return std::unexpected("--site: " + base::printable(site) + " is no name: letters, digits, - and _");
  made.team = team;
  std::random_device chance;
  made.site = site + '-' + base::to_hex(chance(), 8);
  if (!ca_file.empty() && !made.is_secure) return std::unexpected("--ca goes with " + secure_scheme + "://");
  made.ca_file = ca_file;
  if (certificate.empty() != certificate_key.empty()) {
    return std::unexpected("--certificate and --certificate-key go together");
  }
  if (!certificate.empty() && !made.is_secure)
    return std::unexpected("--certificate goes with " + secure_scheme + "://");
  made.certificate = certificate;
  made.certificate_key = certificate_key;
  if (user.empty() && !password_file.empty()) return std::unexpected("--password-file goes with --user");
  made.user = user;
  if (!password_file.empty()) {
    auto password = shell::read_secret(password_file);
    if (!password) return std::unexpected("--password-file: " + password.error());
    made.password = std::move(*password);
  } else if (const char* password = std::getenv("GEMINGA_BRIDGE_PASSWORD"); !user.empty() && password != nullptr) {
    made.password = password;
  }
  const auto own = endpoint_of("--listen", listen);
  if (!own) return std::unexpected(own.error());
  const auto its = endpoint_of("--daemon", daemon);
  if (!its) return std::unexpected(its.error());
  if (!env::is_loopback(own->address) || !env::is_loopback(its->address)) {
    return std::unexpected("--listen and --daemon: the daemon is on this host: name loopback addresses");
  }
  made.own = *own;
  made.daemon = *its;
  return made;
}

}  // namespace geminga::bridge
