// Entries by full identity and by concept: found by the 32-bit identity, decided by the full one.
#ifndef GEMINGA_DISCOVERY_REGISTRY_NAME_INDEX_HPP
#define GEMINGA_DISCOVERY_REGISTRY_NAME_INDEX_HPP

#include <boost/container/small_vector.hpp>
#include <boost/multi_index/hashed_index.hpp>
#include <boost/multi_index/member.hpp>
#include <boost/multi_index_container.hpp>
#include <cstring>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "discovery/registry/fields.hpp"
#include "discovery/registry/stored.hpp"

namespace geminga::registry {

/// An identity as two texts, borrowed: the concept and the representation, or the text and nothing. A number is its
/// 32-bit form already.
struct NameView {
  std::size_t kind = 0;  ///< the index in Identity
  std::string_view first;
  std::string_view second;
};

inline NameView view_of(const Identity& identity) {
  if (const auto* semantic = std::get_if<SemanticIdentity>(&identity)) {
    return {identity.index(), semantic->concept_iri, semantic->representation_iri};
  }
  const auto* text = std::get_if<TextIdentity>(&identity);
  return {identity.index(), text == nullptr ? std::string_view() : std::string_view(text->text), {}};
}

/// The octets of an identity, kept in place where they are not many: comparing them then costs no other cache miss.
class NameText {
 public:
  explicit NameText(const NameView& name)
      : kind_(name.kind), first_size_(name.first.size()), octets_(name.first.begin(), name.first.end()) {
    octets_.insert(octets_.end(), name.second.begin(), name.second.end());
  }

  /// Whether this is the whole of that identity, 32-bit numbers apart.
  [[nodiscard]] bool is(const NameView& name) const {
    return kind_ == name.kind && first_size_ == name.first.size() &&
           octets_.size() == name.first.size() + name.second.size() && has_at(0, name.first) &&
           has_at(first_size_, name.second);
  }

 private:
  static constexpr std::size_t in_place = 104;  ///< two IRIs of usual length; longer ones go to the heap

  [[nodiscard]] bool has_at(std::size_t offset, std::string_view octets) const {
    return octets.empty() || std::memcmp(octets_.data() + offset, octets.data(), octets.size()) == 0;
  }

  std::size_t kind_;
  std::size_t first_size_;
  boost::container::small_vector<char, in_place> octets_;
};

/// One identity that some entry has, or whose concept some entry has. Every identity is kept once, so that a look-up
/// compares one full identity, however many entries share it.
template <typename Entry>
struct Name {
  Id32 id = 0;
  mutable Bucket<Entry> same;  ///< entries with this very identity
  NameText text;
  mutable Bucket<Entry> same_concept;  ///< for a concept alone: entries with it in whatever representation
};

template <typename Entry>
class NameIndex {
 public:
  /// Files under the identity and, for a semantic one, under its concept.
  void file(const Stored<Entry>& stored) {
    const Identity& identity = identity_of(stored.entry);
    stored.identity_name = &name(identity, stored.identity);
    stored.identity_name->same.file(stored, FiledBy::names);
    if (const auto* semantic = std::get_if<SemanticIdentity>(&identity)) {
      const Identity alone = SemanticIdentity{semantic->concept_iri, {}};
      stored.concept_name = &name(alone, id32(alone));
      stored.concept_name->same_concept.file(stored, FiledBy::names);
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

  /// The name with this full identity, among those with this 32-bit one.
  [[nodiscard]] const Name<Entry>* find(const Identity& identity, Id32 id) const {
    const NameView view = view_of(identity);
    for (auto candidate = names_.find(id); candidate != names_.end() && candidate->id == id; ++candidate) {
      if (candidate->text.is(view)) return &*candidate;
    }
    return nullptr;
  }

  /// The entries of each full identity with this 32-bit one.
  [[nodiscard]] std::vector<std::span<const Filed<Entry>>> find_all(Id32 id) const {
    std::vector<std::span<const Filed<Entry>>> found;
    for (auto name = names_.find(id); name != names_.end() && name->id == id; ++name) {
      if (!name->same.is_empty()) found.push_back(name->same.entries());
    }
    return found;
  }

 private:
  using Names =
      boost::multi_index_container<Name<Entry>, boost::multi_index::indexed_by<boost::multi_index::hashed_non_unique<
                                                    boost::multi_index::member<Name<Entry>, Id32, &Name<Entry>::id>>>>;

  const Name<Entry>& name(const Identity& identity, Id32 id) {
    if (const auto* known = find(identity, id)) return *known;
    return *names_.insert(Name<Entry>{id, {}, NameText(view_of(identity)), {}}).first;
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
