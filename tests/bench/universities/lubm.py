"""The Lehigh University Benchmark (Guo, Pan and Heflin, "LUBM: A Benchmark for OWL Knowledge Base Systems", 2005): its terms and its
profile of a university's facts, written from the article. The random numbers are others than those of its own generator.
"""

from __future__ import annotations

import random

from pen import Pen

IRI = "http://geminga.example/bench/lubm"

_HIERARCHY = """
Organization: University College Department Institute Program ResearchGroup
Employee: AdministrativeStaff Faculty
AdministrativeStaff: ClericalStaff SystemsStaff
Faculty: Lecturer PostDoc Professor
Professor: AssistantProfessor AssociateProfessor Chair Dean FullProfessor VisitingProfessor
Person: Employee Student GraduateStudent Director ResearchAssistant TeachingAssistant
Student: UndergraduateStudent
Work: Course Research
Course: GraduateCourse
Publication: Article Book Manual Software Specification UnofficialPublication
Article: ConferencePaper JournalArticle TechnicalReport
"""

_PROPERTIES = """
advisor Person Professor
affiliatedOrganizationOf Organization Organization
affiliateOf Organization Person
degreeFrom Person University
hasAlumnus University Person
headOf - -
member Organization Person
memberOf - -
orgPublication Organization Publication
publicationAuthor Publication Person
publicationResearch Publication Research
researchProject ResearchGroup Research
softwareDocumentation Software Publication
subOrganizationOf Organization Organization
takesCourse - -
teacherOf Faculty Course
teachingAssistantOf TeachingAssistant Course
worksFor - -
"""

_AXIOMS = """
EquivalentClasses(:Chair ObjectIntersectionOf(:Person ObjectSomeValuesFrom(:headOf :Department)))
EquivalentClasses(:Director ObjectIntersectionOf(:Person ObjectSomeValuesFrom(:headOf :Program)))
EquivalentClasses(:Employee ObjectIntersectionOf(:Person ObjectSomeValuesFrom(:worksFor :Organization)))
EquivalentClasses(:Student ObjectIntersectionOf(:Person ObjectSomeValuesFrom(:takesCourse :Course)))
EquivalentClasses(:TeachingAssistant ObjectIntersectionOf(:Person ObjectSomeValuesFrom(:teachingAssistantOf :Course)))
SubClassOf(:Dean ObjectSomeValuesFrom(:headOf :College))
SubClassOf(:GraduateStudent ObjectSomeValuesFrom(:takesCourse :GraduateCourse))
SubClassOf(:ResearchAssistant ObjectSomeValuesFrom(:worksFor :ResearchGroup))
SubObjectPropertyOf(:doctoralDegreeFrom :degreeFrom)
SubObjectPropertyOf(:mastersDegreeFrom :degreeFrom)
SubObjectPropertyOf(:undergraduateDegreeFrom :degreeFrom)
SubObjectPropertyOf(:headOf :worksFor)
SubObjectPropertyOf(:worksFor :memberOf)
InverseObjectProperties(:degreeFrom :hasAlumnus)
InverseObjectProperties(:member :memberOf)
TransitiveObjectProperty(:subOrganizationOf)
"""


def axioms() -> str:
    """The terms, a line for each axiom."""
    lines = []
    for line in _HIERARCHY.strip().splitlines():
        above, below = line.split(": ")
        lines += [f"SubClassOf(:{one} :{above})" for one in below.split()]
    for line in _PROPERTIES.strip().splitlines():
        name, domain, range_ = line.split()
        lines.append(f"Declaration(ObjectProperty(:{name}))")
        if domain != "-":
            lines += [f"ObjectPropertyDomain(:{name} :{domain})", f"ObjectPropertyRange(:{name} :{range_})"]
    lines += [f"Declaration(DataProperty(:{name}))" for name in ("emailAddress", "name", "researchInterest", "telephone")]
    return "\n".join([*lines, _AXIOMS.strip()])


class _Department:
    """Makes the people, courses, groups and publications of one department. Ranges are those of the article's profile."""

    def __init__(self, pen: Pen, chance: random.Random, name: str, university: str, universities: int) -> None:
        self._pen, self._chance, self._university, self._universities = pen, chance, university, universities
        self._department = pen.individual(f"{name}_{university}", "Department")
        self._faculty: list[str] = []
        self._professors: list[str] = []
        self._courses: list[str] = []
        self._graduate_courses: list[str] = []
        self._publications: list[str] = []

    def make(self) -> None:
        between = self._chance.randint
        self._pen.link(self._department, "subOrganizationOf", self._university)
        for kind, least, most, papers in (
            ("FullProfessor", 7, 10, (15, 20)),
            ("AssociateProfessor", 10, 14, (10, 18)),
            ("AssistantProfessor", 8, 11, (5, 10)),
            ("Lecturer", 5, 7, (0, 5)),
        ):
            for number in range(between(least, most)):
                self._make_teacher(kind, number, papers)
        self._pen.link(self._professors[0], "headOf", self._department)
        groups = [self._own(f"ResearchGroup{number}", "ResearchGroup") for number in range(between(10, 20))]
        for group in groups:
            self._pen.link(group, "subOrganizationOf", self._department)
        self._make_undergraduates(sum(between(8, 14) for _ in self._faculty))
        self._make_graduates(sum(between(3, 4) for _ in self._faculty))

    def _own(self, name: str, *classes: str) -> str:
        return self._pen.individual(f"{name}_{self._department}", *classes)

    def _some_university(self) -> str:
        return f"University{self._chance.randrange(self._universities)}"

    def _make_teacher(self, kind: str, number: int, papers: tuple[int, int]) -> None:
        teacher = self._own(f"{kind}{number}", kind)
        self._faculty.append(teacher)
        if kind != "Lecturer":
            self._professors.append(teacher)
        self._describe(teacher, f"{kind}{number}")
        self._pen.value(teacher, "researchInterest", f"Research{self._chance.randrange(30)}")
        self._pen.link(teacher, "worksFor", self._department)
        for degree in ("undergraduateDegreeFrom", "mastersDegreeFrom", "doctoralDegreeFrom"):
            self._pen.link(teacher, degree, self._some_university())
        for courses, course in ((self._courses, "Course"), (self._graduate_courses, "GraduateCourse")):
            for _ in range(self._chance.randint(1, 2)):
                courses.append(self._own(f"{course}{len(courses)}", course))
                self._pen.value(courses[-1], "name", f"{course}{len(courses)}")
                self._pen.link(teacher, "teacherOf", courses[-1])
        for paper in range(self._chance.randint(*papers)):
            self._publications.append(self._pen.individual(f"Publication{paper}_{teacher}", "Publication"))
            self._pen.value(self._publications[-1], "name", f"Publication{paper}")
            self._pen.link(self._publications[-1], "publicationAuthor", teacher)

    def _describe(self, person: str, name: str) -> None:
        self._pen.value(person, "name", name)
        self._pen.value(person, "emailAddress", f"{person}@example.edu")
        self._pen.value(person, "telephone", "xxx-xxx-xxxx")

    def _make_undergraduates(self, count: int) -> None:
        for number in range(count):
            student = self._own(f"UndergraduateStudent{number}", "UndergraduateStudent")
            self._describe(student, f"UndergraduateStudent{number}")
            self._pen.link(student, "memberOf", self._department)
            self._pen.link(student, "takesCourse", *self._chance.sample(self._courses, self._chance.randint(2, 4)))
            if self._chance.random() < 0.2:
                self._pen.link(student, "advisor", self._chance.choice(self._professors))

    def _make_graduates(self, count: int) -> None:
        assistants = self._chance.sample(range(count), count // self._chance.randint(4, 5))
        assisted = self._chance.sample(self._courses, min(len(assistants), len(self._courses)))
        for number in range(count):
            student = self._own(f"GraduateStudent{number}", "GraduateStudent")
            self._describe(student, f"GraduateStudent{number}")
            self._pen.link(student, "memberOf", self._department)
            self._pen.link(student, "undergraduateDegreeFrom", self._some_university())
            self._pen.link(student, "takesCourse", *self._chance.sample(self._graduate_courses, self._chance.randint(1, 3)))
            self._pen.link(student, "advisor", self._chance.choice(self._professors))
            for paper in self._chance.sample(self._publications, self._chance.randint(0, 5)):
                self._pen.link(paper, "publicationAuthor", student)
            if number in assistants and assisted:
                self._pen.link(student, "teachingAssistantOf", assisted.pop())
            elif self._chance.random() < 0.3:
                self._pen.individual(student, "ResearchAssistant")


def write(pen: Pen, universities: int, seed: int, departments: int | None = None) -> None:
    """LUBM(N) has N universities of 15 to 25 departments each, and of `departments` where that is said."""
    chance = random.Random(f"lubm {seed}")
    pen.begin(IRI, axioms())
    for university in range(universities):
        name = pen.individual(f"University{university}", "University")
        pen.value(name, "name", name)
        for department in range(departments or chance.randint(15, 25)):
            _Department(pen, chance, f"Department{department}", name, universities).make()
    pen.end()
