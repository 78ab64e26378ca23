// The flags of a bridge that carries words: its server, its team, and where the daemon is.
#ifndef GEMINGA_BRIDGE_WORDS_WORD_OPTIONS_HPP
#define GEMINGA_BRIDGE_WORDS_WORD_OPTIONS_HPP

#include <CLI/App.hpp>
#include <cstdint>
#include <expected>
#include <string>

#include "client/channels/endpoint.hpp"

namespace geminga::bridge {

/// The settings, checked.
struct WordSettings {
  std::string host;
  std::uint16_t port = 0;
  bool is_secure = false;
  std::string team;
  std::string site;  ///< its name and a random end, so that no two bridges have one
  std::string ca_file;
  std::string certificate;  ///< a file with the client's certificates; empty: none
  std::string certificate_key;
  std::string user;
  std::string password;
  client::Endpoint own;
  client::Endpoint daemon;
};

struct WordOptions {
  std::string url;
  std::string team = "geminga";
  std::string site = "site";
  std::string listen = "127.0.0.1:4720";
  std::string daemon = "127.0.0.1:4717";
  std::string ca_file;
  std::string certificate;
  std::string certificate_key;
  std::string user;
  std::string password_file;

  /// Adds URL and flags. `schemes`, e.g. `mqtt|mqtts`, is how its value is called. Borrows this for the life of `app`.
  void add_to(CLI::App& app, const std::string& program, const std::string& schemes);
  /// The settings: the plain or the secure scheme, and the port where the URL has none. The error is one line.
  [[nodiscard]] std::expected<WordSettings, std::string> settings(const std::string& scheme,
                                                                  const std::string& secure_scheme, std::uint16_t port,
                                                                  std::uint16_t secure_port) const;
};

}  // namespace geminga::bridge

#endif
