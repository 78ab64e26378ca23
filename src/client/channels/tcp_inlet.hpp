// A subscriber's TCP connection to one provider, made again while the provider is matched.
#ifndef GEMINGA_CLIENT_CHANNELS_TCP_INLET_HPP
#define GEMINGA_CLIENT_CHANNELS_TCP_INLET_HPP

#include <functional>
#include <random>

#include "client/channels/reactor.hpp"
#include "client/protocol/backoff.hpp"
#include "client/protocol/frame.hpp"
#include "client/protocol/frame_reader.hpp"

namespace geminga::client {

/// Says hello by itself. A function of `Told` may destroy it. Neither copies nor moves.
class TcpInlet {
 public:
  struct Told {
    /// A frame. The result is false if no more frames may come for now.
    std::function<bool(const Frame&)> frame;
    /// The connection is gone. The result says whether it is to be made again.
    std::function<bool()> lost;
    /// Octets came that are no frame.
    std::function<void()> broken;
  };

  TcpInlet(Reactor& reactor, PeerAddress to, Life own, Told told);
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
  /// Stops reading, or goes on.
  void pause(bool is_paused);

 private:
  void connect();
  void on_ready(Reactor::Ready ready);
  void read();
  /// Gives the frames that were read. False if it was paused or destroyed meanwhile.
  bool give();
  void lose();

  Reactor& reactor_;
  PeerAddress to_;
  Life own_;
  Told told_;
  Socket socket_;
  Reactor::Watch watch_;
  Reactor::Timer retry_;
  Backoff backoff_;
  std::minstd_rand chance_;
  FrameReader reader_;
  bool is_connected_ = false;
  bool is_paused_ = false;
  bool* is_destroyed_ = nullptr;  ///< set by the destructor, for a call under way
};

}  // namespace geminga::client

#endif
