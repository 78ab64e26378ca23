// Entries by full identity and by concept: found by the 32-bit identity, decided by the full one.
#ifndef GEMINGA_REGISTRY_NAME_INDEX_HPP
#define GEMINGA_REGISTRY_NAME_INDEX_HPP

#include <boost/multi_index/hashed_index.hpp>
#include <boost/multi_index/member.hpp>
#include <boost/multi_index_container.hpp>
#include <string_view>
#include <variant>

#include "registry/fields.hpp"
#include "registry/stored.hpp"

namespace geminga::registry {

/// One identity that some entry has, or whose concept some entry has. Every identity is kept once, so that a look-up
/// compares one full identity, however many entries share it.
template <typename Entry>
struct Name {
  Id32 id = 0;
  Identity identity;
  mutable Bucket<Entry> same;          ///< entries with this very identity
  mutable Bucket<Entry> same_concept;  ///< for a concept alone: entries with it in whatever representation
};

template <typename Entry>
class NameIndex {
 public:
  /// Files under the identity and, for a semantic one, under its concept.
  void file(const Stored<Entry>& stored) {
    const Identity& identity = identity_of(stored.entry);
    stored.identity_name = &name(identity, stored.identity);
    stored.identity_name->same.file(stored);
    if (const auto* semantic = std::get_if<SemanticIdentity>(&identity)) {
      const Identity alone = SemanticIdentity{semantic->concept_iri, {}};
      stored.concept_name = &name(alone, id32(alone));
      stored.concept_name->same_concept.file(stored);
    }
  }

  /// Forgets the names that nobody has any more, after the entry was taken out of its buckets.
  void release(const Stored<Entry>& stored) {
    const Name<Entry>* first = stored.identity_name;
    const Name<Entry>* second = stored.concept_name == first ? nullptr : stored.concept_name;
    stored.identity_name = stored.concept_name = nullptr;
    drop_if_unused(first);
    drop_if_unused(second);
  }

  [[nodiscard]] const Name<Entry>* find(const Identity& identity, Id32 id) const {
    const auto [first, last] = names_.equal_range(id);
    for (auto candidate = first; candidate != last; ++candidate) {
      if (candidate->identity == identity) return &*candidate;
    }
    return nullptr;
  }

 private:
  using Names =
      boost::multi_index_container<Name<Entry>, boost::multi_index::indexed_by<boost::multi_index::hashed_non_unique<
                                                    boost::multi_index::member<Name<Entry>, Id32, &Name<Entry>::id>>>>;

  const Name<Entry>& name(const Identity& identity, Id32 id) {
    if (const auto* known = find(identity, id)) return *known;
    return *names_.insert(Name<Entry>{id, identity, {}, {}}).first;
  }

  void drop_if_unused(const Name<Entry>* name) {
    if (name != nullptr && name->same.is_empty() && name->same_concept.is_empty()) {
      names_.erase(names_.iterator_to(*name));
    }
  }

  Names names_;
};

}  // namespace geminga::registry

#endif
