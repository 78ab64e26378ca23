#include "query/top/table_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include "shell/describe.hpp"
#include "shell/table.hpp"

namespace geminga::query::top {
namespace {

constexpr std::array<std::string_view, 4> orders{"name", "heard", "loss", "services"};

constexpr const char* help =
    "q quit   sort: n name, h heard, l loss, s services, r reverse   up/down select, enter why";

/// The lines of a table of any width; the first is its title.
std::vector<Line> lines_of(const shell::Table& table) {
  std::ostringstream out;
  table.print(out, shell::Terminal{});
  std::vector<Line> lines;
  std::istringstream in(out.str());
  for (std::string line; std::getline(in, line);) lines.push_back({line, lines.empty() ? Style::title : Style::plain});
  return lines;
}

std::string percent(const Record& record) {
  return record["loss"].empty() ? "" : std::to_string(std::lround(number_of(record, "loss") * 100)) + " %";
}

/// Whether a host is silent for longer than its loss explains: one in a thousand is late by chance. At 30 % one of
/// twenty has lost 2.5 announcements in a row, and that is nothing wrong.
bool is_late(const Record& record) {
  const double intervals = std::log(0.001) / std::log(std::clamp(number_of(record, "loss"), 0.05, 0.99));
  const double interval = number_of(record, "interval");
  return interval > 0 && number_of(record, "heard") > std::max(2.5, intervals) * interval;
}

std::string note_of(const Record& record) {
  if (record["self"] == "1") return "this host";
  if (record["hears_us"] == "0") return "does not hear us";
  return is_late(record) ? "late" : " ";
}

bool is_troubled(const Record& record) {
  const std::string note = note_of(record);
  return note == "late" || note == "does not hear us" || number_of(record, "loss_least") > 0.4;
}

std::string traffic(const Seen& seen, const char* datagrams, const char* octets) {
  const auto rate = [&](const char* key) {
    const auto at = seen.rates.find(key);
    return at == seen.rates.end() ? 0.0 : at->second;
  };
  return shell::number_words(rate(datagrams), "datagrams/s, ") + shell::number_words(rate(octets) / 1024, "KiB/s");
}

/// The rows of so many that are shown in this room, where a last line says how many more there are.
std::size_t shown_of(std::size_t rows, std::size_t room) {
  return rows <= room || room < 2 ? std::min(rows, room) : room - 1;
}

/// As many lines as there is room for, from `first` on, and how many more there are.
void append_some(std::vector<Line>& lines, const std::vector<Line>& rows, std::size_t first, std::size_t room) {
  const std::size_t left = rows.size() - first;
  const std::size_t shown = shown_of(left, room);
  for (std::size_t i = 0; i < shown; ++i) lines.push_back(rows[first + i]);
  if (shown < left && shown < room) lines.push_back({"and " + std::to_string(left - shown) + " more", Style::dim});
}

}  // namespace

std::optional<Order> order_of(std::string_view word) {
  const auto at = std::ranges::find(orders, word);
  if (at == orders.end()) return std::nullopt;
  return static_cast<Order>(at - orders.begin());
}

std::vector<Line> summary(const Seen& seen, const std::string& trouble) {
  const Record& status = seen.round.status;
  std::vector<Line> lines;
  if (!trouble.empty()) lines.push_back({shell::printable(trouble), Style::warning});
  if (status.fields.empty()) return lines;
  const auto text = [&](const char* key) { return shell::printable(status[key]); };
  lines.push_back({text("name") + " (" + text("participant") + "), " + text("state") + ", up " +
                       shell::duration_words(status["uptime"]) + ": " + text("participants") + " participants, " +
                       text("publications") + " services, " + text("subscriptions") + " requests, " +
                       std::to_string(seen.round.unmatched.size()) + " unmatched",
                   trouble.empty() ? Style::plain : Style::dim});
  lines.push_back({"heard " + traffic(seen, "datagrams_received", "bytes_received") + "; sent " +
                       traffic(seen, "datagrams_sent", "bytes_sent"),
                   trouble.empty() ? Style::plain : Style::dim});
  return lines;
}

std::vector<Line> TableView::participants(const Seen& seen) const {
  std::vector<const Record*> sorted;
  for (const Record& record : seen.round.participants) sorted.push_back(&record);
  const auto is_before = [&](const Record* one, const Record* other) {
    switch (order_) {
      case Order::name:
        break;
      case Order::heard:
        return number_of(*one, "heard") > number_of(*other, "heard");
      case Order::loss:
        return number_of(*one, "loss") > number_of(*other, "loss");
      case Order::services:
        return number_of(*one, "publications") > number_of(*other, "publications");
    }
    return (*one)["name"] < (*other)["name"];
  };
  std::ranges::stable_sort(sorted, is_before);
  if (is_reversed_) std::ranges::reverse(sorted);
  shell::Table table({{"NAME"},
                      {"HEARD", true},
                      {"INTERVAL", true},
                      {"LOSS", true},
                      {"PUBS", true},
                      {"SUBS", true},
                      {""},
                      {"ID"},
                      {"ADDRESSES"}});
  for (const Record* record : sorted) {
    table.add({(*record)["name"], shell::duration_words((*record)["heard"]),
               shell::duration_words((*record)["interval"]), percent(*record), (*record)["publications"],
               (*record)["subscriptions"], note_of(*record), (*record)["id"], (*record)["addresses"]});
  }
  for (const Gone& gone : seen.gone) {
    const std::string note = "gone for " + shell::duration_words(std::to_string(std::floor(gone.seconds)));
    table.add({gone.record["name"], "", "", "", gone.record["publications"], gone.record["subscriptions"], note,
               gone.record["id"], gone.record["addresses"]});
  }
  std::vector<Line> lines = lines_of(table);
  for (std::size_t i = 0; i < seen.gone.size(); ++i) lines[sorted.size() + 1 + i].style = Style::warning;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (is_troubled(*sorted[i])) lines[i + 1].style = Style::warning;
  }
  return lines;
}

std::vector<Line> TableView::unmatched(const Seen& seen) const {
  shell::Table table({{"UNMATCHED"}, {"IDENTITY"}, {"FOR", true}, {"WHY"}});
  for (const Record& record : seen.round.unmatched) {
    const auto since = seen.unmatched_for.find(record["subscription"]);
    const double seconds = since == seen.unmatched_for.end() ? 0 : since->second;
    const bool is_selected = record["subscription"] == selected_;
    table.add({(is_selected ? "> " : "  ") + shell::who(record["consumer"], record["name"], record["participant_name"]),
               shell::identity_words(record), shell::duration_words(std::to_string(std::floor(seconds))),
               record["because"]});
  }
  std::vector<Line> lines = lines_of(table);
  if (selected_row_ + 1 < lines.size()) lines[selected_row_ + 1].style = Style::selected;
  return lines;
}

std::size_t TableView::settle_selection(const Seen& seen) {
  const auto& requests = seen.round.unmatched;
  if (requests.empty()) {
    selected_.clear();
    return selected_row_ = 0;
  }
  const auto at = std::ranges::find(requests, std::string_view(selected_),
                                    [](const Record& record) { return record["subscription"]; });
  selected_row_ = at == requests.end() ? std::min(selected_row_, requests.size() - 1)
                                       : static_cast<std::size_t>(at - requests.begin());
  selected_ = requests[selected_row_]["subscription"];
  return selected_row_;
}

void TableView::move(const Seen& seen, std::ptrdiff_t by) {
  if (seen.round.unmatched.empty()) return;
  const auto last = static_cast<std::ptrdiff_t>(seen.round.unmatched.size()) - 1;
  const std::ptrdiff_t row =
      std::clamp(static_cast<std::ptrdiff_t>(settle_selection(seen)) + by, std::ptrdiff_t{0}, last);
  selected_row_ = static_cast<std::size_t>(row);
  selected_ = seen.round.unmatched[selected_row_]["subscription"];
}

TableView::Wish TableView::press(Key key, const Seen& seen) {
  if (key == 'q') return Wish::quit;
  if (explanation_) {
    explanation_.reset();
    return Wish::nothing;
  }
  const auto sort_by = [&](Order order) {
    order_ = order;
    is_reversed_ = false;
    return Wish::nothing;
  };
  if (key == 'n') return sort_by(Order::name);
  if (key == 'h') return sort_by(Order::heard);
  if (key == 'l') return sort_by(Order::loss);
  if (key == 's') return sort_by(Order::services);
  if (key == 'r') is_reversed_ = !is_reversed_;
  if (key == key::up || key == 'k') move(seen, -1);
  if (key == key::down || key == 'j') move(seen, 1);
  if (key == key::page_up) move(seen, -10);
  if (key == key::page_down) move(seen, 10);
  const bool asks = key == key::enter || key == 'w';
  if (asks) static_cast<void>(settle_selection(seen));
  return asks && !selected_.empty() ? Wish::ask_why : Wish::nothing;
}

void TableView::explain(const Seen& seen, const Answer& answer) {
  std::vector<std::string> texts;
  for (const Record& record : seen.round.unmatched) {
    if (record["subscription"] != selected_) continue;
    texts.push_back(shell::who(record["consumer"], record["name"], record["participant_name"]) + " asks for " +
                    shell::identity_words(record) + " (" + selected_ + ")");
  }
  texts.emplace_back("");
  for (const char* key : {"text", "mend"}) {
    if (!answer.end[key].empty()) texts.emplace_back(answer.end[key]);
  }
  for (const Record& record : answer.records) {
    texts.emplace_back("");
    texts.push_back(shell::who(record["provider"], record["name"], record["participant_name"]) + " offers " +
                    std::string(record["offered"]) + ": " + std::string(record["text"]));
    if (!record["mend"].empty()) texts.emplace_back(record["mend"]);
  }
  for (std::string& text : texts) text = shell::printable(text);
  explanation_ = std::move(texts);
}

std::vector<Line> TableView::whole(const Seen& seen) const {
  std::vector<Line> lines = summary(seen, "");
  for (const auto& table : {participants(seen), unmatched(seen)}) {
    if (table.empty()) continue;
    lines.emplace_back();
    lines.insert(lines.end(), table.begin(), table.end());
  }
  return lines;
}

std::vector<Line> TableView::lines(const Seen& seen, Size size, const std::string& trouble) {
  const std::size_t first_row = settle_selection(seen);
  std::vector<Line> lines = summary(seen, trouble);
  const std::size_t room = size.rows - std::min(size.rows, lines.size() + 2);  // without an empty line and the help
  lines.emplace_back();
  if (explanation_) {
    std::vector<Line> rows;
    for (const std::string& text : *explanation_) {
      for (const std::string& one : shell::wrapped(text, std::max<std::size_t>(size.columns, 2) - 1))
        rows.push_back({one});
    }
    append_some(lines, rows, 0, room);
  } else {
    const std::vector<Line> robots = participants(seen);
    const std::vector<Line> requests = unmatched(seen);
    // Each table has what the other leaves, and at least a half.
    const std::size_t needed = requests.empty() ? 0 : requests.size() + 1;
    const std::size_t of_robots = std::max(room - room / 2, room - std::min(room, needed));
    append_some(lines, robots, 0, of_robots);
    const std::size_t left = room - std::min(room, std::min(of_robots, robots.size()) + 1);
    if (!requests.empty() && left > 1) {
      lines.emplace_back();
      lines.push_back(requests.front());
      // The selected request is always on the screen.
      const std::size_t shown = shown_of(requests.size() - 1, left - 1);
      const std::size_t first = first_row + 1 > shown ? first_row + 1 - shown : 0;
      append_some(lines, requests, 1 + first, left - 1);
    }
  }
  if (lines.size() >= size.rows) lines.resize(size.rows - std::min<std::size_t>(size.rows, 1));
  while (lines.size() + 1 < size.rows) lines.emplace_back();
  lines.push_back({explanation_ ? "any key goes back, q quits" : help, Style::dim});
  return lines;
}

}  // namespace geminga::query::top
