#!/usr/bin/env python3
"""Writes robots.txt and tasks.txt: 50 robots, 200 tasks and the expected answers (README.md says how they were made).

What a robot can is computed here from its parts by the rules of team.ofn, written down by hand and independently of the
reasoner; who does a task best is found by trying every choice.
"""

from __future__ import annotations

import itertools
import random
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple


@dataclass(frozen=True)
class Robot:
    name: str
    chassis: str
    parts: tuple[str, ...]
    battery: int


class Condition(NamedTuple):
    """A condition on a robot: its text in Manchester syntax, and its meaning by hand."""

    text: str
    holds: Callable[[Robot], bool]


@dataclass(frozen=True)
class Role:
    what: Condition
    count: int = 1
    shared: bool = False
    battery: int = 0


# team.ofn by hand: the classes above a part, and what a part lets a robot see.
ABOVE = {
    "HeavyGripper": {"HeavyGripper", "Gripper", "Manipulator", "Part"},
    "Gripper": {"Gripper", "Manipulator", "Part"},
    "SuctionCup": {"SuctionCup", "Manipulator", "Part"},
    "ColourCamera": {"ColourCamera", "Camera", "Sensor", "Part"},
    "ThermalCamera": {"ThermalCamera", "Camera", "Sensor", "Part"},
    "Lidar": {"Lidar", "Sensor", "Part"},
    "Sonar": {"Sonar", "Sensor", "Part"},
    "Mast": {"Mast", "Part"},
    "Radio": {"Radio", "Part"},
}
SEES = {"ColourCamera": {"Ball", "Thing2D"}, "ThermalCamera": {"Person", "Thing2D"}, "Camera": {"Thing2D"},
        "Lidar": {"Wall"}, "Sonar": {"Wall"}}
DEFINED: dict[str, Callable[[Robot], bool]] = {
    "Lifter": lambda r: has(r, "Manipulator"),
    "Rescuer": lambda r: sees(r, "Person") and has(r, "Gripper"),
    "Mapper": lambda r: has(r, "Lidar") and has(r, "Radio"),
}
CHASSIS = {"Rover": {"Rover", "Ground", "Robot"}, "Walker": {"Walker", "Ground", "Robot"},
           "Drone": {"Drone", "Robot"}, "Boat": {"Boat", "Robot"}}

KINDS = [("Rover", ("Gripper", "ColourCamera")), ("Rover", ("Lidar", "Mast", "Radio")), ("Rover", ("HeavyGripper",)),
         ("Drone", ("ColourCamera",)), ("Drone", ("ThermalCamera", "Radio")), ("Drone", ("Lidar",)),
         ("Walker", ("Gripper", "ThermalCamera")), ("Walker", ("SuctionCup", "ColourCamera", "Radio")),
         ("Boat", ("Sonar",)), ("Boat", ("Sonar", "Radio", "ThermalCamera"))]
ROBOTS = [Robot(f"{chassis.lower()}{number + 1}", chassis, parts, 10 + (37 * number) % 90)
          for number in range(50) for chassis, parts in [KINDS[number % len(KINDS)]]]


def has(robot: Robot, part: str) -> bool:
    return any(part in ABOVE[own] for own in robot.parts)


def sees(robot: Robot, thing: str) -> bool:
    nothing: set[str] = set()
    return thing in nothing.union(*(SEES.get(above, nothing) for own in robot.parts for above in ABOVE[own]))


def is_a(name: str) -> Condition:
    if name in DEFINED:
        return Condition(name, DEFINED[name])
    return Condition(name, lambda robot: name in CHASSIS[robot.chassis])


def part(name: str) -> Condition:
    return Condition(f"hasPart some {name}", lambda robot: has(robot, name))


def sight(name: str) -> Condition:
    return Condition(f"canSee some {name}", lambda robot: sees(robot, name))


def both(one: Condition, other: Condition) -> Condition:
    return Condition(f"({one.text}) and ({other.text})", lambda robot: one.holds(robot) and other.holds(robot))


def either(one: Condition, other: Condition) -> Condition:
    return Condition(f"({one.text}) or ({other.text})", lambda robot: one.holds(robot) or other.holds(robot))


SIMPLE = [is_a("Rover"), is_a("Drone"), is_a("Boat"), is_a("Ground"), is_a("Lifter"), is_a("Rescuer"), is_a("Mapper"),
          part("Manipulator"), part("Gripper"), part("Camera"), part("Radio"), part("Mast"), sight("Ball"),
          sight("Person"), sight("Wall"), sight("Thing2D")]


def suits(role: Role, robot: Robot) -> bool:
    return role.what.holds(robot) and robot.battery >= role.battery


def solve(robots: list[Robot], roles: list[Role], prefers: bool) -> tuple[int, int] | None:
    """The fewest robots, then the least sum of ranks over all holdings; None where nobody can."""
    ranked = sorted(range(len(robots)), key=lambda at: (-robots[at].battery, at))
    rank = {robot: place for place, robot in enumerate(ranked)}
    suited = [[at for at, robot in enumerate(robots) if suits(role, robot)] for role in roles]
    choices = [list(itertools.combinations(suited[at], role.count)) for at, role in enumerate(roles)]
    best: tuple[int, int] | None = None
    for chosen in itertools.product(*choices):
        alone = [robot for at, holders in enumerate(chosen) if not roles[at].shared for robot in holders]
        if len(alone) != len(set(alone)):
            continue
        cost = sum(rank[robot] for holders in chosen for robot in holders) if prefers else 0
        found = (len({robot for holders in chosen for robot in holders}), cost)
        if best is None or found < best:
            best = found
    return best


def family(name: str, number: int, dice: random.Random) -> list[Role]:
    """The roles of one task. Families keep the number of choices small enough to try all."""

    def pick() -> Condition:
        return dice.choice(SIMPLE)

    if name == "one role":
        return [Role(pick(), dice.randint(1, 3))]
    if name == "each his own":
        return [Role(pick()), Role(pick()), Role(pick())]
    if name == "shared beside another":
        return [Role(pick()), Role(pick(), shared=True), Role(pick(), shared=True)]
    if name == "all shared":
        return [Role(pick(), dice.randint(1, 2), shared=True) for _ in range(3)]
    if name == "conditions":
        return [Role(pick(), battery=dice.choice([30, 60, 90])), Role(pick(), 2, battery=dice.choice([20, 50]))]
    if name == "conjunctions":
        return [Role(both(pick(), pick())), Role(both(pick(), pick()), shared=True), Role(pick())]
    if name == "unions":
        return [Role(either(pick(), pick()), 2), Role(pick(), shared=True)]
    return [Role(both(sight("Person"), part("Mast"))), Role(pick())] if number % 2 else \
        [Role(part("Mast"), 6), Role(pick())]


FAMILIES = ["one role", "each his own", "shared beside another", "all shared", "conditions", "conjunctions", "unions",
            "nobody can"]


def main() -> None:
    with open("robots.txt", "w", encoding="utf-8") as out:
        print("# name, battery in %, what it is; written by make_tasks.py", file=out)
        for robot in ROBOTS:
            parts = " and ".join(f"(hasPart some {one})" for one in robot.parts)
            print(f"{robot.name}\t{robot.battery}\t{robot.chassis} and {parts}", file=out)
    with open("tasks.txt", "w", encoding="utf-8") as out:
        print("# 200 tasks over robots.txt, and the answers; written by make_tasks.py", file=out)
        for number in range(200):
            dice = random.Random(number)
            name = FAMILIES[number % len(FAMILIES)]
            roles = family(name, number // len(FAMILIES), dice)
            # Some of the robots, so that many tasks are tight: beginning anywhere, in steps of an odd number.
            count = 12 if name != "one role" else 50
            first, step = dice.randrange(50), dice.choice([1, 3, 7, 9])
            there = sorted({(first + step * at) % 50 for at in range(count)})
            prefers = number % 3 == 0
            answer = solve([ROBOTS[at] for at in there], roles, prefers)
            print(f"\ntask {number + 1}: {name}", file=out)
            print("robots", *(ROBOTS[at].name for at in there), file=out)
            for one in roles:
                print(f"need {one.count} {'shared' if one.shared else 'alone'} {one.battery} {one.what.text}", file=out)
            if prefers:
                print("prefer battery desc", file=out)
            print("expect nobody" if answer is None else f"expect {answer[0]} {answer[1]}", file=out)


if __name__ == "__main__":
    main()
