// The services that others offer by DNS-SD, as Avahi finds them.
#ifndef GEMINGA_BRIDGE_AVAHI_BROWSING_HPP
#define GEMINGA_BRIDGE_AVAHI_BROWSING_HPP

#include <avahi-client/client.h>
#include <avahi-client/lookup.h>

#include <compare>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bridge/avahi/found_service.hpp"
#include "bridge/avahi/retry_pause.hpp"
#include "bridge/team/tally.hpp"

namespace geminga::bridge {

/// Browses all types of services, or some. Each service is resolved on each interface and family where it is seen, and
/// told once, by the best address. Neither copies nor moves.
class Browsing {
 public:
  struct Told {
    std::function<void(const std::string& key, const FoundService&)> found;  ///< or it has changed
    std::function<void(const std::string& key)> gone;
  };

  /// `types`: only these; empty: all but our own. Borrows the tally for its life.
  Browsing(std::set<std::string> types, Tally& tally, Told told);
  ~Browsing() { end(); }
  Browsing(const Browsing&) = delete;
  Browsing& operator=(const Browsing&) = delete;

  /// Begins, if it has not begun.
  void begin(AvahiClient* client);
  /// Resolves again what nobody has answered, each after a pause that doubles. Call once a second.
  void retry();
  /// Frees what it has of the client. All services are gone.
  void end();
  [[nodiscard]] std::size_t services() const { return services_.size(); }

 private:
  struct Place {
    AvahiIfIndex interface = 0;
    AvahiProtocol protocol = 0;
    std::string name, type, domain;
    friend auto operator<=>(const Place&, const Place&) = default;
  };
  /// One place where a service is seen. Its address stays where it is: the library holds a pointer.
  struct Sighting {
    Browsing* owner = nullptr;
    Place place;
    AvahiServiceResolver* resolver = nullptr;  ///< null: it waits
    /// The family of the addresses that are asked for. Of a host with both, Avahi gives only the address that comes
    /// first, which may be an IPv6 address of the link.
    AvahiProtocol family = AVAHI_PROTO_UNSPEC;
    std::optional<FoundService> found{};
    RetryPause pause{};  ///< after an attempt to resolve it that nobody has answered
  };

  void on_type(AvahiBrowserEvent event, const char* type);
  void browse(const std::string& type);
  void leave(const std::string& type);
  void on_service(AvahiBrowserEvent event, Place place, AvahiLookupResultFlags flags);
  void forget(std::map<Place, std::unique_ptr<Sighting>>::iterator at);
  void resolve(Sighting& sighting);
  void on_found(Sighting& sighting, FoundService found);
  void on_failure(Sighting& sighting);
  void free_resolver(Sighting& sighting);
  /// Resolves those that wait, as far as there is room: those that have failed the least first.
  void resolve_waiting();
  void tell(const Place& place);
  static std::string key_of(const Place& place) { return place.name + '.' + place.type + '.' + place.domain; }

  std::set<std::string> types_;
  Tally& tally_;
  Told told_;
  AvahiClient* client_ = nullptr;
  AvahiServiceTypeBrowser* type_browser_ = nullptr;
  struct TypeBrowser {
    AvahiServiceBrowser* browser = nullptr;
    std::size_t seen = 0;  ///< on how many interfaces and families the type was seen
  };
  std::map<std::string, TypeBrowser> browsers_;
  std::map<Place, std::unique_ptr<Sighting>> sightings_;
  std::size_t resolvers_ = 0;
  std::set<std::string> services_;  ///< the keys that were told
};

}  // namespace geminga::bridge

#endif
