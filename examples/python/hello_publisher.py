#!/usr/bin/python3
"""Says where the ball is, ten times a second, to whoever asks for it: needs a gemingad with the soccer ontology."""

import asyncio
import json
import sys

import geminga


def told(what: geminga.Happening) -> None:
    if isinstance(what, geminga.ConsumerChanged):
        print(f"{what.consumer.name} {what.change} {what.reason}", file=sys.stderr)
    elif isinstance(what, geminga.Connected):
        print(f"the daemon of {what.participant_name} answers; waiting for consumers", file=sys.stderr)


async def main(count: int) -> None:
    async with geminga.connect("hello-publisher", on_event=told) as node:
        async with node.publish(concept="soccer:BallInfo", mode="otm/pubsub", attributes={"camera": "front"}) as ball:
            while ball.sent < count:  # Only what reaches somebody is counted.
                ball.send(json.dumps({"x": 1.5, "y": -0.2, "number": ball.sent + 1}).encode())
                await asyncio.sleep(0.1)


asyncio.run(main(int(sys.argv[1]) if len(sys.argv) > 1 else 10**9))
