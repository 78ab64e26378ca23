// The result of mapping a node to which several others may refer.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_MAPPING_MAPPED_ONCE_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_MAPPING_MAPPED_ONCE_HPP

#include <cstdint>
#include <optional>

#include "reasoning/syntax/rdf/mapping/triple_reader.hpp"

namespace geminga::rdf {

/// The result of mapping one node, kept, so that it is mapped once however often it is used.
class MappedOnce {
 public:
  [[nodiscard]] bool was_tried() const { return progress_ != Progress::untried; }
  [[nodiscard]] bool is_mapped() const { return progress_ == Progress::mapped; }
  /// The result, if there is one. `circular` is the obstacle where the node is being mapped: it contains itself.
  [[nodiscard]] std::optional<Mapped> known(const char* circular) const {
    switch (progress_) {
      case Progress::untried:
        return std::nullopt;
      case Progress::open:
        return std::unexpected(circular);
      case Progress::mapped:
        return term_;
      case Progress::failed:
        break;
    }
    return std::unexpected(obstacle_);
  }
  void begin() { progress_ = Progress::open; }
  Mapped end(Mapped result) {
    progress_ = result ? Progress::mapped : Progress::failed;
    if (result) {
      term_ = *result;
    } else {
      obstacle_ = result.error();
    }
    return result;
  }

 private:
  enum class Progress : std::uint8_t { untried, open, mapped, failed } progress_ = Progress::untried;
  owl::TermId term_{};
  const char* obstacle_ = nullptr;
};

}  // namespace geminga::rdf

#endif
