#!/usr/bin/python3
"""Prints where the ball is, whoever in the team knows it: needs a gemingad with the soccer ontology."""

import sys

import geminga
import geminga.blocking


def told(what: geminga.Happening) -> None:
    if isinstance(what, geminga.ProviderChanged):
        print(f"{what.provider.name} on {what.provider.participant_name} {what.change} {what.reason}", file=sys.stderr)
    elif isinstance(what, geminga.Connected):
        print(f"the daemon of {what.participant_name} answers; waiting for providers", file=sys.stderr)


def main(count: int) -> None:
    with geminga.blocking.connect("hello-subscriber", on_event=told) as node:
        with node.subscribe(concept="soccer:TrackedObject", mode="otm/pubsub") as balls:
            for number, ball in enumerate(balls, start=1):
                print(ball.payload.decode(errors="replace"), flush=True)
                if number == count:
                    return


main(int(sys.argv[1]) if len(sys.argv) > 1 else 10**9)
