// `geminga-ontology rank`, run as a user runs it, over tidy and careless collections.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json.hpp>
#include <filesystem>

#include "collection.hpp"
#include "program.hpp"

namespace geminga::ontology {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;

constexpr std::string_view head =
    "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#' "
    "xmlns:rdfs='http://www.w3.org/2000/01/rdf-schema#' xmlns:owl='http://www.w3.org/2002/07/owl#' xml:base='";

std::string below(const std::string& sub, const std::string& super) {
  return "<owl:Class rdf:ID='" + sub + "'><rdfs:subClassOf rdf:resource='" + super + "'/></owl:Class>\n";
}

std::string ontology(const std::string& base, const std::string& body) {
  return std::string(head) + base + "'>\n<owl:Ontology rdf:about=''/>\n" + body + "</rdf:RDF>\n";
}

std::string books(const std::string& name) { return "http://127.0.0.1/ontology/books.owl#" + name; }
std::string prices(const std::string& name) { return "http://127.0.0.1/ontology/concept.owl#" + name; }

/// A bookshop in the layout of the public collections.
class Shop {
 public:
  Shop() {
    for (const char* folder : {"c/ontology", "c/services/1.1", "c/queries/1.1"})
      std::filesystem::create_directories(program.folder() / folder);
    write("ontology/books.owl",
          ontology("http://127.0.0.1/ontology/books.owl",
                   below("Book", "#Print") + below("Novel", "#Book") + below("Magazine", "#Print") +
                       below("Author", "#Person") + below("Science%20Fiction", "#Novel") +
                       "<owl:Class rdf:ID='Print'/><owl:Class rdf:ID='Person'/>"));
    write("ontology/concept.owl", ontology("http://127.0.0.1/ontology/concept.owl",
                                           below("TaxedPrice", "#Price") + "<owl:Class rdf:ID='Price'/>"));
    service("book_price", {books("Book")}, {prices("Price")});
    service("novel_price", {books("Novel")}, {prices("Price")});
    service("print_taxedprice", {books("Print")}, {prices("TaxedPrice")});
    service("book_author", {books("Book")}, {books("Author")});
    request("book_price", {books("Book")}, {prices("Price")});
  }

  void write(const std::string& name, std::string_view content) const { program.write("c/" + name, content); }
  void service(const std::string& name, const std::vector<std::string>& inputs,
               const std::vector<std::string>& outputs) const {
    write("services/1.1/" + name + ".owls", owls(inputs, outputs));
  }
  void request(const std::string& name, const std::vector<std::string>& inputs,
               const std::vector<std::string>& outputs) const {
    write("queries/1.1/" + name + ".owls", owls(inputs, outputs));
  }
  [[nodiscard]] Outcome rank(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"rank", "--services", "c/services", "--requests", "c/queries"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return program.run(arguments);
  }
  /// The services in their order, without the ending.
  [[nodiscard]] std::vector<std::string> order(const std::vector<std::string>& more = {}) const {
    const Outcome outcome = rank(more);
    std::vector<std::string> names;
    for (std::size_t at = 0; at < outcome.out.size(); at = outcome.out.find('\n', at) + 1) {
      std::size_t begin = outcome.out.find('\t', at) + 1;
      begin = outcome.out.find('\t', begin) + 1;
      const std::string name = outcome.out.substr(begin, outcome.out.find('\t', begin) - begin);
      names.push_back(name.substr(0, name.rfind('.')));
    }
    return names;
  }
  /// The printed score of a service.
  [[nodiscard]] std::string score(const std::string& service) const {
    const std::string out = rank().out;
    const std::size_t at = out.find('\t' + service + ".owls\t");
    return at == std::string::npos ? "" : out.substr(out.find('.', at + service.size() + 3) - 1, 11);
  }

  Program program;
};

TEST(Rank, PutsTheBestServiceFirstAndFindsTheFolderOfOntologies) {
  const Shop shop;
  const Outcome outcome = shop.rank();
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, StartsWith("book_price.owls\t1\tbook_price.owls\t1.000000000\n"));
  EXPECT_THAT(shop.order(), ElementsAre("book_price", "print_taxedprice", "novel_price", "book_author"));
  EXPECT_THAT(shop.order({"--limit", "2"}), ElementsAre("book_price", "print_taxedprice"));
  EXPECT_EQ(shop.rank({"--ontologies", "c/ontology"}).out, outcome.out);
}

TEST(Rank, SaysWhyWhereItIsAsked) {
  const Shop shop;
  EXPECT_THAT(shop.rank({"--reasons"}).out, HasSubstr("\tprint_taxedprice.owls\t0."));
  EXPECT_THAT(shop.rank({"--reasons"}).out,
              HasSubstr("\toutputs 0.000: Price by Author none 0.000; inputs 1.000: Book by Book equivalent 1.000\n"));
  const auto document = boost::json::parse(shop.rank({"--json"}).out);
  const auto& first = document.at("requests").at(0);
  EXPECT_EQ(first.at("request").as_string(), "book_price.owls");
  EXPECT_EQ(first.at("services").as_array().size(), 4U);
  const auto& second = first.at("services").at(1);
  EXPECT_EQ(second.at("service").as_string(), "print_taxedprice.owls");
  EXPECT_EQ(second.at("rank").as_int64(), 2);
  const auto& pair = second.at("outputs").at("pairs").at(0);
  EXPECT_EQ(pair.at("required").as_string(), prices("Price"));
  EXPECT_EQ(pair.at("offered").as_string(), prices("TaxedPrice"));
  EXPECT_EQ(pair.at("relation").as_string(), "narrower");
  EXPECT_EQ(document.at("services").as_int64(), 4);
  EXPECT_TRUE(document.at("problems").as_array().empty());
}

TEST(Rank, WritesRunsForTrecEval) {
  const Shop shop;
  EXPECT_THAT(shop.rank({"--format", "trec"}).out,
              StartsWith("book_price.owls Q0 book_price.owls 1 1.000000000 geminga\n"));
  EXPECT_EQ(shop.rank({"--format", "xml"}).status, 2);
}

TEST(Rank, NamesAndCountsWhatIsBrokenAndGoesOn) {
  const Shop shop;
  shop.write("services/1.1/broken.owls", "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#'><oops");
  shop.write("services/1.1/empty.owls", ontology("http://e/", ""));
  const std::string whole = owls({books("Book")}, {prices("Price")});
  shop.write("services/1.1/cut.owls", whole.substr(0, whole.find("<process:Output")));
  shop.write("ontology/bad.owl", "<!DOCTYPE r [<!ENTITY % e 'x'>]><r/>");
  const Outcome outcome = shop.rank();
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("broken.owls"));
  EXPECT_THAT(outcome.err, HasSubstr("empty.owls: holds no profile of a service"));
  EXPECT_THAT(outcome.err, HasSubstr("cut.owls:"));
  EXPECT_THAT(outcome.err, HasSubstr("bad.owl"));
  EXPECT_THAT(outcome.err, HasSubstr("4 files are not right: all others are ranked"));
  EXPECT_THAT(shop.order(), ElementsAre("book_price", "print_taxedprice", "novel_price", "book_author"));
  EXPECT_EQ(boost::json::parse(shop.rank({"--json"}).out).at("problems").as_array().size(), 4U);
}

TEST(Rank, EndsWhereNothingCanBeRead) {
  const Shop shop;
  const Outcome none = shop.program.run({"rank", "--services", "nowhere", "--requests", "c/queries"});
  EXPECT_EQ(none.status, 2);
  EXPECT_THAT(none.err, HasSubstr("nowhere: there is no such file or folder"));
  shop.program.write("none.owls", ontology("http://e/", ""));
  const Outcome empty = shop.program.run({"rank", "--services", "none.owls", "--requests", "c/queries"});
  EXPECT_EQ(empty.status, 2);
  EXPECT_THAT(empty.err, HasSubstr("no service that can be read"));
  std::filesystem::create_directories(shop.program.folder() / "bare");
  EXPECT_EQ(shop.program.run({"rank", "--services", "bare", "--requests", "c/queries"}).status, 2);
  EXPECT_EQ(shop.program.run({"rank", "--services", "c/services"}).status, 2);
}

TEST(Rank, ReadsFilesWhoseNamesEndInCapitals) {
  const Shop shop;
  shop.write("services/1.1/again.OWLS", owls({books("Book")}, {prices("Price")}));
  EXPECT_THAT(shop.rank({}).out, HasSubstr("\tagain.OWLS\t1.0"));
}

TEST(Rank, KnowsAnOntologyUnderSeveralUrls) {
  const Shop shop;
  const std::string known = shop.score("novel_price");
  shop.service("host", {"http://localhost:8080/ontology/books.owl#Novel"}, {prices("Price")});
  shop.service("spaces", {"\n  " + books("Novel") + "  \n"}, {"  " + prices("Price")});
  shop.service("letters", {"http://localhost/Books.owl#novel"}, {prices("Price")});
  shop.service("ending", {"http://localhost/books#Novel"}, {prices("Price")});
  for (const char* name : {"host", "spaces", "letters", "ending"}) EXPECT_EQ(shop.score(name), known) << name;
  shop.service("percent", {books("Science%20Fiction")}, {prices("Price")});
  const std::string narrower = shop.score("percent");
  EXPECT_LT(narrower, known);
  shop.service("decoded", {books("Science Fiction")}, {prices("Price")});
  EXPECT_EQ(shop.score("decoded"), narrower);
  EXPECT_THAT(shop.rank().err, IsEmpty());
}

TEST(Rank, KnowsAnOntologyByItsFileAndJoinsItsCopies) {
  const Shop shop;
  const std::string narrower = shop.score("print_taxedprice");
  // One copy has an IRI that the editor made, and another copy has a third one.
  shop.write("ontology/money.owl", ontology("http://www.owl-ontologies.com/Ontology1107.owl",
                                            below("Fee", "#Money") + "<owl:Class rdf:ID='Money'/>"));
  shop.write("ontology/old/money.owl",
             ontology("http://elsewhere/money.owl", below("Fee", "#Money") + "<owl:Class rdf:ID='Money'/>"));
  shop.request("book_money", {books("Book")}, {"http://127.0.0.1/ontology/money.owl#Money"});
  shop.service("book_fee", {books("Book")}, {"http://elsewhere/money.owl#Fee"});
  EXPECT_THAT(shop.rank({"--limit", "1"}).out, HasSubstr("book_money.owls\t1\tbook_fee.owls\t0.9"));
  EXPECT_FALSE(narrower.empty());
}

TEST(Rank, TakesADocumentThatHasTheSameClassesForACopyUnlessTheyAreFew) {
  const Shop shop;
  for (const auto& [file, count] : {std::pair("few", 9), std::pair("many", 10)}) {
    for (const std::string part : {"one", "other"}) {
      std::string classes = "<owl:Class rdf:ID='Root'/>";
      for (int at = 1; at < count; ++at) classes += below("C" + std::to_string(at), "#Root");
      const std::string name = std::string(file) + part;
      shop.write("ontology/" + name + ".owl", ontology("http://127.0.0.1/ontology/" + name + ".owl", classes));
    }
    const std::string base = "http://127.0.0.1/ontology/" + std::string(file);
    shop.service(std::string(file) + "_service", {}, {base + "one.owl#C1"});
    shop.request(std::string(file) + "_request", {}, {base + "other.owl#C1"});
  }
  const std::string out = shop.rank().out;
  EXPECT_THAT(out, HasSubstr("many_request.owls\t1\tmany_service.owls\t1.000000000\n"));
  EXPECT_THAT(out, Not(HasSubstr("\tfew_service.owls\t1.0")));
}

TEST(Rank, SaysWhichTypesAreInNoOntologyAndMatchesThemByName) {
  const Shop shop;
  shop.service("map", {books("Book")}, {"http://127.0.0.1/ontology/none.owl#Map"});
  shop.request("map", {books("Book")}, {"http://localhost/none.owl#Map"});
  const Outcome outcome = shop.rank({"--limit", "1"});
  EXPECT_THAT(outcome.err, HasSubstr("2 types are in no ontology and match only themselves, the first "
                                     "<http://127.0.0.1/ontology/none.owl#Map>"));
  EXPECT_THAT(outcome.out, HasSubstr("map.owls\t1\tmap.owls\t1.000000000\n"));
}

TEST(Rank, GivesAServiceTheSameScoreWhateverTypesOthersName) {
  const Shop shop;
  shop.service("count", {"http://www.w3.org/2001/XMLSchema#decimal"}, {"http://www.w3.org/2001/XMLSchema#int"});
  shop.request("number", {"http://www.w3.org/2001/XMLSchema#integer"}, {"http://www.w3.org/2001/XMLSchema#integer"});
  const auto first = [&] {
    const std::string out = shop.rank().out;
    const std::size_t at = out.find("number.owls\t1\t");
    return at == std::string::npos ? out : out.substr(at, out.find('\n', at) - at);
  };
  const std::string alone = first();
  EXPECT_THAT(alone, testing::StartsWith("number.owls\t1\tcount.owls\t0.8"));
  shop.service("map", {}, {"http://127.0.0.1/ontology/none.owl#Map", "http://127.0.0.1/ontology/none.owl#Way"});
  EXPECT_EQ(first(), alone);
}

TEST(Rank, TakesDatatypesForConcepts) {
  const Shop shop;
  const std::string xsd = "http://www.w3.org/2001/XMLSchema#";
  shop.service("count", {xsd + "decimal"}, {xsd + "int"});
  shop.service("text", {xsd + "decimal"}, {xsd + "string"});
  shop.request("number", {xsd + "integer"}, {xsd + "integer"});
  const Outcome outcome = shop.rank({"--limit", "2"});
  EXPECT_THAT(outcome.out, HasSubstr("number.owls\t1\tcount.owls\t0.8"));
  EXPECT_THAT(outcome.out, HasSubstr("number.owls\t2\ttext.owls\t0.0"));
}

TEST(Rank, UsesWhatFollowsAndNotWhatAContradictionImplies) {
  const Shop shop;
  // A comic is defined as a book with pictures, and no axiom says that it is below a book.
  shop.write(
      "ontology/comic.owl",
      ontology(
          "http://127.0.0.1/ontology/comic.owl",
          "<owl:Ontology rdf:about=''><owl:imports rdf:resource='http://127.0.0.1/ontology/books.owl'/></owl:Ontology>"
          "<owl:ObjectProperty rdf:ID='of'/><owl:Class rdf:ID='Picture'/>"
          "<owl:Class rdf:ID='Comic'><rdfs:subClassOf><owl:Restriction><owl:onProperty rdf:resource='#of'/>"
          "<owl:someValuesFrom rdf:resource='#Picture'/></owl:Restriction></rdfs:subClassOf></owl:Class>"
          "<owl:Class rdf:ID='Illustrated'><owl:equivalentClass><owl:Restriction><owl:onProperty "
          "rdf:resource='#of'/><owl:someValuesFrom rdf:resource='#Picture'/></owl:Restriction>"
          "</owl:equivalentClass><rdfs:subClassOf "
          "rdf:resource='http://127.0.0.1/ontology/books.owl#Book'/></owl:Class>"));
  shop.write("ontology/mad.owl", ontology("http://127.0.0.1/ontology/mad.owl",
                                          below("Mad", "#Madness") +
                                              "<owl:Class rdf:about='#Mad'><owl:disjointWith rdf:resource='#Madness'/>"
                                              "</owl:Class><rdf:Description rdf:ID='i'><rdf:type rdf:resource='#Mad'/>"
                                              "</rdf:Description>"));
  shop.service("comic_price", {"http://127.0.0.1/ontology/comic.owl#Comic"}, {prices("Price")});
  shop.service("mad_price", {"http://127.0.0.1/ontology/mad.owl#Mad"}, {prices("Price")});
  shop.request("mad", {books("Author")}, {"http://127.0.0.1/ontology/mad.owl#Madness"});
  const Outcome outcome = shop.rank({"--reasons"});
  EXPECT_THAT(outcome.out, HasSubstr("inputs 0.")) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Comic by Book broader"));
  EXPECT_THAT(outcome.out, HasSubstr("Mad by Book none"));
  EXPECT_THAT(outcome.err, HasSubstr("mad.owl: contradicts itself: it counts as it is written"));
}

TEST(Rank, TakesServicesWithoutInputsOrOutputsAndWithoutTypes) {
  const Shop shop;
  shop.service("price", {}, {prices("Price")});
  shop.service("nothing", {books("Book")}, {});
  shop.service("untyped", {""}, {prices("Price")});
  shop.request("effect", {books("Book")}, {});
  const std::vector<std::string> order = shop.order();
  ASSERT_EQ(order.size(), 14U);
  EXPECT_THAT(
      std::vector(order.begin(), order.begin() + 7),
      ElementsAre("book_price", "print_taxedprice", "novel_price", "untyped", "price", "book_author", "nothing"));
  EXPECT_EQ(order[7], "nothing");
}

TEST(Rank, CallsFilesOfOneNameByTheirFolders) {
  const Shop shop;
  shop.write("services/other/book_price.owls", owls({books("Book")}, {prices("Price")}));
  EXPECT_THAT(
      shop.rank().out,
      HasSubstr("book_price.owls\t1\t1.1/book_price.owls\t1.000000000\nbook_price.owls\t2\tother/book_price.owls\t"));
}

TEST(Rank, DependsOnNoOrderOfFiles) {
  const Shop shop;
  const std::string out = shop.rank().out;
  EXPECT_EQ(shop.program
                .run({"rank", "--ontologies", "c/ontology/concept.owl", "c/ontology/books.owl", "--services",
                      "c/services/1.1/print_taxedprice.owls", "--services", "c/services/1.1/book_price.owls",
                      "--services", "c/services/1.1/book_author.owls", "--services", "c/services/1.1/novel_price.owls",
                      "--requests", "c/queries/1.1/book_price.owls"})
                .out,
            out);
}

}  // namespace
}  // namespace geminga::ontology
