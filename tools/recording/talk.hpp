// The conversation of a recording with one client, in octets.
#ifndef GEMINGA_RECORDING_TALK_HPP
#define GEMINGA_RECORDING_TALK_HPP

#include <cstdint>
#include <string>
#include <string_view>

#include "discovery/gcnp/first_word.hpp"
#include "discovery/gcnp/line_reader.hpp"
#include "recording/state.hpp"

namespace geminga::recording {

/// Reads statements of GCNP and answers each of them. An error costs its own line only. Does no input or output.
class Talk {
 public:
  explicit Talk(std::uint32_t peer) : peer_(peer) {}

  /// Takes octets of the client.
  void hear(std::string_view octets);
  /// Answers the next statement that was heard by the state; empty where there is none. One at a time, so that a caller
  /// can wait until an answer has been read.
  [[nodiscard]] std::string next_answer(const State& state);
  /// Whether the connection ends behind what was answered: the client said goodbye, or speaks another protocol.
  [[nodiscard]] bool is_over() const { return is_over_; }

 private:
  [[nodiscard]] std::string answer_to(std::string_view line, const State& state);

  std::uint32_t peer_;
  gcnp::FirstWord first_word_;
  gcnp::LineReader lines_;
  bool is_foreign_ = false;
  bool is_over_ = false;
};

}  // namespace geminga::recording

#endif
