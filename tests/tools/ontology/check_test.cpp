// The output of check for good, wrong and doubtful ontologies.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json.hpp>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(Check, TheShippedOntologiesAreCompleteAndWithoutProblem) {
  const Outcome outcome = Program().run({"check", shipped()});
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Complete: everything that follows from these files was found.\n"));
  EXPECT_THAT(outcome.out, AllOf(Not(HasSubstr("Left out")), Not(HasSubstr("Imports")), Not(HasSubstr("Prefixes"))));
}

TEST(Check, NamesUnsatisfiableClassesWithTheirReasons) {
  const Program program;
  program.turtle("a.ttl", ":A rdfs:subClassOf :B ,\n  :C .\n:B owl:disjointWith :C .\n:D rdfs:subClassOf :A .\n");
  const Outcome outcome = program.run({"check", "a.ttl"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("1 file, 4 triples, 4 classes, 4 axioms\n"));
  EXPECT_THAT(outcome.out, HasSubstr("Classes that can have no instance:\n  e:A\n"));
  EXPECT_THAT(outcome.out, HasSubstr("e:A SubClassOf e:B   [a.ttl:2]"));
  EXPECT_THAT(outcome.out, HasSubstr("e:A SubClassOf e:C   [a.ttl:3]"));
  EXPECT_THAT(outcome.out,
              HasSubstr("Classes that can have none because of these (mend those first, and check again):\n"
                        "  e:D\n    depends on e:A\n    because e:D SubClassOf e:A   [a.ttl:5]\n"));
  const auto document = boost::json::parse(program.run({"check", "--json", "a.ttl"}).out).as_object();
  EXPECT_TRUE(document.at("unsatisfiable").at(0).at("root").is_null());
  EXPECT_EQ(document.at("unsatisfiable").at(1).at("root"), "e:A");
}

TEST(Check, SaysWhereALimitEndedTheSearchForReasons) {
  const Program program;
  program.turtle("a.ttl", ":A rdfs:subClassOf :B , :C .\n:B owl:disjointWith :C .\n");
  ASSERT_EQ(program.run({"compile", "a.ttl", "-o", "a.geminga"}).status, 0);
  const Outcome outcome = program.run({"check", "a.geminga", "--steps", "1"});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.out, HasSubstr("Classes that can have no instance:\n  e:A\n"));
  EXPECT_THAT(outcome.err, HasSubstr("there may be more reasons than are printed"));
}

TEST(Check, MakesNoClassEmptyOfABoundOfAnotherDatatype) {
  const Program program;
  program.turtle("a.ttl",
                 "@prefix xsd: <http://www.w3.org/2001/XMLSchema#> . :u a owl:DatatypeProperty . :A a owl:Class ; "
                 "rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :u ; "
                 "owl:someValuesFrom [ a rdfs:Datatype ; owl:onDatatype xsd:double ; owl:withRestrictions ( [ "
                 "xsd:maxInclusive 1 ] ) ] ] .");
  const Outcome strict = program.run({"check", "a.ttl"});
  EXPECT_EQ(strict.status, 0) << strict.out;
  EXPECT_THAT(strict.out,
              HasSubstr("Left out:\n  a facet or bound that its datatype does not have: 1, first at a.ttl:2"));
  EXPECT_THAT(strict.out, HasSubstr("Incomplete"));
  const Outcome lenient = program.run({"check", "a.ttl", "--lenient"});
  EXPECT_EQ(lenient.status, 0) << lenient.out;
  EXPECT_THAT(lenient.out, HasSubstr("Read otherwise than written:\n  a bound or literal of another datatype, read as "
                                     "the number: 1, first at a.ttl:2\n"));
  EXPECT_THAT(lenient.out, HasSubstr("Complete: everything that follows"));
}

TEST(Check, ListsWhatWasLeftOutWithItsFirstPlace) {
  const Program program;
  program.turtle(
      "a.ttl",
      ":A rdfs:subClassOf :B .\n:B owl:newInOwl3 :C .\n:B owl:newInOwl3 :D .\n<http://e/o> a owl:Ontology ;\n"
      "  owl:imports <http://e/nowhere> .\n");
  const Outcome outcome = program.run({"check", "a.ttl"});
  EXPECT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr("  owl:newInOwl3: 2, first at a.ttl:3\n"));
  EXPECT_THAT(outcome.out, HasSubstr("  <http://e/nowhere> at a.ttl:6\n"));
  EXPECT_THAT(outcome.out, HasSubstr("\nIncomplete: every answer is right, but some may be missing"));
}

TEST(Check, CountsUnitsAndSaysWhichWereLeftOut) {
  const Program program;
  program.turtle(
      "a.ttl",
      "@prefix qudt: <http://qudt.org/schema/qudt/> . @prefix d: <http://qudt.org/vocab/dimensionvector/> .\n"
      ":Pitch a qudt:Unit ; qudt:conversionMultiplier 105 ; qudt:hasDimensionVector d:A0E0L1I0M0H0T0D0 ;\n"
      "  qudt:symbol \"pitch\" .\n:Wind a qudt:Unit ; qudt:conversionMultiplier 0.0 ;\n"
      "  qudt:hasDimensionVector d:A0E0L1I0M0H0T-1D0 .\n:A rdfs:subClassOf :B .\n");
  const std::string said =
      "Units of measurement for conditions: 1 read; left out:\n"
      "  a unit whose factor is not positive, or too large or too small, like http://e/Wind: 1, first at ";
  const Outcome outcome = program.run({"check", "a.ttl"});
  EXPECT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr(said + "a.ttl:5\n"));
  EXPECT_THAT(outcome.out, HasSubstr("Complete: everything that follows")) << "the taxonomy lacks nothing";
  ASSERT_EQ(program.run({"compile", "-o", "a.geminga", "a.ttl"}).status, 0);
  EXPECT_THAT(program.run({"check", "a.geminga"}).out, HasSubstr(said));
  const auto document = boost::json::parse(program.run({"check", "--json", "a.ttl"}).out).as_object();
  EXPECT_EQ(document.at("units").at("read").to_number<int>(), 1);
  EXPECT_EQ(document.at("units").at("left_out").at(0).at("first").as_string(), "a.ttl:5");
  EXPECT_TRUE(document.at("complete").as_bool());
}

TEST(Check, ListsWhatWasNotUsedAxiomByAxiom) {
  const Program program;
  std::string axioms = ":r a owl:TransitiveProperty .\n";
  for (int at = 0; at < 7; ++at)
    axioms += ":A" + std::to_string(at) + " rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :r ; " +
              "owl:maxCardinality 2 ] , :B .\n";
  // Three disjoint fillers: with fewer the cardinalities would have no consequence.
  for (int at = 0; at < 3; ++at) {
    const std::string filler = ":C" + std::to_string(at);
    axioms += ":B rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :r ; owl:someValuesFrom " + filler + " ] .\n" +
              filler + " owl:disjointWith :C" + std::to_string((at + 1) % 3) + " .\n";
  }
  program.turtle("a.ttl", axioms);
  const Outcome few = program.run({"check", "a.ttl"});
  EXPECT_EQ(few.status, 0) << few.err;
  EXPECT_THAT(few.out, HasSubstr("    e:A0 SubClassOf e:r max 2   [a.ttl:3]\n"));
  EXPECT_THAT(few.out, HasSubstr("    e:A4 SubClassOf e:r max 2   [a.ttl:7]\n    and 2 more: --all\n"));
  EXPECT_THAT(few.out, Not(HasSubstr("e:A5")));
  EXPECT_THAT(few.out, HasSubstr("\nIncomplete: every answer is right, but some may be missing, because of "));
  const Outcome all = program.run({"check", "--all", "a.ttl"});
  EXPECT_THAT(all.out, AllOf(HasSubstr("    e:A6 SubClassOf e:r max 2   [a.ttl:9]\n"), Not(HasSubstr("--all"))));
  const boost::json::value found = boost::json::parse(program.run({"check", "--json", "a.ttl"}).out);
  EXPECT_EQ(found.at("left_out").at(0).at("count"), 7);
  EXPECT_EQ(found.at("left_out").at(0).at("axioms").as_array().size(), 7U);
  EXPECT_EQ(found.at("left_out").at(0).at("axioms").at(6).at("line"), 9);
  EXPECT_EQ(found.at("complete"), false);
}

TEST(Check, IsCompleteBeyondEl) {
  const Program program;
  program.turtle("a.ttl",
                 ":A rdfs:subClassOf [ owl:unionOf (:B :C) ] . :B rdfs:subClassOf :D . :C rdfs:subClassOf :D .\n"
                 ":r owl:inverseOf :s . :D rdfs:subClassOf [ owl:onProperty :r ; owl:allValuesFrom :A ] .\n");
  const Outcome outcome = program.run({"check", "a.ttl"});
  EXPECT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr("Complete: everything that follows from these files was found.\n"));
  EXPECT_EQ(program.run({"subsumes", "a.ttl", "--sub", "e:A", "--super", "e:D"}).status, 0);
}

TEST(Check, ReportsCollidingNamesAndPrefixes) {
  const Program program;
  // Found by trying: XXH32 of <http://e/C4222> and of <http://e/C159386> is 0x17c5b94d.
  program.turtle("a.ttl", ":C4222 rdfs:subClassOf :B .\n:C159386 rdfs:subClassOf :B .\n");
  program.write("b.ttl", "@prefix e: <http://f/> .\n");
  const Outcome outcome = program.run({"check", "a.ttl", "b.ttl"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("  0x17c5b94d: <http://e/C159386> <http://e/C4222>\n"));
  EXPECT_THAT(outcome.out, HasSubstr("  e: is <http://e/>, not <http://f/>\n"));
}

TEST(Check, SaysForHowManyClassesNoReasonWasFound) {
  const Program program;
  std::string text = ":B owl:disjointWith :C .\n";
  for (int number = 0; number < 103; ++number) text += ":A" + std::to_string(number) + " rdfs:subClassOf :B , :C .\n";
  program.turtle("a.ttl", text);
  const Outcome outcome = program.run({"check", "a.ttl"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("No reason was looked for or found for 3 classes without a \"because\""));
  program.turtle("a.ttl", ":B owl:disjointWith :C . :A rdfs:subClassOf :B , :C .\n");
  EXPECT_THAT(program.run({"check", "a.ttl"}).out, Not(HasSubstr("No reason ")));
}

TEST(Check, AContradictionIsAProblem) {
  const Program program;
  program.turtle("a.ttl", ":i a :A, :B . :A owl:disjointWith :B .\n");
  const Outcome outcome = program.run({"check", "a.ttl"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("Contradiction: "));
  EXPECT_THAT(outcome.out, HasSubstr("no fewer of them do:\n"));
  EXPECT_THAT(outcome.out, HasSubstr("because e:i Type e:A   [a.ttl:"));
  EXPECT_THAT(outcome.out, HasSubstr("because e:i Type e:B   [a.ttl:"));
  EXPECT_THAT(outcome.out, HasSubstr("because e:A DisjointWith e:B   [a.ttl:"));
}

TEST(Check, NamesTheClassesThatCanHaveNoInstanceEvenWithoutTheContradiction) {
  const Program program;
  program.turtle("a.ttl", ":E rdfs:subClassOf :A, :B . :A owl:disjointWith :B . :i a :E . :C rdfs:subClassOf :A .\n");
  const Outcome outcome = program.run({"check", "a.ttl"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("Classes that can have no instance even if all facts are left aside:\n  e:E\n"));
  EXPECT_THAT(outcome.out, HasSubstr("    because e:E SubClassOf e:A   [a.ttl:"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("  e:C\n"))) << "everything follows from the contradiction, but not from this";
}

// The pigeonhole principle: n + 1 pigeons, n holes, no two pigeons in one hole.
std::string pigeonhole(int holes) {
  std::string text;
  const auto place = [](int pigeon, int hole) { return ":p" + std::to_string(pigeon) + 'h' + std::to_string(hole); };
  for (int pigeon = 0; pigeon <= holes; ++pigeon) {
    text += ":X rdfs:subClassOf [ a owl:Class ; owl:unionOf (";
    for (int hole = 0; hole < holes; ++hole) text += place(pigeon, hole) + ' ';
    text += ") ] .\n";
    for (int hole = 0; hole < holes; ++hole) {
      for (int other = 0; other < pigeon; ++other)
        text += place(pigeon, hole) + " owl:disjointWith " + place(other, hole) + " .\n";
    }
  }
  return text;
}

TEST(Check, SaysWhatWasNotDecidedWhereTheELPartReachesItsLimit) {
  const Program program;
  std::string parts =
      ":p a owl:ObjectProperty , owl:TransitiveProperty . :A rdfs:subClassOf :B . :B rdfs:subClassOf :C .\n";
  for (int at = 0; at < 150; ++at) {
    const std::string n = std::to_string(at);
    parts += ":L" + n + " rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; owl:someValuesFrom :L" +
             std::to_string(at + 1) + " ] . :In" + n +
             " owl:equivalentClass [ a owl:Restriction ; owl:onProperty :p ; owl:someValuesFrom :L" + n + " ] .\n";
  }
  program.turtle("a.ttl", parts);
  EXPECT_THAT(program.run({"check", "a.ttl"}).out, HasSubstr("Complete: "));
  const Outcome outcome = program.run({"check", "a.ttl", "--steps", "100"});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.out, HasSubstr("Not decided: whether the files contradict themselves.\n"));
  EXPECT_THAT(outcome.out, HasSubstr("Not decided: whether more is above "));
  EXPECT_THAT(outcome.out, HasSubstr("Incomplete: "));
  EXPECT_THAT(outcome.err, HasSubstr("the limit of 100 steps was reached"));
  const Outcome classified = program.run({"classify", "a.ttl", "--closure", "--steps", "100"});
  EXPECT_EQ(classified.status, 4);
  EXPECT_THAT(classified.out, HasSubstr("http://e/A\thttp://e/C\n"));
  EXPECT_EQ(program.run({"compile", "a.ttl", "-o", "a.geminga", "--steps", "100"}).status, 4);
  EXPECT_THAT(program.run({"check", "a.geminga"}).out, HasSubstr("Incomplete: "));
  EXPECT_EQ(program.run({"consistent", "a.ttl", "--steps", "100"}).status, 4);
  const Outcome drawn = program.run({"draw", "a.ttl", "--steps", "100"});
  EXPECT_EQ(drawn.status, 4);
  EXPECT_THAT(drawn.out, StartsWith("digraph taxonomy {\n"));
  EXPECT_THAT(drawn.err, HasSubstr("raise the limit"));
}

TEST(Check, SaysWhatIsNotDecidedAndWhoHoldsItUpWhereALimitIsReached) {
  const Program program;
  program.turtle("a.ttl", pigeonhole(9) + ":A rdfs:subClassOf :B . :B rdfs:subClassOf [ owl:unionOf (:C :D) ] .\n");
  const Outcome outcome = program.run({"check", "a.ttl", "--steps", "100000"});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.out, HasSubstr("Not decided: whether more is above "));
  EXPECT_THAT(outcome.out, HasSubstr("Held up by e:X\n"));
  EXPECT_THAT(outcome.out, HasSubstr("Incomplete: "));
  EXPECT_THAT(outcome.err, HasSubstr("the limit of 100000 steps was reached"));
}

TEST(Classify, PrintsWhatIsSettledWhereALimitIsReached) {
  const Program program;
  program.turtle("a.ttl", pigeonhole(9) + ":A rdfs:subClassOf :B . :B rdfs:subClassOf [ owl:unionOf (:C :D) ] .\n");
  const Outcome outcome = program.run({"classify", "a.ttl", "--closure", "--steps", "100000"});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.out, HasSubstr("http://e/A\thttp://e/B\n"));
  EXPECT_THAT(outcome.err, HasSubstr("held up by e:X"));
}

TEST(Classify, SaysWhatIsOpenWhereTheSearchWasTooHard) {
  const Program program;
  program.turtle("a.ttl", pigeonhole(12));
  const Outcome outcome = program.run({"classify", "a.ttl", "--closure"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("held up by e:X"));
}

TEST(Compile, WritesWhatIsSettledWhereALimitIsReached) {
  const Program program;
  program.turtle("a.ttl", pigeonhole(9) + ":A rdfs:subClassOf :B . :B rdfs:subClassOf [ owl:unionOf (:C :D) ] .\n");
  EXPECT_EQ(program.run({"compile", "a.ttl", "-o", "a.geminga", "--steps", "100000"}).status, 4);
  const Outcome outcome = program.run({"check", "a.geminga"});
  EXPECT_THAT(outcome.out, HasSubstr("undecided: "));
  EXPECT_THAT(outcome.out, HasSubstr("held up by e:X"));
}

TEST(Subsumes, DoesNotSayNoOfWhatIsNotDecided) {
  const Program program;
  program.turtle("a.ttl", pigeonhole(9) + ":A rdfs:subClassOf :B . :B rdfs:subClassOf [ owl:unionOf (:C :D) ] .\n");
  const auto ask = [&](const std::string& sub) {
    return program.run({"subsumes", "a.ttl", "--sub", sub, "--super", "e:B", "--steps", "100000"});
  };
  EXPECT_EQ(ask("e:A").status, 0);
  EXPECT_EQ(ask("e:X").status, 4);
  EXPECT_THAT(ask("e:X").out, HasSubstr("is not known to be subsumed by"));
}

TEST(Check, TakesWhatOwl1CalledASubclassOfObjectPropertiesForADeclaration) {
  const Program program;
  program.turtle("a.ttl",
                 ":p a owl:ObjectProperty . :t a owl:TransitiveProperty . :s a owl:SymmetricProperty .\n"
                 ":f a owl:InverseFunctionalProperty . :A a owl:Class ; rdfs:subClassOf [ a owl:Restriction ; "
                 "owl:onProperty :t ; owl:someValuesFrom :A ] .\n");
  const Outcome outcome = program.run({"check", "a.ttl"});
  EXPECT_EQ(outcome.status, 0) << outcome.out;
}

TEST(Infer, WritesWhatIsSettledWhereALimitIsReached) {
  const Program program;
  program.turtle("a.ttl",
                 pigeonhole(9) + ":A rdfs:subClassOf :B . :B rdfs:subClassOf [ owl:unionOf (:C :D) ] . :i a :A .\n");
  const Outcome outcome = program.run({"infer", "a.ttl", "-o", "out.nt", "--steps", "100000"});
  EXPECT_EQ(outcome.status, 4) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("the limit of 100000 steps was reached, and what is settled by then counts"));
  EXPECT_THAT(outcome.err, HasSubstr("held up by e:X"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("urn:geminga"))) << "individuals have their own names";
  EXPECT_THAT(program.read("out.nt"), HasSubstr("<http://e/A> <http://www.w3.org/2000/01/rdf-schema#subClassOf>"));
}

TEST(Query, AnswersWithWhatIsSettledWhereALimitIsReached) {
  const Program program;
  program.turtle("a.ttl",
                 pigeonhole(9) + ":A rdfs:subClassOf :B . :B rdfs:subClassOf :Z , [ owl:unionOf (:C :D) ] .\n");
  const Outcome outcome =
      program.run({"query", "a.ttl", "ASK { <http://e/A> rdfs:subClassOf <http://e/Z> }", "--steps", "100000"});
  EXPECT_EQ(outcome.status, 4) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("yes"));
  EXPECT_THAT(outcome.err, HasSubstr("held up by e:X"));
  EXPECT_EQ(program.run({"query", "a.ttl", "ASK { ?x ?y ?z }", "--asserted", "--steps", "1"}).status, 0)
      << "what is not searched needs no steps";
}

// As a tree the class has 2^40 members.
TEST(Check, EndsWhereClassesShareTheirPartsWithoutEnd) {
  const Program program;
  std::string text =
      ":X owl:equivalentClass _:b0 . :Y rdfs:subClassOf :X, [ owl:complementOf :X ] .\n"
      ":Z rdfs:subClassOf _:b0 . :A rdfs:subClassOf :C . :B rdfs:subClassOf :C .\n";
  for (int level = 0; level < 40; ++level) {
    const std::string below = "_:b" + std::to_string(level + 1);
    text += "_:b" + std::to_string(level) + " a owl:Class ; owl:intersectionOf (" + below + ' ' + below + ") .\n";
  }
  program.turtle("a.ttl", text + "_:b40 a owl:Class ; owl:unionOf ( :A :B ) .\n");
  const Outcome outcome = program.run({"check", "a.ttl"});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Classes that can have no instance:\n  e:Y\n"));
  EXPECT_LT(outcome.out.size(), 10'000U);
  const Outcome explained = program.run({"explain", "--proof", "--sub", ":Z", "--super", ":C", "a.ttl"});
  EXPECT_EQ(explained.status, 0) << explained.err;
  EXPECT_THAT(explained.out, HasSubstr("e:Z is subsumed by e:C"));
}

TEST(Check, AFileThatCannotBeReadIsStatusTwo) {
  const Program program;
  program.write("cut.ttl.gz", "\x1f\x8b\x08");
  program.write("wide.owl", "\xff\xfe<");
  program.write("unknown.txt", "nothing that is known");
  program.write("below/device.ttl", "");
  std::filesystem::remove(program.folder() / "in/below/device.ttl");
  std::filesystem::create_symlink("/dev/null", program.folder() / "in/device.ttl");
  for (const char* file :
       {"missing.ttl", "missing.geminga", "cut.ttl.gz", "wide.owl", "unknown.txt", "below", "device.ttl"}) {
    EXPECT_EQ(program.run({"check", file}).status, 2) << file;
    EXPECT_EQ(program.run({"check", file, "--json"}).status, 2) << file;
  }
}

TEST(Check, ABrokenFileIsStatusOneAndAMissingOneTwo) {
  const Program program;
  program.turtle("bad.ttl", ":A rdfs:subClassOf\n");
  EXPECT_EQ(program.run({"check", "bad.ttl"}).status, 1);
  EXPECT_THAT(program.run({"check", "bad.ttl"}).err, StartsWith("geminga-ontology: bad.ttl:3: "));
  EXPECT_EQ(program.run({"check", "missing.ttl"}).status, 2);
}

TEST(Check, JsonIsOneDocumentWithTheSameFindings) {
  const Program program;
  program.turtle("a.ttl", ":A rdfs:subClassOf :B , :C .\n:B owl:disjointWith :C .\n:B owl:newInOwl3 :C .\n");
  const Outcome outcome = program.run({"check", "--json", "a.ttl"});
  EXPECT_EQ(outcome.status, 1);
  const boost::json::object found = boost::json::parse(outcome.out).as_object();
  EXPECT_EQ(found.at("classes"), 3);
  EXPECT_EQ(found.at("problem"), true);
  EXPECT_EQ(found.at("complete"), false);
  EXPECT_TRUE(found.at("consistent").is_null()) << "what was left out may contradict the rest";
  EXPECT_EQ(found.at("files").at(0).at("path"), "a.ttl");
  EXPECT_EQ(found.at("left_out").at(0).at("construct"), "owl:newInOwl3");
  EXPECT_EQ(found.at("left_out").at(0).at("first"), "a.ttl:4");
  EXPECT_EQ(found.at("unsatisfiable").at(0).at("class"), "e:A");
  EXPECT_EQ(found.at("unsatisfiable").at(0).at("because").as_array().size(), 3U);
}

TEST(Check, FunctionalSyntaxIsReadBesideTurtle) {
  const Program program;
  program.write("a.owl", "Prefix(e:=<http://e/>)\nOntology(<http://e/a>\nSubClassOf(e:A e:B))\n");
  program.turtle("b.ttl", "<http://e/b> a owl:Ontology ; owl:imports <http://e/a> . :B rdfs:subClassOf :C .\n");
  const Outcome outcome = program.run({"check", "a.owl", "b.ttl"});
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, Not(HasSubstr("Imports")));
  EXPECT_EQ(program.run({"subsumes", "a.owl", "b.ttl", "--sub", "e:A", "--super", "e:C"}).status, 0);
}

}  // namespace
}  // namespace geminga::ontology
