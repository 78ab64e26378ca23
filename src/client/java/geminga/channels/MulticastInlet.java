package geminga.channels;

import geminga.Match;
import java.net.InetSocketAddress;

/** The inlet of one provider over multicast. Providers of the same group and port share a socket. */
final class MulticastInlet implements Inlet {
    private final Groups groups;
    private InetSocketAddress group;

    MulticastInlet(Groups groups, InetSocketAddress group) {
        this.groups = groups;
        this.group = group;
        groups.enter(group);
    }

    /** Whether a datagram to that group may be this provider's. */
    boolean isOf(InetSocketAddress heard) {
        return group.equals(heard);
    }

    @Override
    public void changed(Match match) {
        InetSocketAddress next = Groups.of(match);
        if (next == null || next.equals(group)) return;
        groups.enter(next);
        groups.leave(group);
        group = next;
    }

    @Override
    public void ending() {}

    @Override
    public boolean isPaused() {
        return false;
    }

    @Override
    public void resume() {}

    @Override
    public boolean hasConnection() {
        return false;
    }

    @Override
    public void close() {
        groups.leave(group);
    }
}
