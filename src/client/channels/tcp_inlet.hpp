// A subscriber's TCP connection to one provider, made again while the provider is matched.
#ifndef GEMINGA_CLIENT_CHANNELS_TCP_INLET_HPP
#define GEMINGA_CLIENT_CHANNELS_TCP_INLET_HPP

#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "client/channels/channel_host.hpp"
#include "client/protocol/backoff.hpp"
#include "client/protocol/frame_reader.hpp"
#include "client/protocol/handshake.hpp"
#include "client/protocol/intake.hpp"

namespace geminga::client {

/// Says hello by itself. A function of `Told` may destroy it. Neither copies nor moves.
class TcpInlet {
 public:
  struct Told {
    /// A message or an end. `is_proved`: it was opened with a key, and made after this connection was. The result is
    /// false if no more frames may come for now.
    std::function<bool(const Frame&, bool is_proved)> frame;
    /// The connection is gone. The result says whether it is to be made again.
    std::function<bool()> lost;
    /// Octets came that are no frame, or one that is not believed.
    std::function<void()> dropped;
    /// The provider has no place for another consumer.
    std::function<void()> full;
  };

  /// Requires that the sealer outlives it.
  TcpInlet(ChannelHost& host, PeerAddress to, Sealer& sealer, Life provider, ChannelKeys keys, Told told);
  ~TcpInlet() {
    if (is_destroyed_ != nullptr) *is_destroyed_ = true;
  }
  TcpInlet(const TcpInlet&) = delete;
  TcpInlet& operator=(const TcpInlet&) = delete;

  /// Begins to connect.
  void start() { connect(); }
  [[nodiscard]] const PeerAddress& to() const { return to_; }
  /// Whether the connection is open.
  [[nodiscard]] bool is_connected() const { return is_connected_; }
  /// Since when it is not.
  [[nodiscard]] base::Instant unconnected_since() const { return unconnected_since_; }
  /// Takes other keys. A publisher that has asked for a hello gets one in the new form.
  void set_keys(ChannelKeys keys);
  /// Stops reading, or goes on.
  void pause(bool is_paused);

 private:
  void connect();
  void on_ready(Reactor::Ready ready);
  void read();
  /// Gives the frames that were read. False if it was paused, destroyed or closed meanwhile.
  bool give();
  /// Takes one frame. False if it ends the connection, which it does not do itself.
  bool take(const ReadFrame& frame);
  /// Says the next hello. False if the connection does not take it.
  bool say_hello();
  void lose();

  ChannelHost& host_;
  PeerAddress to_;
  Sealer& sealer_;
  Life provider_;
  Told told_;
  Intake intake_;
  std::optional<Handshake> handshake_;  ///< of this connection
  Socket socket_;
  Reactor::Watch watch_;
  Reactor::Timer retry_;
  Backoff backoff_;
  std::minstd_rand chance_;
  FrameReader reader_;
  std::vector<std::byte> opened_;  ///< room for the payload of a sealed frame
  base::Instant unconnected_since_;
  bool is_connected_ = false;
  bool is_paused_ = false;
  bool was_told_full_ = false;
  bool* is_destroyed_ = nullptr;  ///< set by the destructor, for a call under way
};

}  // namespace geminga::client

#endif
