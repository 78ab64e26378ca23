// The configuration as text.
#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "base/harmless.hpp"
#include "base/text.hpp"
#include "daemon/configuration/configuration.hpp"

namespace geminga::daemon {
namespace {

/// A TOML basic string (TOML 1.0, "String").
std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto octet = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (octet < 0x20 || octet == 0x7f) {
      result += "\\u" + base::to_hex(octet, 4);
    } else {
      result += c;
    }
  }
  return base::harmless_json(result + '"');  // TOML has the escapes of JSON
}

std::string in_quotes(const std::vector<std::string>& texts) {
  std::string result = "[";
  for (const std::string& text : texts) result += (result.size() > 1 ? ", " : "") + in_quotes(text);
  return result + ']';
}

std::string line(std::string_view key, const std::string& value) { return std::string(key) + " = " + value + '\n'; }

std::string_view word(CageWish wish) {
  switch (wish) {
    case CageWish::required:
      return "required";
    case CageWish::none:
      return "none";
    case CageWish::wanted:
      break;
  }
  return "wanted";
}

}  // namespace

std::string to_toml(const Configuration& configuration) {
  std::vector<std::string> gcnp;
  for (const GcnpAddress& address : configuration.gcnp) gcnp.push_back(env::to_string(address.endpoint));
  std::vector<std::string> peers;
  for (const env::HostPort& peer : configuration.air.peers) peers.push_back(env::to_string(peer));
  if (configuration.admits_any_peer) peers.emplace_back("*");
  const auto milliseconds = std::chrono::duration_cast<std::chrono::milliseconds>(configuration.interval).count();
  const std::string fraction = std::to_string(1000 + milliseconds % 1000).substr(1);
  std::string text;
  text += line("ontology", in_quotes(configuration.ontologies));
  text += line("strict", configuration.is_strict ? "true" : "false");
  if (!configuration.adopted.publishers.empty())
    text += line("adopt-from", in_quotes(configuration.adopted.publishers));
  text += line("group", in_quotes(configuration.group));
  text += line("interface", in_quotes(configuration.air.interfaces));
  text += line("peer", in_quotes(peers));
  std::vector<std::string> announced;
  for (const env::AnnouncedAddress& one : configuration.air.announced)
    announced.push_back((one.interface.empty() ? "" : one.interface + '=') + one.address);
  text += line("announce-address", in_quotes(announced));
  if (!configuration.name.empty()) text += line("name", in_quotes(configuration.name));
  if (!configuration.description.empty()) text += line("describe", in_quotes(configuration.description));
  if (gcnp.empty()) gcnp.emplace_back("none");
  text += line("gcnp", in_quotes(gcnp));
  if (!configuration.gcnp_socket.empty()) text += line("gcnp-socket", in_quotes(configuration.gcnp_socket));
  text += line("port", std::to_string(configuration.air.port));
  text += line("multicast", in_quotes(configuration.air.groups));
  if (!configuration.state_folder.empty()) text += line("state-folder", in_quotes(configuration.state_folder));
  text += line("key-file", in_quotes(configuration.key_files));
  const bool is_default = configuration.key_files.empty() && !configuration.says_plain;
  text += (is_default ? "# " : "") + line("sealing", in_quotes(to_string(configuration.sealing.mode)));
  text += line("relay", configuration.relay ? "true" : "false");
  text += line("diagnose", configuration.diagnoses ? "true" : "false");
  text += line("interval", std::to_string(milliseconds / 1000) + '.' + fraction);
  text += line("log-level", in_quotes(to_string(configuration.log_level)));
  text += line("log-format", in_quotes(configuration.log_format == LogFormat::json ? "json" : "text"));
  text += line("cage", in_quotes(word(configuration.cage)));
  if (!configuration.prefixes.empty()) text += "\n[prefixes]\n";
  for (const auto& [name, iri] : configuration.prefixes) text += line(name, in_quotes(iri));
  return text;
}

}  // namespace geminga::daemon
