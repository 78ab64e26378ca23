"""Two hosts with a daemon each: network namespaces if they are allowed, else two daemons on the loopback interface."""

from __future__ import annotations

import contextlib
import os
import shlex
import socket
import subprocess
from collections.abc import Iterator, Sequence

from spoken import Failed, Spoken
from team import Team

LINK = "wlan0"


def _may_make_namespaces() -> bool:
    done = subprocess.run(["unshare", "-n", "true"], stdin=subprocess.DEVNULL, capture_output=True, check=False)
    return done.returncode == 0


def _free_port(kind: socket.SocketKind) -> int:
    with socket.socket(socket.AF_INET, kind) as sock:
        sock.bind(("127.0.0.1", 0))
        return int(sock.getsockname()[1])


class Host:
    """A host where programs run. `address` is the one that the other host sees."""

    def __init__(self, number: int, address: str, gcnp_port: int, prefix: Sequence[str], flags: Sequence[str]) -> None:
        self.number = number
        self.address = address
        self.gcnp_port = gcnp_port
        self._prefix = list(prefix)
        self._flags = list(flags)
        self.daemon: Spoken | None = None

    def start(self, name: str, command: Sequence[str], with_errors: bool = False) -> Spoken:
        """Starts a process on this host, which finds the host's daemon."""
        environment = dict(os.environ, GEMINGA_CONNECT=f"127.0.0.1:{self.gcnp_port}")
        return Spoken(name, [*self._prefix, *command], environment, with_errors)

    def run(self, command: Sequence[str]) -> None:
        """Runs a command to its end. Raises Failed if it fails."""
        done = subprocess.run([*self._prefix, *command], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Failed(f"{shlex.join(command)}: {done.stderr}")

    def can(self, command: Sequence[str]) -> bool:
        """Runs a command to its end. Whether it succeeded."""
        try:
            self.run(command)
        except Failed:
            return False
        return True

    def start_daemon(self, program: str) -> None:
        """Starts gemingad and waits until it is ready and has read its ontology, which a busy machine does while it already serves."""
        name = f"host{self.number}"
        flags = ["--name", name, "--gcnp", f"127.0.0.1:{self.gcnp_port}", "--interval", "0.5", *self._flags]
        self.daemon = self.start(f"gemingad of {name}", [program, *flags], with_errors=True)
        if "ontology is being loaded" in self.daemon.find(r".* ready: .*")[0]:
            self.daemon.find(r".*( is in force|serving without an ontology.*)")

    def reload_daemon(self, mode: str) -> None:
        """Has gemingad read its configuration again, and waits until it seals in this mode."""
        assert self.daemon is not None
        self.daemon.reload()
        self.daemon.find(rf".*announcements: {mode}, keys .*")

    def kill_daemon(self) -> None:
        """Kills gemingad by SIGKILL."""
        assert self.daemon is not None
        self.daemon.kill()
        self.daemon.discard()
        self.daemon = None

    @contextlib.contextmanager
    def standing_daemon(self) -> Iterator[None]:
        """Stops the daemon for the time of the `with` block."""
        assert self.daemon is not None
        self.daemon.stand()
        try:
            yield
        finally:
            self.daemon.go_on()


class Lab:
    """Two hosts, 0 and 1, that reach each other. The daemons of a sealed lab have a key of a team."""

    def __init__(self, gemingad: str, ontologies: Sequence[str], on_loopback: bool = False, sealing: str = "plain") -> None:
        self.gemingad = gemingad
        self.is_sealed = sealing != "plain"
        self.team = Team(gemingad)
        self.sealing = sealing
        self._in_force: tuple[str, tuple[int, ...]] = (sealing, (0,))
        for number in range(2):
            self.team.write(number, sealing)
        self._holders: list[subprocess.Popen[str]] = []
        flags = [word for folder in ontologies for word in ("--ontology", folder)]
        self.has_namespaces = not on_loopback and _may_make_namespaces()
        self.has_ipv6 = False  #: on the link between both
        self.hosts: list[Host] = []
        try:
            if self.has_namespaces:
                self._make_namespaces(flags)
            else:
                udp_port = _free_port(socket.SOCK_DGRAM)
                for number in range(2):
                    own = [*flags, "--interface", "lo", "--port", str(udp_port)]
                    self.hosts.append(Host(number, "127.0.0.1", _free_port(socket.SOCK_STREAM), [], [*own, *self._configured(number)]))
        except BaseException:
            self.close()
            raise

    def _configured(self, number: int) -> list[str]:
        return ["--config", str(self.team.configuration(number))]

    def start_daemons_as(self, mode: str) -> None:
        """Kills both daemons, and starts them in this mode of sealing: they have forgotten how the other one sealed."""
        self._in_force = (mode, (0,))
        for host in self.hosts:
            host.kill_daemon()
            self.team.write(host.number, mode)
        self.start_daemons()

    def seal(self, mode: str, keys: Sequence[int] = (0,)) -> None:
        """Has both daemons seal in this mode with these keys, one after the other. Requires that they have keys already."""
        if (mode, tuple(keys)) == self._in_force:
            return  # a daemon logs changes only
        self._in_force = (mode, tuple(keys))
        for host in self.hosts:
            self.team.write(host.number, mode, keys)
            host.reload_daemon(mode)

    @property
    def way(self) -> str:
        """The kind of lab, for people."""
        return "two network namespaces" if self.has_namespaces else "two daemons on the loopback interface"

    def start_daemons(self) -> None:
        """Starts gemingad on both hosts."""
        for host in self.hosts:
            host.start_daemon(self.gemingad)

    def lose(self, percent: int) -> bool:
        """Lets each host lose so many percent of its packets from now on, by chance. False if that is not possible."""
        if not self.has_namespaces:
            return False
        rules = (
            f"add table netdev air; add chain netdev air in {{ type filter hook ingress device {LINK} priority 0; }}; "
            f"add rule netdev air in meta protocol {{ ip, ip6 }} numgen random mod 100 < {percent} drop"
        )
        netem = ["tc", "qdisc", "add", "dev", LINK, "root", "netem", "loss", f"{percent}%"]
        return all(host.can(["nft", rules]) or host.can(netem) for host in self.hosts)

    def close(self) -> None:
        """Ends all processes."""
        for host in self.hosts:
            if host.daemon is not None:
                host.daemon.discard()
        for holder in self._holders:
            assert holder.stdin is not None
            holder.stdin.close()
            holder.wait()
        self.team.close()

    def _make_namespaces(self, flags: Sequence[str]) -> None:
        for _ in range(2):
            # It ends with its standard input, and so with this process, and the namespace ends with it.
            holder = subprocess.Popen(
                ["unshare", "-n", "sh", "-c", "echo there; exec cat"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
            )
            assert holder.stdout is not None
            self._holders.append(holder)
            holder.stdout.readline()
        for number, holder in enumerate(self._holders):
            prefix = ["nsenter", "-t", str(holder.pid), "-n", "--"]
            self.hosts.append(Host(number, f"10.66.0.{number + 1}", 4717, prefix, [*flags, *self._configured(number)]))
        other = str(self._holders[1].pid)
        self.hosts[0].run(["ip", "link", "add", LINK, "type", "veth", "peer", "name", LINK, "netns", other])
        for host in self.hosts:
            host.run(["ip", "link", "set", "lo", "up"])
            host.run(["ip", "address", "add", f"{host.address}/24", "dev", LINK])
            host.run(["ip", "link", "set", LINK, "up"])
        # An address that can be used at once, without the search for duplicates.
        self.has_ipv6 = all([host.can(["ip", "address", "add", f"fe80::66:{host.number + 1}/64", "dev", LINK, "nodad"]) for host in self.hosts])
