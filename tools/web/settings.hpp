// The settings of geminga-web, from its flags.
#ifndef GEMINGA_WEB_SETTINGS_HPP
#define GEMINGA_WEB_SETTINGS_HPP

#include <CLI/App.hpp>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "client/channels/endpoint.hpp"
#include "env/asio/endpoint.hpp"
#include "query/alerts/rules.hpp"
#include "shell/options.hpp"
#include "web/site/gate.hpp"
#include "web/site/limits.hpp"

namespace geminga::web {

inline constexpr std::string_view program = "geminga-web";
/// Where it listens unless told. The port is beside that of GCNP, and nobody is registered for it.
inline constexpr std::string_view usual_listen = "127.0.0.1:4780";

/// A recording is shown as a whole, however long it is; the limits of happenings hold (web/site/limits.hpp).
inline constexpr std::chrono::seconds whole_recording = std::chrono::years(10);

/// The flags as they were given.
struct Flags {
  shell::CommonOptions common;
  std::string listen;
  std::string socket;
  std::string token_file;
  std::vector<std::string> names;
  std::string recording;
  std::string alert_rules;  ///< a file; empty: none
  std::uint32_t history_minutes = std::chrono::duration_cast<std::chrono::minutes>(usual_history).count();

  /// Adds the flags. Borrows this for the life of `app`.
  void add_to(CLI::App& app);
};

struct Settings {
  std::optional<env::Endpoint> listen;
  std::string socket;  ///< empty: none
  Rules rules;
  std::vector<client::Endpoint> daemon;
  std::string recording;  ///< empty: the daemon is asked
  std::vector<query::alerts::Rule> alert_rules;
  std::chrono::seconds history{};  ///< 0: none
};

/// The settings of the flags, with the token read from its file. The error is one line: a text that cannot be read, or
/// an address that other hosts reach without a token.
[[nodiscard]] std::expected<Settings, std::string> settings_of(const Flags& flags);

}  // namespace geminga::web

#endif
