// Our services on mDNS, through Avahi.
#ifndef GEMINGA_BRIDGE_AVAHI_PUBLISHING_HPP
#define GEMINGA_BRIDGE_AVAHI_PUBLISHING_HPP

#include <avahi-client/client.h>
#include <avahi-client/publish.h>

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "bridge/avahi/own_service.hpp"
#include "bridge/avahi/retry_pause.hpp"
#include "bridge/team/tally.hpp"

namespace geminga::bridge {

/// Announces what it was last given while Avahi is there. Each service is an entry group of its own; where others have
/// its name, it takes another one and leaves theirs alone. Neither copies nor moves.
class Publishing {
 public:
  explicit Publishing(Tally& tally) : tally_(tally) {}
  ~Publishing() { end(); }
  Publishing(const Publishing&) = delete;
  Publishing& operator=(const Publishing&) = delete;

  /// The services by their words (`PARTICIPANT/PEER/NUMBER`), in the place of the former ones.
  void set(const std::map<std::string, OwnService>& services);
  void begin(AvahiClient* client);
  /// Announces again what was refused, each after a pause that doubles: Avahi may have room for it by now, or a name
  /// may be free. Call once a second.
  void retry();
  /// Frees what it has of the client; the services stay known for the next one.
  void end();
  [[nodiscard]] std::size_t size() const { return entries_.size(); }

 private:
  /// Its address stays where it is: the library holds a pointer.
  struct Entry {
    Publishing* owner = nullptr;
    OwnService service;
    std::string label;  ///< under which it is announced
    AvahiEntryGroup* group = nullptr;
    int names_tried = 1;
    RetryPause pause{};  ///< after it was refused
  };

  /// Announces it anew, under its own label.
  void announce(Entry& entry);
  /// It is not announced for now. Counted once for each service, not for each attempt.
  void refuse(Entry& entry, std::string_view reason);
  void free_group(Entry& entry);
  void on_state(Entry& entry, AvahiEntryGroup* group, AvahiEntryGroupState state);
  /// Fills the group under the entry's label and commits it.
  void fill(Entry& entry, AvahiEntryGroup* group);
  void rename(Entry& entry, AvahiEntryGroup* group);
  bool update(Entry& entry, const OwnService& service);

  Tally& tally_;
  AvahiClient* client_ = nullptr;
  std::map<std::string, std::unique_ptr<Entry>> entries_;
};

}  // namespace geminga::bridge

#endif
