// The words of one participant from which its newest state can be put together.
#ifndef GEMINGA_DISCOVERY_RELAYING_WORD_CHAIN_HPP
#define GEMINGA_DISCOVERY_RELAYING_WORD_CHAIN_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"

namespace geminga::relaying {

/// A word as a relay has heard it; its age is that at `heard`.
struct HeardWord {
  announcement::Relayed relayed;
  base::Instant heard{};
};

/// The part of a word's content that says where it belongs.
struct WordPlace {
  announcement::Kind kind{};
  announcement::BootNonce boot{};
  std::uint32_t link = 0;
  std::uint64_t revision = 0;
  std::uint64_t since = 0;
  std::uint32_t part = 0;
  std::uint32_t part_count = 1;

  [[nodiscard]] static WordPlace of(const announcement::Announcement& said) {
    return {said.kind, said.boot, said.link, said.revision, said.since, said.part, said.part_count};
  }
};

/// The parts of one state, and the changes that lead on from it (ANNOUNCEMENT.md, "Changes"), all of one link of their
/// sender. At most keeping::max_kept_words; a state or a chain that needs more leads nowhere. Pure.
class WordChain {
 public:
  /// Takes a word in, if it belongs here: a newer state begins anew. Words are to be added in the order in which they
  /// were said. Whether it is new.
  bool add(const WordPlace& place, HeardWord word);
  /// Whether these words tell all of this revision.
  [[nodiscard]] bool leads_to(std::uint64_t revision) const;
  /// In the order in which they were said.
  [[nodiscard]] const std::vector<HeardWord>& words() const { return words_; }

 private:
  bool add_state(const WordPlace& place, HeardWord word);
  bool add_change(const WordPlace& place, HeardWord word);
  /// The revision to which the words lead.
  [[nodiscard]] std::uint64_t tip() const { return places_.empty() ? 0 : places_.back().revision; }

  std::vector<HeardWord> words_;
  std::vector<WordPlace> places_;  ///< of each word
};

}  // namespace geminga::relaying

#endif
