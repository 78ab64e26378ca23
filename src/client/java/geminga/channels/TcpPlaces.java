package geminga.channels;

import geminga.protocol.Limits;
import geminga.protocol.Places;
import java.util.LinkedHashSet;
import java.util.Set;

/** The places of a subscriber's providers over TCP (src/client/CHANNELS.md, "Places"). A provider without a place waits for one. All calls are made with the loop's lock. */
final class TcpPlaces {
    private final Loop loop;
    private final ProviderChannel.Owner owner;
    private final Places<TcpInlet> places = new Places<>(Limits.TCP_PROVIDERS);
    private final Set<TcpInlet> holders = new LinkedHashSet<>();
    private final Set<TcpInlet> waiting = new LinkedHashSet<>();
    private Loop.Timer look;

    TcpPlaces(Loop loop, ProviderChannel.Owner owner) {
        this.loop = loop;
        this.owner = owner;
    }

    /** A provider asks for a place. It is told when it has one. */
    void enter(TcpInlet one) {
        Places.Outcome<TcpInlet> outcome = places.take(one, one.host());
        if (places.isToBeTold()) owner.problem("all " + Limits.TCP_PROVIDERS + " places for providers over TCP are taken");
        if (outcome.loser() != null) putBack(outcome.loser());
        if (outcome.isTaken()) {
            holders.add(one);
            one.placed();
        } else {
            waiting.add(one);
        }
        lookLater();
    }

    /** A provider is gone. */
    void leave(TcpInlet one) {
        waiting.remove(one);
        holders.remove(one);
        if (places.leave(one)) giveNext();
    }

    /** A provider has delivered a message. */
    void served(TcpInlet one) {
        places.serve(one);
    }

    private void putBack(TcpInlet one) {
        holders.remove(one);
        waiting.add(one);
        one.displaced();
    }

    private void giveNext() {
        while (!places.areTaken() && !waiting.isEmpty()) {
            TcpInlet first = waiting.iterator().next();
            waiting.remove(first);
            places.take(first, first.host());
            holders.add(first);
            first.placed();
        }
    }

    private void lookLater() {
        if (look == null && !waiting.isEmpty()) look = loop.after(Limits.HELLO_INTERVAL, this::look);
    }

    /** Gives the places of those that are not connected to those that wait. */
    private void look() {
        look = null;
        int most = waiting.size();
        for (TcpInlet one : Set.copyOf(holders)) {
            boolean isIdle = !one.hasConnection() && loop.now() - one.unconnectedSince() >= Limits.UNCONNECTED;
            if (!isIdle || most-- <= 0) continue;
            places.leave(one);
            putBack(one);
        }
        giveNext();
        lookLater();
    }

    /** No place is given any more. */
    void close() {
        waiting.clear();
        if (look != null) look.cancel();
    }
}
