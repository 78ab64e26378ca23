#!/usr/bin/python3
"""Runs the agents of all pairs of languages against real daemons (AGENT.md): needs nothing but the standard library.

    drive.py --gemingad build/release/bin/gemingad --agent python=tests/client/python/agent.py --agent "java=java -cp ..."
"""

from __future__ import annotations

import argparse
import os
import shlex
import sys
import threading
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from checks import behaviours, chaos, loss, modes, sealed, vectors  # noqa: E402
from lab import Lab  # noqa: E402
from lanes import Job, Lanes  # noqa: E402
from pair import Command, Pair, fresh  # noqa: E402
from spoken import Failed  # noqa: E402

Check = Callable[..., None]
LOSS_PERCENT = 10
ROOT = Path(__file__).resolve().parents[3]


class Table:
    """The results of all checks. Each row is printed as soon as it is known."""

    def __init__(self) -> None:
        self.failed: list[str] = []
        self.count = 0
        self._lock = threading.Lock()

    def say(self, row: str) -> None:
        """Prints a row, whole."""
        with self._lock:
            print(row, flush=True)

    def run(self, who: str, check: Check, action: Callable[[], None]) -> bool:
        """Runs a check. Whether it holds."""
        what = (check.__doc__ or check.__name__).splitlines()[0]
        begin = time.monotonic()
        with self._lock:
            self.count += 1
        try:
            action()
        except Failed as error:
            self.failed.append(f"{who}: {what}")
            notes = "".join(getattr(error, "__notes__", []))
            self.say(f"{who:<21} {what:<49} FAILED\n    {error}{notes}")
            return False
        self.say(f"{who:<21} {what:<49} ok {time.monotonic() - begin:6.1f} s")
        return True


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description="Runs agents of client libraries against real daemons.")
    parser.add_argument("--gemingad", required=True, help="the daemon")
    parser.add_argument("--agent", action="append", default=[], metavar="LANGUAGE=COMMAND", help="may be given many times")
    parser.add_argument("--ontology", default=str(ROOT / "ontology"), help="what the daemons load")
    parser.add_argument("--only", default="", help="only checks whose name or title has this in it")
    parser.add_argument("--pair", default="", help="only this pair: PUBLISHER>SUBSCRIBER")
    parser.add_argument("--loopback", action="store_true", help="daemons on the loopback interface, as where no namespace may be made")
    parser.add_argument("--at-once", type=int, default=4, metavar="COUNT", help="labs side by side (4)")
    parser.add_argument("--chaos", type=int, default=0, metavar="ROUNDS", help="instead of all checks: so many rounds in which daemons are killed, by all languages in turn")
    parser.add_argument("--seed", type=int, default=1, help="of the first round of chaos (1)")
    parser.add_argument("--sealing", default="encrypted", metavar="MODE", help="of the sealed labs, and of chaos (encrypted); plain: chaos without keys")
    parser.add_argument("--face", action="append", default=[], metavar="LANGUAGE", help="a language whose library is a face of another one's: fewer pairs")
    parser.add_argument("--behaviours", choices=["turns", "same", "all", "none"], default="turns",
                        help="for which pairs daemons are killed and so on: each language on each side once, with another one each "
                             "time; languages with themselves; all; none")  # fmt: skip
    return parser.parse_args()


def chosen(checks: list[Check], only: str) -> list[Check]:
    return [check for check in checks if only in check.__name__ or only in (check.__doc__ or "")]


def run_in_one_pair(table: Table, who: str, commands: tuple[Command, Command], checks: list[Check], lab: Lab) -> None:
    """Runs checks in one pair of agents; after a failure, in another one."""
    waiting = [check for check in checks if lab.has_ipv6 or check is not modes.link_multicast]
    while waiting:
        try:
            with Pair(lab, *commands) as pair:
                while waiting:
                    check = waiting.pop(0)
                    if not table.run(who, check, lambda: pair.tried(check)):  # noqa: B023
                        raise Failed("")
        except Failed as error:
            if str(error):  # the agents did not start: further ones would not either
                table.failed.append(f"{who}: {error}")
                table.say(f"{who}: {error}")
                return


def all_pairs(languages: list[str], faces: list[str]) -> list[tuple[str, str]]:
    """All pairs of languages. A face is paired with itself, to the last language and from the one before."""
    whole = [language for language in languages if language not in faces]
    pairs = [(one, other) for one in whole for other in whole]
    for face in languages:
        if face in faces:
            pairs += [(face, face), *((face, one) for one in whole[-1:]), *((one, face) for one in whole[-2:-1])]
    return pairs


def pairs_in_turn(number: int, languages: list[str]) -> list[tuple[str, str]]:
    """The pairs of one check: each language once on each side, with another one that depends on the number of the check."""
    step = 1 + number % (len(languages) - 1) if len(languages) > 1 else 0
    return [(one, languages[(at + step) % len(languages)]) for at, one in enumerate(languages)]


def pairs_of_behaviour(how: str, check: Check, languages: list[str], faces: list[str]) -> list[tuple[str, str]]:
    """The pairs that run this check."""
    if check in behaviours.WHOLE:
        languages = [language for language in languages if language not in faces]
    if how == "turns":
        return pairs_in_turn(behaviours.CHECKS.index(check), languages)
    return [(one, other) for one in languages for other in languages if how == "all" or (how == "same" and one == other)]


def run_behaviour(table: Table, who: str, commands: tuple[Command, Command], check: Check, lab: Lab) -> None:
    """Runs a check in a pair of agents of its own."""

    def action() -> None:
        with Pair(lab, *commands) as pair:
            pair.tried(check)

    table.run(who, check, action)
    for host in lab.hosts:
        if host.daemon is None:
            host.start_daemon(lab.gemingad)


def run_vectors(table: Table, language: str, command: Command, only: str, lab: Lab) -> None:
    for check in chosen(vectors.CHECKS, only):
        agent = lab.hosts[0].start(f"agent of {language}", [*command, fresh("agent")])
        try:
            table.run(language, check, lambda: check(agent))  # noqa: B023
        finally:
            agent.discard()


def sealed_jobs(table: Table, options: argparse.Namespace, commands: dict[str, list[str]]) -> list[Job]:
    """The jobs with a key: every mode, the strangers, rotation and migration, each language once on each side."""
    whole = [language for language in commands if language not in options.face]

    def named(pairs: list[tuple[str, str]]) -> list[tuple[str, tuple[Command, Command]]]:
        named = [(f"{one}>{other}", (commands[one], commands[other])) for one, other in pairs]
        return [(who, pair) for who, pair in named if options.pair in ("", who)]

    jobs: list[Job] = []
    for number, check in enumerate([*sealed.CHECKS, *sealed.BEHAVIOURS]):
        if check in chosen([*sealed.CHECKS, *sealed.BEHAVIOURS], options.only):
            jobs += [partial(run_behaviour, table, f"{who} sealed", pair, check) for who, pair in named(pairs_in_turn(number, whole))]
    checks = [check for check in chosen(modes.CHECKS, options.only) if check is not modes.early]
    jobs += [partial(run_in_one_pair, table, f"{who} sealed", pair, checks) for who, pair in named(pairs_in_turn(0, list(commands)))]
    return jobs


def chaos_jobs(table: Table, options: argparse.Namespace, commands: dict[str, list[str]]) -> list[Job]:
    """Rounds of chaos, by pairs of languages in turn."""
    pairs = [(f"{one}>{other}", (commands[one], commands[other])) for one in commands for other in commands]
    pairs = [(who, pair) for who, pair in pairs if options.pair in ("", who)]
    jobs: list[Job] = []
    for seed in range(options.seed, options.seed + options.chaos):
        who, pair = pairs[seed % len(pairs)]
        check = partial(chaos.round_of_chaos, seed=seed)
        check.__doc__ = f"chaos, seed {seed}"
        jobs.append(partial(run_behaviour, table, who, pair, check))
    return jobs


def verdict(table: Table) -> int:
    """Prints how many checks hold. The exit status."""
    print(f"\n{table.count - len(table.failed)} of {table.count} checks hold.")
    for failed in table.failed:
        print(f"failed: {failed}")
    return 1 if table.failed or table.count == 0 else 0


def main() -> int:
    options = arguments()
    commands: dict[str, list[str]] = {}
    for agent in options.agent:
        language, _, command = agent.partition("=")
        commands[language] = shlex.split(command)
    if not commands:
        commands["python"] = [str(ROOT / "tests/client/python/agent.py")]
    table = Table()

    def wanted(pairs: list[tuple[str, str]]) -> list[tuple[str, tuple[Command, Command]]]:
        named = [(f"{one}>{other}", (commands[one], commands[other])) for one, other in pairs]
        return [(who, pair) for who, pair in named if options.pair in ("", who)]

    def tried_in(sealing: str, sequences: list[list[Job]]) -> None:
        """Runs each list of jobs in labs of this kind. Behind the first list, the air of the labs loses a tenth."""
        lanes = Lanes(lambda: Lab(os.path.abspath(options.gemingad), [options.ontology], options.loopback, sealing), options.at_once)
        try:
            print(f"Labs: {len(lanes.labs)}, each made of {lanes.labs[0].way}, {sealing}.", flush=True)
            for number, jobs in enumerate(sequences):
                if number == 1 and not all(lab.lose(LOSS_PERCENT) for lab in lanes.labs):
                    print("Nothing can be made to get lost here: no checks of that.", flush=True)
                    break
                lanes.run(jobs)
        finally:
            lanes.close()

    if options.chaos:
        tried_in(options.sealing, [chaos_jobs(table, options, commands)])
        return verdict(table)
    jobs: list[Job] = []
    for check in chosen(behaviours.CHECKS, options.only):
        for who, pair in wanted(pairs_of_behaviour(options.behaviours, check, list(commands), options.face)):
            jobs.append(partial(run_behaviour, table, who, pair, check))
    pairs = wanted(all_pairs(list(commands), options.face))
    for who, pair in pairs:
        jobs.append(partial(run_in_one_pair, table, who, pair, chosen(modes.CHECKS, options.only)))
    for language, command in commands.items():
        jobs.append(partial(run_vectors, table, language, command, options.only))
    lossy: list[Job] = [partial(run_in_one_pair, table, who, pair, chosen(loss.CHECKS, options.only)) for who, pair in pairs]
    tried_in("plain", [jobs, lossy])
    with_key = sealed_jobs(table, options, commands)
    if with_key:
        tried_in(options.sealing, [with_key])
    return verdict(table)


if __name__ == "__main__":
    sys.exit(main())
