"""A project of its own: its vision publishes by asyncio, its world model reads by the blocking front in another process."""

from __future__ import annotations

import asyncio
import importlib.metadata
import multiprocessing

import geminga
import geminga.blocking

COUNT = 5


def world_model(heard: multiprocessing.Queue[bytes]) -> None:
    with geminga.blocking.connect("world-model") as node:
        with node.subscribe(concept="soccer:TrackedObject", mode="otm/pubsub", timeout=20) as objects:
            for _ in range(COUNT):
                heard.put(objects.receive(timeout=20).payload)


async def vision() -> None:
    async with geminga.connect("vision") as node:
        async with node.publish(concept="soccer:BallInfo", mode="otm/pubsub", protocol="tcp") as ball:
            while ball.sent < COUNT:
                ball.send(f"ball {ball.sent}".encode())
                await asyncio.sleep(0.02)


if __name__ == "__main__":
    assert importlib.metadata.version("geminga") == geminga.__version__
    context = multiprocessing.get_context("spawn")
    queue = context.Queue()
    reader = context.Process(target=world_model, args=(queue,))
    reader.start()
    asyncio.run(vision())
    reader.join()
    got = [queue.get(timeout=1) for _ in range(COUNT)]
    assert got == [f"ball {number}".encode() for number in range(COUNT)], got
    print("the installed wheel works")
