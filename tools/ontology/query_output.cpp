#include "ontology/query_output.hpp"

#include <algorithm>
#include <boost/json.hpp>

#include "base/text.hpp"
#include "base/utf8.hpp"

namespace geminga::ontology {
namespace {

using graph::Answer;
using graph::Node;

constexpr std::string_view xsd_string = "http://www.w3.org/2001/XMLSchema#string";
/// The greatest width of a column that is aligned.
constexpr std::size_t max_column_width = 80;

/// Writes a node as N-Triples and TSV do.
std::string as_ntriples(const Node& node) {
  if (node.kind == Node::Kind::iri) return '<' + node.text + '>';
  if (node.kind == Node::Kind::blank) return "_:" + node.text;
  std::string text = "\"";
  for (const char c : node.text) {
    switch (c) {
      case '"':
      case '\\':
        text += '\\';
        text += c;
        break;
      case '\n':
        text += "\\n";
        break;
      case '\r':
        text += "\\r";
        break;
      case '\t':
        text += "\\t";
        break;
      default:
        text += c;
    }
  }
  text += '"';
  if (!node.language.empty()) return text + '@' + node.language;
  return node.datatype.empty() || node.datatype == xsd_string ? text : text + "^^<" + node.datatype + '>';
}

/// Quotes a text with a comma, a quotation mark or a line end (RFC 4180).
std::string as_csv(const Node& node) {
  std::string text = node.kind == Node::Kind::blank ? "_:" + node.text : node.text;
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

boost::json::object as_json(const Node& node) {
  boost::json::object object{{"type", node.kind == Node::Kind::iri     ? "uri"
                                      : node.kind == Node::Kind::blank ? "bnode"
                                                                       : "literal"},
                             {"value", node.text}};
  if (!node.language.empty()) object["xml:lang"] = node.language;
  if (!node.datatype.empty()) object["datatype"] = node.datatype;
  return object;
}

std::string json(const Answer& answer) {
  boost::json::object head;
  boost::json::object document;
  if (answer.kind == Answer::Kind::truth) {
    document["head"] = head;
    document["boolean"] = answer.is_true;
    return boost::json::serialize(document) + '\n';
  }
  head["vars"] = boost::json::value_from(answer.variables);
  document["head"] = head;
  boost::json::array bindings;
  for (const auto& row : answer.rows) {
    boost::json::object binding;
    for (std::size_t at = 0; at < row.size(); ++at) {
      if (row[at]) binding[answer.variables[at]] = as_json(*row[at]);
    }
    bindings.push_back(std::move(binding));
  }
  document["results"] = boost::json::object{{"bindings", std::move(bindings)}};
  return boost::json::serialize(document) + '\n';
}

std::string separated(const Answer& answer, bool by_commas) {
  const std::string_view separator = by_commas ? "," : "\t";
  const std::string_view end = by_commas ? "\r\n" : "\n";
  std::string text;
  for (std::size_t at = 0; at < answer.variables.size(); ++at)
    text.append(at == 0 ? "" : separator).append(by_commas ? "" : "?").append(answer.variables[at]);
  text += end;
  for (const auto& row : answer.rows) {
    for (std::size_t at = 0; at < row.size(); ++at) {
      text.append(at == 0 ? "" : separator);
      if (row[at]) text.append(by_commas ? as_csv(*row[at]) : as_ntriples(*row[at]));
    }
    text += end;
  }
  return text;
}

std::string table(const Answer& answer, const std::function<std::string(std::string_view)>& short_name) {
  std::vector<std::vector<std::string>> cells{{}};
  for (const std::string& name : answer.variables) cells.front().push_back('?' + name);
  for (const auto& row : answer.rows) {
    auto& line = cells.emplace_back();
    for (const auto& node : row) {
      const std::string text = !node                           ? std::string()
                               : node->kind == Node::Kind::iri ? short_name(node->text)
                                                               : as_csv(*node);
      line.push_back(base::printable(text, 1000));
    }
  }
  std::vector<std::size_t> widths(answer.variables.size(), 0);
  for (const auto& line : cells) {
    for (std::size_t at = 0; at < line.size(); ++at)
      widths[at] = std::max(widths[at], std::min(base::count_characters(line[at]), max_column_width));
  }
  std::string text;
  for (const auto& line : cells) {
    std::string written;
    for (std::size_t at = 0; at < line.size(); ++at) {
      written += line[at];
      const std::size_t width = base::count_characters(line[at]);
      if (at + 1 < line.size()) written.append(width < widths[at] ? widths[at] - width + 2 : 2, ' ');
    }
    while (written.ends_with(' ')) written.pop_back();
    text += written + '\n';
  }
  return text;
}

}  // namespace

std::optional<Rows> find_rows(std::string_view name) {
  if (name == "table") return Rows::table;
  if (name == "json") return Rows::json;
  if (name == "csv") return Rows::csv;
  if (name == "tsv") return Rows::tsv;
  return std::nullopt;
}

std::string written(const Answer& answer, Rows rows, const std::function<std::string(std::string_view)>& short_name) {
  if (rows == Rows::json) return json(answer);
  if (answer.kind == Answer::Kind::truth) return answer.is_true ? "yes\n" : "no\n";
  return rows == Rows::table ? table(answer, short_name) : separated(answer, rows == Rows::csv);
}

}  // namespace geminga::ontology
