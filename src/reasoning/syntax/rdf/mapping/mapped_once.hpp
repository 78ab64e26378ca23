// What became of a node that several others may refer to.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_MAPPING_MAPPED_ONCE_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_MAPPING_MAPPED_ONCE_HPP

#include <cstdint>
#include <optional>

#include "reasoning/syntax/rdf/mapping/triple_reader.hpp"

namespace geminga::rdf {

/// The result of mapping one node, kept, so that it is mapped once however often it is used.
class MappedOnce {
 public:
  [[nodiscard]] bool was_tried() const { return state_ != State::unknown; }
  [[nodiscard]] bool is_mapped() const { return state_ == State::mapped; }
  /// The result, if there is one. `circular` is the obstacle where the node is being mapped: it contains itself.
  [[nodiscard]] std::optional<Mapped> known(const char* circular) const {
    switch (state_) {
      case State::unknown:
        return std::nullopt;
      case State::open:
        return std::unexpected(circular);
      case State::mapped:
        return term_;
      case State::failed:
        break;
    }
    return std::unexpected(obstacle_);
  }
  void begin() { state_ = State::open; }
  Mapped end(Mapped result) {
    state_ = result ? State::mapped : State::failed;
    if (result) {
      term_ = *result;
    } else {
      obstacle_ = result.error();
    }
    return result;
  }

 private:
  enum class State : std::uint8_t { unknown, open, mapped, failed } state_ = State::unknown;
  owl::TermId term_{};
  const char* obstacle_ = nullptr;
};

}  // namespace geminga::rdf

#endif
