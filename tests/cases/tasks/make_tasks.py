#!/usr/bin/env python3
"""Writes robots.txt and tasks.txt: 50 robots, 200 tasks and the expected answers (README.md says how they were made).

What a robot can is computed here from its parts by the rules of team.ofn, written down by hand and independently of the
reasoner; who does a task best is found by trying every choice.
"""
import itertools
import random

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
DEFINED = {
    "Lifter": lambda r: has(r, "Manipulator"),
    "Rescuer": lambda r: sees(r, "Person") and has(r, "Gripper"),
    "Mapper": lambda r: has(r, "Lidar") and has(r, "Radio"),
}
CHASSIS = {"Rover": {"Rover", "Ground", "Robot"}, "Walker": {"Walker", "Ground", "Robot"},
           "Drone": {"Drone", "Robot"}, "Boat": {"Boat", "Robot"}}

KINDS = [("Rover", ["Gripper", "ColourCamera"]), ("Rover", ["Lidar", "Mast", "Radio"]), ("Rover", ["HeavyGripper"]),
         ("Drone", ["ColourCamera"]), ("Drone", ["ThermalCamera", "Radio"]), ("Drone", ["Lidar"]),
         ("Walker", ["Gripper", "ThermalCamera"]), ("Walker", ["SuctionCup", "ColourCamera", "Radio"]),
         ("Boat", ["Sonar"]), ("Boat", ["Sonar", "Radio", "ThermalCamera"])]
ROBOTS = [{"name": f"{kind[0].lower()}{number + 1}", "chassis": kind[0], "parts": kind[1],
           "battery": 10 + (37 * number) % 90} for number in range(50) for kind in [KINDS[number % len(KINDS)]]]


def has(robot, part):
    return any(part in ABOVE[own] for own in robot["parts"])


def sees(robot, thing):
    seen = set().union(*(SEES.get(above, set()) for own in robot["parts"] for above in ABOVE[own]))
    return thing in seen


# Conditions on a robot: the text in Manchester syntax, and the meaning by hand.
def is_a(name):
    if name in DEFINED:
        return name, DEFINED[name]
    return name, lambda robot: name in CHASSIS[robot["chassis"]]


def part(name):
    return f"hasPart some {name}", lambda robot: has(robot, name)


def sight(name):
    return f"canSee some {name}", lambda robot: sees(robot, name)


def both(one, other):
    return f"({one[0]}) and ({other[0]})", lambda robot: one[1](robot) and other[1](robot)


def either(one, other):
    return f"({one[0]}) or ({other[0]})", lambda robot: one[1](robot) or other[1](robot)


SIMPLE = [is_a("Rover"), is_a("Drone"), is_a("Boat"), is_a("Ground"), is_a("Lifter"), is_a("Rescuer"), is_a("Mapper"),
          part("Manipulator"), part("Gripper"), part("Camera"), part("Radio"), part("Mast"), sight("Ball"),
          sight("Person"), sight("Wall"), sight("Thing2D")]


def suits(role, robot):
    return role["what"][1](robot) and robot["battery"] >= role["battery"]


def solve(robots, roles, prefers):
    """The fewest robots, then the least sum of ranks over all holdings; None where nobody can."""
    ranked = sorted(range(len(robots)), key=lambda at: (-robots[at]["battery"], at))
    rank = {robot: place for place, robot in enumerate(ranked)}
    suited = [[at for at, robot in enumerate(robots) if suits(role, robot)] for role in roles]
    choices = [list(itertools.combinations(suited[at], role["count"])) for at, role in enumerate(roles)]
    best = None
    for chosen in itertools.product(*choices):
        alone = [robot for at, holders in enumerate(chosen) if not roles[at]["shared"] for robot in holders]
        if len(alone) != len(set(alone)):
            continue
        cost = sum(rank[robot] for holders in chosen for robot in holders) if prefers else 0
        found = (len(set().union(*chosen)), cost)
        if best is None or found < best:
            best = found
    return best


def role(what, count=1, shared=False, battery=0):
    return {"what": what, "count": count, "shared": shared, "battery": battery}


def family(name, number, dice):
    """The roles of one task. Families keep the number of choices small enough to try all."""
    pick = lambda: dice.choice(SIMPLE)
    if name == "one role":
        return [role(pick(), dice.randint(1, 3))]
    if name == "each his own":
        return [role(pick()), role(pick()), role(pick())]
    if name == "shared beside another":
        return [role(pick()), role(pick(), shared=True), role(pick(), shared=True)]
    if name == "all shared":
        return [role(pick(), dice.randint(1, 2), shared=True) for _ in range(3)]
    if name == "conditions":
        return [role(pick(), battery=dice.choice([30, 60, 90])), role(pick(), 2, battery=dice.choice([20, 50]))]
    if name == "conjunctions":
        return [role(both(pick(), pick())), role(both(pick(), pick()), shared=True), role(pick())]
    if name == "unions":
        return [role(either(pick(), pick()), 2), role(pick(), shared=True)]
    return [role(both(sight("Person"), part("Mast"))), role(pick())] if number % 2 else \
        [role(part("Mast"), 6), role(pick())]


FAMILIES = ["one role", "each his own", "shared beside another", "all shared", "conditions", "conjunctions", "unions",
            "nobody can"]


def main():
    with open("robots.txt", "w", encoding="utf-8") as out:
        print("# name, battery in %, what it is; written by make_tasks.py", file=out)
        for robot in ROBOTS:
            parts = " and ".join(f"(hasPart some {one})" for one in robot["parts"])
            print(f"{robot['name']}\t{robot['battery']}\t{robot['chassis']} and {parts}", file=out)
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
            print("robots", *(ROBOTS[at]["name"] for at in there), file=out)
            for one in roles:
                print(f"need {one['count']} {'shared' if one['shared'] else 'alone'} {one['battery']} {one['what'][0]}",
                      file=out)
            if prefers:
                print("prefer battery desc", file=out)
            print("expect nobody" if answer is None else f"expect {answer[0]} {answer[1]}", file=out)


if __name__ == "__main__":
    main()
