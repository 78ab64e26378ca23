// Interns nodes by content and sorts triples by subject with one counting pass.
#include "reasoning/syntax/rdf/triples/graph.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "base/hash.hpp"

namespace geminga::rdf {
namespace {

constexpr std::size_t chunk_bytes = std::size_t{1} << 16;

std::uint64_t hash_of(NodeKind kind, std::string_view text, NodeId datatype, NodeId language) {
  const std::uint64_t seed = static_cast<std::uint64_t>(kind) | static_cast<std::uint64_t>(datatype) << 2U |
                             static_cast<std::uint64_t>(language) << 33U;
  return base::hash64(text, seed);
}

}  // namespace

Graph::Graph() {
  for (std::uint32_t word = 0; word < static_cast<std::uint32_t>(syntax::Word::count); ++word)
    intern(NodeKind::iri, iri_of(static_cast<syntax::Word>(word)), NodeId{}, NodeId{});
}

const char* Graph::store(std::string_view text) {
  if (text.empty()) return "";
  if (text.size() > chunk_left_) {
    const std::size_t size = std::max(chunk_bytes, text.size());
    chunks_.push_back(std::make_unique_for_overwrite<char[]>(size));
    chunk_end_ = chunks_.back().get();
    chunk_left_ = size;
  }
  char* place = chunk_end_;
  std::memcpy(place, text.data(), text.size());
  chunk_end_ += text.size();
  chunk_left_ -= text.size();
  return place;
}

NodeId Graph::push(NodeKind kind, bool is_nameless, std::string_view text, NodeId datatype, NodeId language) {
  nodes_.push_back({store(text), static_cast<std::uint32_t>(text.size()), kind, is_nameless, datatype, language});
  return NodeId{static_cast<std::uint32_t>(nodes_.size() - 1)};
}

NodeId Graph::intern(NodeKind kind, std::string_view text, NodeId datatype, NodeId language) {
  return intern_hashed(hash_of(kind, text, datatype, language), kind, text, datatype, language);
}

NodeId Graph::intern_hashed(std::uint64_t hash, NodeKind kind, std::string_view text, NodeId datatype,
                            NodeId language) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  const std::uint32_t found = table_.find_or_insert(hash, number, [&](std::uint32_t filed) {
    const Record& record = nodes_[filed];
    return record.size == text.size() && record.kind == kind && record.datatype == datatype &&
           record.language == language && std::string_view(record.text, record.size) == text;
  });
  return found != NodeTable::none ? NodeId{found} : push(kind, false, text, datatype, language);
}

std::vector<NodeId> Graph::append_nodes(const Graph& other) {
  constexpr std::size_t words = static_cast<std::size_t>(syntax::Word::count);
  constexpr std::size_t at_once = 32;
  std::vector<NodeId> here(other.nodes_.size());
  for (std::size_t number = 0; number < words; ++number) here[number] = NodeId{static_cast<std::uint32_t>(number)};
  std::array<std::uint64_t, at_once> hashes{};
  // A literal comes behind its datatype and language.
  const auto node_at = [&](NodeId node) { return here[static_cast<std::size_t>(node)]; };
  for (std::size_t begin = words; begin < other.nodes_.size(); begin += at_once) {
    const auto some = std::span(other.nodes_).subspan(begin, std::min(at_once, other.nodes_.size() - begin));
    prefetch(some, hashes);
    for (std::size_t at = 0; at < some.size(); ++at) {
      const Record& record = some[at];
      const std::string_view text(record.text, record.size);
      if (record.is_nameless) {
        here[begin + at] = new_blank(text);
      } else if (record.kind != NodeKind::literal) {
        here[begin + at] = intern_hashed(hashes[at], record.kind, text, NodeId{}, NodeId{});
      } else {
        here[begin + at] = literal(text, node_at(record.datatype), node_at(record.language));
      }
    }
  }
  return here;
}

void Graph::prefetch(std::span<const Record> some, std::span<std::uint64_t> hashes) const {
  const auto is_searched = [](const Record& record) { return !record.is_nameless && record.kind != NodeKind::literal; };
  for (std::size_t at = 0; at < some.size(); ++at) {
    if (!is_searched(some[at])) continue;
    hashes[at] = hash_of(some[at].kind, {some[at].text, some[at].size}, NodeId{}, NodeId{});
    table_.prefetch(hashes[at]);
  }
  const auto for_each_candidate = [&](auto&& fetch) {
    for (std::size_t at = 0; at < some.size(); ++at) {
      const std::uint32_t number = is_searched(some[at]) ? table_.first_candidate(hashes[at]) : NodeTable::none;
      if (number != NodeTable::none) fetch(nodes_[number]);
    }
  };
  for_each_candidate([](const Record& record) { __builtin_prefetch(&record); });
  for_each_candidate([](const Record& record) { __builtin_prefetch(record.text); });
}

void Graph::append(const Graph& other) {
  const std::vector<NodeId> here = append_nodes(other);
  const auto node_here = [&](NodeId node) { return here[static_cast<std::size_t>(node)]; };
  for (const Triple& triple : other.triples_)
    triples_.push_back({node_here(triple.subject), node_here(triple.predicate), node_here(triple.object), triple.line});
}

Node Graph::node(NodeId id) const {
  const Record& record = nodes_[static_cast<std::size_t>(id)];
  return {{record.text, record.size}, record.kind, record.datatype, record.language};
}

std::uint32_t Graph::file_of(std::uint32_t triple) const {
  const auto next = std::ranges::upper_bound(file_begins_, static_cast<std::size_t>(triple));
  return static_cast<std::uint32_t>(next - file_begins_.begin()) - 1;
}

void Graph::index() {
  std::vector<std::uint32_t> begins(nodes_.size() + 1, 0);
  for (const Triple& triple : triples_) ++begins[static_cast<std::size_t>(triple.subject) + 1];
  for (std::size_t node = 1; node < begins.size(); ++node) begins[node] += begins[node - 1];
  std::vector<std::uint32_t> places = begins;
  order_.resize(triples_.size());
  for (std::uint32_t number = 0; number < triples_.size(); ++number)
    order_[places[static_cast<std::size_t>(triples_[number].subject)]++] = number;

  const auto by_content = [&](std::uint32_t a, std::uint32_t b) {
    const Triple& x = triples_[a];
    const Triple& y = triples_[b];
    return std::tie(x.predicate, x.object, a) < std::tie(y.predicate, y.object, b);
  };
  const auto is_same = [&](std::uint32_t a, std::uint32_t b) {
    return triples_[a].predicate == triples_[b].predicate && triples_[a].object == triples_[b].object;
  };
  std::size_t kept = 0;
  for (std::size_t node = 0; node + 1 < begins.size(); ++node) {
    const auto first = order_.begin() + begins[node];
    auto last = order_.begin() + begins[node + 1];
    if (last - first > 1) {
      std::sort(first, last, by_content);
      last = std::unique(first, last, is_same);
    }
    begins[node] = static_cast<std::uint32_t>(kept);
    kept = static_cast<std::size_t>(std::copy(first, last, order_.begin() + static_cast<std::ptrdiff_t>(kept)) -
                                    order_.begin());
  }
  begins.back() = static_cast<std::uint32_t>(kept);
  order_.resize(kept);
  begins_ = std::move(begins);
}

std::span<const std::uint32_t> Graph::about(NodeId subject) const {
  const auto node = static_cast<std::size_t>(subject);
  return std::span(order_).subspan(begins_[node], begins_[node + 1] - begins_[node]);
}

std::span<const std::uint32_t> Graph::about(NodeId subject, syntax::Word predicate) const {
  const auto predicate_of = [&](std::uint32_t number) { return triples_[number].predicate; };
  const auto found = std::ranges::equal_range(about(subject), node_of(predicate), {}, predicate_of);
  return {found.begin(), found.end()};
}

bool Graph::has(NodeId subject, NodeId predicate, NodeId object) const {
  const auto content_of = [&](std::uint32_t number) {
    return std::pair(triples_[number].predicate, triples_[number].object);
  };
  return std::ranges::binary_search(about(subject), std::pair(predicate, object), {}, content_of);
}

}  // namespace geminga::rdf
