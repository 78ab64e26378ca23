// The index of entries by full identity and by concept: found by the 32-bit identity, decided by the full one.
#ifndef GEMINGA_DISCOVERY_REGISTRY_NAME_INDEX_HPP
#define GEMINGA_DISCOVERY_REGISTRY_NAME_INDEX_HPP

#include <algorithm>
#include <boost/unordered/unordered_flat_map.hpp>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "discovery/registry/fields.hpp"
#include "discovery/registry/stored.hpp"

namespace geminga::registry {

/// The kind of a name. The first three are the alternatives of Identity.
enum class NameKind : std::uint8_t { number, text, semantic, concept_alone };

/// An identity, or a concept in any representation, as two borrowed texts: the concept and the representation, or the
/// text and nothing. A number has no texts, because it is its 32-bit form.
struct NameView {
  NameKind kind = NameKind::number;
  std::string_view first;
  std::string_view second;
};

inline NameView view_of(const Identity& identity) {
  if (const auto* semantic = std::get_if<SemanticIdentity>(&identity)) {
    return {NameKind::semantic, semantic->concept_iri, semantic->representation_iri};
  }
  if (const auto* text = std::get_if<TextIdentity>(&identity)) return {NameKind::text, text->text, {}};
  return {};
}

/// A name with the entries that have it. A look-up compares one full name, however many entries share it. The octets
/// stand right behind the object, which begins a cache line: to find and compare two IRIs of usual length touches two
/// cache lines.
template <typename Entry>
class alignas(64) Name {
 public:
  struct Free {
    void operator()(Name* name) const {
      name->~Name();
      ::operator delete(static_cast<void*>(name), std::align_val_t{alignof(Name)});
    }
  };
  using Owner = std::unique_ptr<Name, Free>;

  [[nodiscard]] static Owner make(const NameView& view, Id32 id, Owner next) {
    const std::size_t size = sizeof(Name) + view.first.size() + view.second.size();
    void* memory = ::operator new(size, std::align_val_t{alignof(Name)});
    return Owner(new (memory) Name(view, id, std::move(next)));
  }
  Name(const Name&) = delete;
  Name& operator=(const Name&) = delete;

  /// Whether this name is equal to that one, 32-bit numbers apart.
  [[nodiscard]] bool is(const NameView& view) const {
    return kind_ == view.kind && first_size_ == view.first.size() && second_size_ == view.second.size() &&
           std::string_view(octets(), first_size_) == view.first &&
           std::string_view(octets() + first_size_, second_size_) == view.second;
  }
  [[nodiscard]] bool is_of(NameKind kind) const { return kind_ == kind; }
  [[nodiscard]] Id32 id() const { return id_; }

  mutable Bucket<Entry> entries;
  Owner next;  ///< another one with the same 32-bit number

 private:
  Name(const NameView& view, Id32 id, Owner further)
      : next(std::move(further)),
        id_(id),
        first_size_(static_cast<std::uint32_t>(view.first.size())),
        second_size_(static_cast<std::uint32_t>(view.second.size())),
        kind_(view.kind) {
    char* to = std::ranges::copy(view.first, reinterpret_cast<char*>(this + 1)).out;
    std::ranges::copy(view.second, to);
  }
  ~Name() = default;

  [[nodiscard]] const char* octets() const { return reinterpret_cast<const char*>(this + 1); }

  Id32 id_;
  std::uint32_t first_size_;
  std::uint32_t second_size_;
  NameKind kind_;
};

template <typename Entry>
class NameIndex {
 public:
  NameIndex() = default;
  NameIndex(const NameIndex&) = delete;
  NameIndex& operator=(const NameIndex&) = delete;
  ~NameIndex() {
    // One by one, because a hostile host may have made a chain that is too long for recursion.
    for (auto& [id, chain] : names_) {
      while (chain) chain = std::move(chain->next);
    }
  }

  /// Files under the identity and, for a semantic one, under its concept.
  void file(const Stored<Entry>& stored) {
    const Identity& identity = identity_of(stored.entry);
    file(stored, NameFiling::identity, view_of(identity), stored.identity);
    if (const auto* semantic = std::get_if<SemanticIdentity>(&identity)) {
      file(stored, NameFiling::concept_alone, alone(semantic->concept_iri), number_of(semantic->concept_iri));
    }
  }

  /// Takes an entry out, and deletes names without entries.
  void unfile(const Stored<Entry>& stored) {
    for (auto& [name, position] : stored.names) {
      if (name == nullptr) continue;
      name->entries.remove(position);
      if (name->entries.is_empty()) drop(*name);
      name = nullptr;
    }
  }

  /// The entries with this full identity, among those with this 32-bit one.
  [[nodiscard]] std::span<const Filed<Entry>> with_identity(const Identity& identity, Id32 id) const {
    return entries(view_of(identity), id);
  }
  [[nodiscard]] std::span<const Filed<Entry>> with_concept(std::string_view concept_iri) const {
    return entries(alone(concept_iri), number_of(concept_iri));
  }

  /// The entries of each full identity with this 32-bit one.
  [[nodiscard]] std::vector<std::span<const Filed<Entry>>> with_number(Id32 id) const {
    std::vector<std::span<const Filed<Entry>>> found;
    for (const Name<Entry>* name = first(id); name != nullptr; name = name->next.get()) {
      if (!name->is_of(NameKind::concept_alone)) found.push_back(name->entries.entries());
    }
    return found;
  }

 private:
  static NameView alone(std::string_view concept_iri) { return {NameKind::concept_alone, concept_iri, {}}; }
  static Id32 number_of(std::string_view concept_iri) { return id32(SemanticIdentity{std::string(concept_iri), {}}); }

  [[nodiscard]] const Name<Entry>* first(Id32 id) const {
    const auto found = names_.find(id);
    return found == names_.end() ? nullptr : found->second.get();
  }

  [[nodiscard]] const Name<Entry>* find(const NameView& view, Id32 id) const {
    const Name<Entry>* name = first(id);
    while (name != nullptr && !name->is(view)) name = name->next.get();
    return name;
  }

  [[nodiscard]] std::span<const Filed<Entry>> entries(const NameView& view, Id32 id) const {
    const Name<Entry>* name = find(view, id);
    return name == nullptr ? std::span<const Filed<Entry>>{} : name->entries.entries();
  }

  void file(const Stored<Entry>& stored, NameFiling as, const NameView& view, Id32 id) {
    const Name<Entry>* name = find(view, id);
    if (name == nullptr) {
      auto& chain = names_[id];
      chain = Name<Entry>::make(view, id, std::move(chain));
      name = chain.get();
    }
    const auto back = std::to_underlying(as);
    stored.names[back] = {name, name->entries.file(stored, FiledBy::names, back)};
  }

  void drop(const Name<Entry>& name) {
    const auto found = names_.find(name.id());
    typename Name<Entry>::Owner* link = &found->second;
    while (link->get() != &name) link = &(*link)->next;
    *link = std::move((*link)->next);
    if (!found->second) names_.erase(found);
  }

  /// By 32-bit number. Open addressing, so that a look-up misses the cache only once.
  boost::unordered_flat_map<Id32, typename Name<Entry>::Owner> names_;
};

}  // namespace geminga::registry

#endif
