// Moves a state through a recording as time goes on.
#ifndef GEMINGA_RECORDING_PLAYER_HPP
#define GEMINGA_RECORDING_PLAYER_HPP

#include <expected>
#include <optional>

#include "recording/moment.hpp"
#include "recording/reader.hpp"
#include "recording/state.hpp"

namespace geminga::recording {

/// The bounds of a speed.
inline constexpr double least_speed = 0.01;
inline constexpr double most_speed = 10'000;

/// Reads one entry ahead. Times of the play count from its beginning, a seek or a new speed. Not thread-safe.
class Player {
 public:
  /// Begins at the first entry that is not before `from`, with the state that all before it leave; without `from` at
  /// the beginning. Errors: those of the reader, and a moment behind the end.
  [[nodiscard]] static std::expected<Player, Finding> begin(Reader reader, double speed, std::optional<Moment> from);

  /// Moves to the moment so long after the beginning of the play. Requires that it never runs backwards. The error is
  /// one of the reader, after which the play is over.
  [[nodiscard]] std::expected<void, Finding> move_to(std::chrono::nanoseconds played);
  /// Begins the play anew at this moment. Reads the recording from its beginning. The error is that the recording
  /// cannot be read again (standard input), or ends before that moment; then the last moment stays.
  [[nodiscard]] std::expected<void, Finding> seek(const Moment& moment);
  /// Begins the play anew at this moment, so fast. Requires a speed within its bounds.
  void set_speed(double speed);
  [[nodiscard]] double speed() const { return speed_; }
  /// The moment of the recording, since its beginning.
  [[nodiscard]] At now() const { return now_; }

  /// The time of the play at which the next entry is due; nothing where there is none.
  [[nodiscard]] std::optional<std::chrono::nanoseconds> next_due() const;
  [[nodiscard]] bool is_over() const { return !next_; }

  [[nodiscard]] const State& state() const { return state_; }

 private:
  Player(Reader reader, double speed) : reader_(std::move(reader)), speed_(speed) {}
  std::expected<void, Finding> read();
  /// Reads from the beginning up to this moment.
  std::expected<void, Finding> start(const std::optional<Moment>& from);

  Reader reader_;
  double speed_;
  State state_;
  std::optional<Entry> next_;
  At begin_{};  ///< of the play
  At now_{};
  At last_{};
};

}  // namespace geminga::recording

#endif
