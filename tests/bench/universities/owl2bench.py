"""A university in the manner of OWL2Bench (Singh, Bhatia and Mutharaju, "OWL2Bench: A Benchmark for OWL 2 Reasoners", 2020), its profile
of OWL 2 DL: terms that use every construct of OWL 2 about individuals, written from the article's description, and facts for them.
"""

from __future__ import annotations

import random

from pen import Pen

IRI = "http://geminga.example/bench/owl2bench"

_HIERARCHY = """
Organization: University College Department ResearchGroup
College: WomanCollege CoEdCollege
Person: Man Woman Employee Student
Employee: Faculty AdministrativeStaff
Faculty: Professor Lecturer PostDoc
Professor: FullProfessor AssociateProfessor AssistantProfessor VisitingProfessor
Student: UGStudent PGStudent
PGStudent: PhDStudent
Course: ElectiveCourse CoreCourse
Program: UGProgram PGProgram PhDProgram
Interest: Sports Music Travelling
"""

_OBJECT_PROPERTIES = """
dislikes enrollFor enrollIn hasAdvisor hasAlumnus hasCollaborationWith hasCollege hasDean hasDegreeFrom hasDepartment hasDoctoralDegreeFrom
hasEmployee hasFriend hasHead hasMember hasPart hasPublication hasSameHomeTownWith hasStudent hasTeachingAssistant isAdvisedBy isAffiliatedOrganizationOf
isCrazyAbout isHeadOf isMemberOf isPartOf isStudentOf isTaughtBy knows likes loves offersCourse takesCourse teachesCourse worksFor
"""

_DATA_PROPERTIES = "hasAge hasEmail hasId hasName hasYear"

_AXIOMS = """
DisjointClasses(:Person :Organization :Course :Program :Interest)
DisjointUnion(:Human :Man :Woman)
SubClassOf(:Person :Human)
DisjointClasses(:UGStudent :PGStudent)
DisjointClasses(:WomanCollege :CoEdCollege)
EquivalentClasses(:WomanCollege ObjectIntersectionOf(:College ObjectAllValuesFrom(:hasStudent :Woman)))
EquivalentClasses(:Employee ObjectIntersectionOf(:Person ObjectSomeValuesFrom(:worksFor :Organization)))
EquivalentClasses(:Dean ObjectIntersectionOf(:Faculty ObjectSomeValuesFrom(ObjectInverseOf(:hasDean) :College)))
EquivalentClasses(:Chair ObjectIntersectionOf(:Faculty ObjectSomeValuesFrom(:isHeadOf :Department)))
EquivalentClasses(:TeachingAssistant ObjectIntersectionOf(:Student ObjectSomeValuesFrom(ObjectInverseOf(:hasTeachingAssistant) :Course)))
EquivalentClasses(:SelfAwarePerson ObjectIntersectionOf(:Person ObjectHasSelf(:knows)))
EquivalentClasses(:CricketFan ObjectIntersectionOf(:Person ObjectHasValue(:isCrazyAbout :Cricket)))
EquivalentClasses(:SportsLover ObjectIntersectionOf(:Person ObjectSomeValuesFrom(:likes :Sports)))
EquivalentClasses(:PersonWithManyInterests ObjectIntersectionOf(:Person ObjectMinCardinality(3 :likes)))
EquivalentClasses(:LeisureStudent ObjectIntersectionOf(:Student ObjectMaxCardinality(1 :takesCourse)))
EquivalentClasses(:BusyTeacher ObjectIntersectionOf(:Faculty ObjectMinCardinality(3 :teachesCourse :Course)))
EquivalentClasses(:ScienceStudent ObjectIntersectionOf(:Student ObjectSomeValuesFrom(:enrollIn ObjectOneOf(:Science :Engineering))))
EquivalentClasses(:NonScienceStudent ObjectIntersectionOf(:Student ObjectComplementOf(:ScienceStudent)))
EquivalentClasses(:SeniorStudent ObjectIntersectionOf(:Student DataSomeValuesFrom(:hasAge DatatypeRestriction(xsd:integer xsd:minInclusive "25"^^xsd:integer))))
EquivalentClasses(:YoungAcademic ObjectUnionOf(:PostDoc :PhDStudent))
SubClassOf(:Person DataExactCardinality(1 :hasId))
SubClassOf(:Student ObjectSomeValuesFrom(:enrollFor :Program))
SubClassOf(:PhDStudent ObjectSomeValuesFrom(:isAdvisedBy :Professor))
SubClassOf(:Department ObjectMaxCardinality(1 ObjectInverseOf(:isHeadOf)))
SubClassOf(:College ObjectExactCardinality(1 :hasDean :Faculty))
SubClassOf(:Course ObjectMinCardinality(1 :isTaughtBy))
SubClassOf(:UGStudent ObjectAllValuesFrom(:enrollFor :UGProgram))
ClassAssertion(:Sports :Cricket)
ClassAssertion(:Sports :Tennis)
ClassAssertion(:Sports :Hockey)
ClassAssertion(:Music :Jazz)
ClassAssertion(:Travelling :Trekking)
DifferentIndividuals(:Cricket :Tennis :Hockey :Jazz :Trekking)
DifferentIndividuals(:Science :Engineering :Humanities)
ObjectPropertyDomain(:teachesCourse :Faculty)
ObjectPropertyRange(:teachesCourse :Course)
ObjectPropertyDomain(:takesCourse :Student)
ObjectPropertyRange(:hasDegreeFrom :University)
ObjectPropertyDomain(:likes :Person)
ObjectPropertyRange(:likes :Interest)
DataPropertyRange(:hasAge xsd:integer)
FunctionalDataProperty(:hasId)
FunctionalDataProperty(:hasAge)
HasKey(:Person () (:hasId))
InverseObjectProperties(:hasAlumnus :hasDegreeFrom)
InverseObjectProperties(:isPartOf :hasPart)
InverseObjectProperties(:isMemberOf :hasMember)
InverseObjectProperties(:isHeadOf :hasHead)
InverseObjectProperties(:teachesCourse :isTaughtBy)
InverseObjectProperties(:isStudentOf :hasStudent)
EquivalentObjectProperties(:hasAdvisor :isAdvisedBy)
SubObjectPropertyOf(:isHeadOf :worksFor)
SubObjectPropertyOf(:worksFor :isMemberOf)
SubObjectPropertyOf(:hasDoctoralDegreeFrom :hasDegreeFrom)
SubObjectPropertyOf(:isCrazyAbout :likes)
SubObjectPropertyOf(:loves :knows)
SubObjectPropertyOf(:hasCollege :hasPart)
SubObjectPropertyOf(:hasDepartment :hasPart)
SubObjectPropertyOf(ObjectPropertyChain(:worksFor :isPartOf) :isMemberOf)
SubObjectPropertyOf(ObjectPropertyChain(:isStudentOf :isPartOf) :isStudentOf)
SubObjectPropertyOf(ObjectPropertyChain(:enrollIn :offersCourse) :canTake)
TransitiveObjectProperty(:isPartOf)
TransitiveObjectProperty(:hasSameHomeTownWith)
SymmetricObjectProperty(:hasSameHomeTownWith)
SymmetricObjectProperty(:hasCollaborationWith)
AsymmetricObjectProperty(:isAffiliatedOrganizationOf)
IrreflexiveObjectProperty(:isAdvisedBy)
InverseFunctionalObjectProperty(:hasDean)
DisjointObjectProperties(:likes :dislikes)
"""


def axioms() -> str:
    """The terms, a line for each axiom."""
    lines = [f"Declaration(ObjectProperty(:{name}))" for name in [*_OBJECT_PROPERTIES.split(), "canTake"]]
    lines += [f"Declaration(DataProperty(:{name}))" for name in _DATA_PROPERTIES.split()]
    for line in _HIERARCHY.strip().splitlines():
        above, below = line.split(": ")
        lines += [f"SubClassOf(:{one} :{above})" for one in below.split()]
    return "\n".join([*lines, _AXIOMS.strip()])


_INTERESTS = ("Cricket", "Tennis", "Hockey", "Jazz", "Trekking")
_DISCIPLINES = ("Science", "Engineering", "Humanities")


class _College:
    """Makes the departments of one college, and their people and courses."""

    def __init__(self, pen: Pen, chance: random.Random, name: str, university: str, women_only: bool) -> None:
        self._pen, self._chance, self._university, self._women_only = pen, chance, university, women_only
        self._college = pen.individual(name, "WomanCollege" if women_only else "CoEdCollege")
        self._discipline = chance.choice(_DISCIPLINES)
        self._people: list[str] = []

    def make(self, departments: int, faculty: int, students: int) -> None:
        self._pen.link(self._university, "hasCollege", self._college)
        for number in range(departments):
            self._make_department(f"{self._college}_Department{number}", faculty, students)

    def _make_department(self, name: str, faculty: int, students: int) -> None:
        pen, chance = self._pen, self._chance
        pen.individual(name, "Department")
        pen.link(name, "isPartOf", self._college)
        teachers: list[str] = []
        courses: list[str] = []
        for number in range(faculty):
            kind = chance.choice(("FullProfessor", "AssociateProfessor", "AssistantProfessor", "Lecturer", "PostDoc"))
            teacher = self._make_person(f"{name}_{kind}{number}", kind, chance.choice(("Man", "Woman")))
            pen.link(teacher, "worksFor", name)
            pen.link(teacher, "hasDoctoralDegreeFrom", self._university)
            for _ in range(chance.randint(1, 3)):
                courses.append(pen.individual(f"{name}_Course{len(courses)}", chance.choice(("CoreCourse", "ElectiveCourse"))))
                pen.link(teacher, "teachesCourse", courses[-1])
                pen.link(name, "offersCourse", courses[-1])
            teachers.append(teacher)
        pen.link(teachers[0], "isHeadOf", name)
        if name.endswith("Department0"):
            pen.link(self._college, "hasDean", teachers[-1])
        pen.different(courses)
        for number in range(students):
            self._make_student(name, number, teachers, courses)

    def _make_person(self, name: str, *classes: str) -> str:
        pen, chance = self._pen, self._chance
        pen.individual(name, *classes)
        pen.value(name, "hasId", name)
        pen.value(name, "hasAge", str(chance.randint(18, 70)), "integer")
        for interest in chance.sample(_INTERESTS, chance.randint(0, 4)):
            pen.link(name, chance.choice(("likes", "likes", "isCrazyAbout")), interest)
        if self._people:
            pen.link(name, chance.choice(("knows", "hasSameHomeTownWith", "hasCollaborationWith")), chance.choice(self._people[-20:]))
        if chance.random() < 0.02:
            pen.link(name, "loves", name)
        self._people.append(name)
        return name

    def _make_student(self, department: str, number: int, teachers: list[str], courses: list[str]) -> None:
        pen, chance = self._pen, self._chance
        kind = chance.choice(("UGStudent", "UGStudent", "UGStudent", "PGStudent", "PhDStudent"))
        student = self._make_person(f"{department}_{kind}{number}", kind, "Woman" if self._women_only else chance.choice(("Man", "Woman")))
        pen.link(student, "isStudentOf", department)
        pen.link(student, "enrollIn", self._discipline)
        pen.link(student, "takesCourse", *chance.sample(courses, min(len(courses), chance.randint(1, 4))))
        if kind != "UGStudent":
            pen.link(student, "isAdvisedBy", chance.choice(teachers))
        if chance.random() < 0.1:
            pen.link(chance.choice(courses), "hasTeachingAssistant", student)
        if chance.random() < 0.05:
            pen.no_link(student, "knows", chance.choice(teachers))


def write(pen: Pen, universities: int, seed: int, colleges: int = 5, departments: int = 4, faculty: int = 15, students: int = 60) -> None:
    """Every third college is one of women."""
    chance = random.Random(f"owl2bench {seed}")
    pen.begin(IRI, axioms())
    for number in range(universities):
        university = pen.individual(f"University{number}", "University")
        for college in range(colleges):
            _College(pen, chance, f"{university}_College{college}", university, college % 3 == 2).make(departments, faculty, students)
    pen.end()
