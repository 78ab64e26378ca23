// geminga-bridge-dns-sd: our services for who looks by DNS-SD, and theirs for the team.
#include <ifaddrs.h>
#include <netdb.h>
#include <netinet/in.h>

#include <CLI/CLI.hpp>
#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "bridge/avahi/browsing.hpp"
#include "bridge/avahi/connection.hpp"
#include "bridge/avahi/own_service.hpp"
#include "bridge/avahi/publishing.hpp"
#include "bridge/loop/loop.hpp"
#include "bridge/team/team.hpp"
#include "shell/report.hpp"
#include "shell/whole_lines.hpp"

namespace geminga::bridge {
namespace {

constexpr std::string_view program = "geminga-bridge-dns-sd";
/// The time between two looks at our own services. Shorter: others see them earlier. Longer: fewer questions.
constexpr std::chrono::seconds look{1};

constexpr const char* examples = R"(Examples:
  geminga-bridge-dns-sd --type _ipp._tcp --type _http._tcp
  geminga-bridge-dns-sd --only out --connect /run/geminga/gcnp
  geminga-bridge dns-sd
  avahi-browse -rt _geminga._udp
  geminga-query match --text _ipp._tcp

The services of this host's modules are announced through avahi-daemon as _geminga._udp or _geminga._tcp, with concept,
representation and attributes in the TXT record. A service that others announce becomes a publication with mode oto and protocol
dns-sd. Its concept is the class whose geminga:dnsServiceType is that type in the team's ontology; where there is none, its identity
is the text, e.g. _ipp._tcp. It is withdrawn when DNS-SD no longer has it. One bridge on a link is enough for incoming services. For
outgoing ones each host runs its own bridge, or one bridge has --team.

The bridge waits for the daemon and for Avahi, and begins again when they are back. Services that it cannot take are counted on
standard error.

Exit status: 0 ended by a signal, 2 wrong usage.)";

struct Flags {
  shell::CommonOptions common;
  std::vector<std::string> types;
  std::string only;
  bool is_for_team = false;

  void add_to(CLI::App& app) {
    common.add_without_json_to(app, "How long to wait for the daemon's hello (default: 5)");
    app.add_option("--type", types, "Take only services of this type; may be given several times")
        ->type_name("TYPE")
        ->allow_extra_args(false);
    app.add_option("--only", only, "Only take what others announce, or only announce ours")
        ->type_name("in|out")
        ->check(CLI::IsMember({"in", "out"}), "", "");
    app.add_flag("--team", is_for_team, "Announce the services of all robots, not only of this host");
  }
};

/// The addresses of this host, as texts.
std::set<std::string> own_addresses() {
  std::set<std::string> addresses;
  ifaddrs* all = nullptr;
  if (::getifaddrs(&all) != 0) return addresses;
  for (const ifaddrs* one = all; one != nullptr; one = one->ifa_next) {
    const int family = one->ifa_addr == nullptr ? AF_UNSPEC : one->ifa_addr->sa_family;
    if (family != AF_INET && family != AF_INET6) continue;
    std::array<char, NI_MAXHOST> text{};
    const socklen_t size = family == AF_INET ? sizeof(sockaddr_in) : sizeof(sockaddr_in6);
    const int failed = ::getnameinfo(one->ifa_addr, size, text.data(), text.size(), nullptr, 0, NI_NUMERICHOST);
    if (failed == 0) addresses.insert(text.data());
  }
  ::freeifaddrs(all);
  return addresses;
}

class DnsSd {
 public:
  DnsSd(client::Reactor& reactor, Team& team, const Flags& flags)
      : reactor_(reactor),
        team_(team),
        is_for_team_(flags.is_for_team),
        takes_(flags.only != "out"),
        announces_(flags.only != "in"),
        browsing_({flags.types.begin(), flags.types.end()}, team.tally(),
                  {.found =
                       [this](const std::string& key, const FoundService& service) {
                         if (auto foreign = foreign_of(service)) team_.foreign().put(key, std::move(*foreign));
                       },
                   .gone = [this](const std::string& key) { team_.foreign().drop(key); }}),
        publishing_(team.tally()),
        connection_(reactor, {.ready =
                                  [this](AvahiClient* client) {
                                    if (takes_) browsing_.begin(client);
                                    publishing_.begin(client);
                                  },
                              .renaming = [this] { publishing_.end(); },
                              .lost =
                                  [this] {
                                    publishing_.end();
                                    browsing_.end();
                                  },
                              .log = [](const std::string& line) { shell::complain(program, line); }}),
        timer_(reactor, [this] { on_second(); }) {}

  void start() {
    connection_.start();
    on_second();
  }

 private:
  void on_second() {
    timer_.set(reactor_.now() + look);
    browsing_.retry();
    publishing_.retry();
    if (announces_) look_at_ours();
  }
  /// Our services as the daemon has them. Without a daemon there are none.
  void look_at_ours() {
    if (!team_.is_up()) return publishing_.set({});
    Team::Parameters parameters;
    if (!is_for_team_ && !team_.participant_name().empty()) parameters = {{"provider", team_.participant_name()}};
    team_.ask("services", parameters, [this](std::optional<Answer> answer) {
      if (!answer) return;
      const std::set<std::string> addresses = own_addresses();
      std::map<std::string, OwnService> services;
      for (const Record& line : answer->records) {
        if (!is_for_team_ && line["local"] != "1") continue;
        if (auto service = own_service(line, addresses)) services.emplace(line["service"], std::move(*service));
      }
      publishing_.set(services);
    });
  }

  client::Reactor& reactor_;
  Team& team_;
  bool is_for_team_;
  bool takes_;
  bool announces_;
  Browsing browsing_;
  Publishing publishing_;
  Connection connection_;
  client::Reactor::Timer timer_;
};

int run(int argc, char** argv) {
  CLI::App app("Shows the team's services by DNS-SD, and DNS-SD's services to the team.", std::string(program));
  app.footer(examples);
  Flags flags;
  flags.add_to(app);
  app.callback([&flags] {
    for (const std::string& type : flags.types) {
      if (!is_service_type(type))
        throw CLI::ValidationError("--type", type + " is no type: write _NAME._tcp or _NAME._udp");
      if (is_own_type(type)) throw CLI::ValidationError("--type", type + " is Geminga's own, which the daemons find");
    }
  });
  if (const auto status = shell::parse(app, argc, argv)) return static_cast<int>(*status);
  Loop loop(program, flags.common);
  if (!loop.is_ready()) return static_cast<int>(shell::ExitStatus::wrong_use);
  DnsSd bridge(loop.reactor(), loop.team(), flags);
  bridge.start();
  return loop.run();
}

}  // namespace
}  // namespace geminga::bridge

int main(int argc, char** argv) {
  const geminga::shell::WholeLines lines;
  return geminga::bridge::run(argc, argv);
}
