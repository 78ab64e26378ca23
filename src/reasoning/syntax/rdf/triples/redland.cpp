// Each piece is parsed into a graph of its own. The graphs are joined in the order of the file.
#include "reasoning/syntax/rdf/triples/redland.hpp"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <new>
#include <utility>

#include "base/parallel/crew.hpp"
#include "base/parallel/room.hpp"
#include "base/text.hpp"
#include "reasoning/owl/blank_prefix.hpp"
#include "reasoning/syntax/base_iri.hpp"

namespace geminga::rdf {
namespace {

/// More parsers would wait for the thread that joins their triples.
constexpr unsigned max_threads = 8;

/// The result of parsing one piece.
struct ReadPiece {
  Graph graph;
  std::vector<std::pair<std::string, std::string>> prefixes;
  std::vector<Passed> passed;
  std::uint64_t triples = 0;
  std::optional<syntax::LoadError> error;
};

}  // namespace

/// Hands out the pieces in their order, and takes them back in any.
class PieceQueue {
 public:
  PieceQueue(std::size_t count, std::size_t ahead) : done_(count), ahead_(ahead) {}

  /// The next piece to be parsed. Waits while too many are parsed and not joined, since each takes memory.
  std::optional<std::size_t> next() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return is_stopped_ || given_ == done_.size() || given_ < joined_ + ahead_; });
    if (is_stopped_ || given_ == done_.size()) return std::nullopt;
    return given_++;
  }
  void give_back(std::size_t number, std::unique_ptr<ReadPiece> piece) {
    const std::lock_guard lock(mutex_);
    done_[number] = std::move(piece);
    changed_.notify_all();
  }
  /// Waits for a piece; none where the work was stopped.
  std::unique_ptr<ReadPiece> take(std::size_t number) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return is_stopped_ || done_[number] != nullptr; });
    joined_ = number + 1;
    changed_.notify_all();
    return std::move(done_[number]);
  }
  void stop() {
    const std::lock_guard lock(mutex_);
    is_stopped_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::unique_ptr<ReadPiece>> done_;
  std::size_t given_ = 0;
  std::size_t joined_ = 0;
  std::size_t ahead_;
  bool is_stopped_ = false;
};

namespace {

void parse_pieces(RaptorParser& parser, const FileText& text, PieceQueue& queue) {
  while (const auto number = queue.next()) {
    auto piece = std::make_unique<ReadPiece>();
    piece->error = parser.read(text, *number, piece->graph);
    piece->prefixes = parser.prefixes();
    piece->passed = parser.passed();
    piece->triples = parser.triple_count();
    queue.give_back(*number, std::move(piece));
  }
}

}  // namespace

Redland::Redland(const syntax::FileLimits& limits, unsigned threads)
    : limits_(limits), threads_(std::clamp(threads, 1U, max_threads)) {}

std::optional<syntax::LoadError> Redland::read(const std::string& path, syntax::Syntax syntax, syntax::FileBytes& bytes,
                                               const Layout& layout, Graph& graph) {
  if (syntax == syntax::Syntax::n_triples && layout.needs_turtle) syntax = syntax::Syntax::turtle;
  const std::string base = syntax::base_iri(path);
  const std::string blank_prefix = owl::blank_prefix_of(bytes.hash());
  const FileText text{bytes, syntax, base, blank_prefix, layout};
  prefixes_.clear();
  known_prefixes_.clear();
  passed_.clear();
  graph.begin_file();
  auto error = read_pieces(text, graph);
  if (error) error->file = base::printable(path, 4096);
  return error;
}

std::optional<syntax::LoadError> Redland::read_pieces(const FileText& text, Graph& graph) {
  try {
    return threads_ == 1 || text.layout.pieces.parts().size() == 1 ? read_in_turn(text, graph)
                                                                   : read_at_once(text, graph);
  } catch (const std::bad_alloc&) {
    return syntax::LoadError{{}, 0, "needs more memory than there is"};
  }
}

std::optional<syntax::LoadError> Redland::take_over(const std::vector<std::pair<std::string, std::string>>& prefixes,
                                                    const std::vector<Passed>& passed, std::uint64_t triples) {
  passed_.insert(passed_.end(), passed.begin(), passed.end());
  for (const auto& [prefix, iri] : prefixes) {
    std::string both = prefix;
    both.append(" ").append(iri);
    if (known_prefixes_.insert(std::move(both)).second) prefixes_.push_back({prefix, iri});
  }
  triples_ += triples;
  if (prefixes_.size() > limits_.prefixes)
    return syntax::LoadError{{}, 0, "declares more than " + std::to_string(limits_.prefixes) + " prefixes"};
  if (triples_ > limits_.triples)
    return syntax::LoadError{{}, 0, "is beyond " + std::to_string(limits_.triples) + " triples in all files"};
  return std::nullopt;
}

std::vector<std::unique_ptr<RaptorParser>>& Redland::parsers_for(syntax::Syntax syntax, std::size_t count) {
  auto& parsers = parsers_[syntax];
  while (parsers.size() < count) parsers.push_back(std::make_unique<RaptorParser>(limits_, syntax));
  return parsers;
}

std::optional<syntax::LoadError> Redland::read_in_turn(const FileText& text, Graph& graph) {
  RaptorParser& parser = *parsers_for(text.syntax, 1).front();
  for (std::size_t number = 0; number < text.layout.pieces.parts().size(); ++number) {
    if (auto error = parser.read(text, number, graph)) return error;
    if (auto error = take_over(parser.prefixes(), parser.passed(), parser.triple_count())) return error;
  }
  return std::nullopt;
}

std::optional<syntax::LoadError> Redland::read_at_once(const FileText& text, Graph& graph) {
  const std::size_t count = text.layout.pieces.parts().size();
  const std::size_t threads = std::min<std::size_t>(threads_, count);
  if (!parallel::has_room_for(threads)) return read_in_turn(text, graph);
  parallel::Crew crew(static_cast<unsigned>(threads) + 1);  // the caller's joins what the others parse
  if (crew.size() == 1) return read_in_turn(text, graph);
  const auto& parsers = parsers_for(text.syntax, crew.size() - 1);
  PieceQueue queue(count, 2 * threads);
  std::optional<syntax::LoadError> error;
  const auto work = [&](unsigned me) {
    if (me != 0) return parse_pieces(*parsers[me - 1], text, queue);
    error = join_pieces(queue, count, graph);
    queue.stop();
  };
  crew.run(work, [&] { queue.stop(); });
  return error;
}

std::optional<syntax::LoadError> Redland::join_pieces(PieceQueue& queue, std::size_t count, Graph& graph) {
  for (std::size_t number = 0; number < count; ++number) {
    const auto piece = queue.take(number);
    if (piece == nullptr) return std::nullopt;  // a parser has thrown
    if (piece->error) return std::move(piece->error);
    graph.append(piece->graph);
    if (auto error = take_over(piece->prefixes, piece->passed, piece->triples)) return error;
  }
  return std::nullopt;
}

}  // namespace geminga::rdf
