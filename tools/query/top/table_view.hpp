// The table of geminga-query top: what it shows of a team, and what its keys do.
#ifndef GEMINGA_QUERY_TOP_TABLE_VIEW_HPP
#define GEMINGA_QUERY_TOP_TABLE_VIEW_HPP

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "query/top/keys.hpp"
#include "query/top/screen.hpp"
#include "query/top/tally.hpp"

namespace geminga::query::top {

enum class Order { name, heard, loss, services };
/// The order of this word, or nothing.
[[nodiscard]] std::optional<Order> order_of(std::string_view word);

/// Keeps order, selection and the open explanation. Does no input or output.
class TableView {
 public:
  /// The part of a key that the caller does.
  enum class Wish { nothing, quit, ask_why };

  explicit TableView(Order order) : order_(order) {}

  Wish press(Key key, const Seen& seen);
  /// The request that is selected; empty: there is none.
  [[nodiscard]] const std::string& selected() const { return selected_; }
  /// Shows this answer to `why` of the selected request, or why there is none, until a key closes it.
  void explain(const Seen& seen, const Answer& answer);
  void explain(std::string text) { explanation_ = {std::move(text)}; }

  /// All lines, for an output without an end.
  [[nodiscard]] std::vector<Line> whole(const Seen& seen) const;
  /// The lines for a terminal of this size. `trouble` says why the daemon cannot be asked; empty: it can.
  [[nodiscard]] std::vector<Line> lines(const Seen& seen, Size size, const std::string& trouble);

 private:
  [[nodiscard]] std::vector<Line> participants(const Seen& seen) const;
  [[nodiscard]] std::vector<Line> unmatched(const Seen& seen) const;
  void move(const Seen& seen, std::ptrdiff_t by);
  /// Keeps the selection on a request that is there.
  [[nodiscard]] std::size_t settle_selection(const Seen& seen);

  Order order_;
  bool is_reversed_ = false;
  std::string selected_;
  std::size_t selected_row_ = 0;
  std::optional<std::vector<std::string>> explanation_;
};

/// The lines above the tables: the daemon, its team and its traffic.
[[nodiscard]] std::vector<Line> summary(const Seen& seen, const std::string& trouble);

}  // namespace geminga::query::top

#endif
