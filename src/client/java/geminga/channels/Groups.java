package geminga.channels;

import geminga.Match;
import geminga.protocol.Addresses;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.nio.ByteBuffer;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/** The multicast groups of one subscriber: a socket for each, joined on every interface. All calls are made with the loop's lock. */
final class Groups {
    /** The receiver of their datagrams. */
    interface Reader {
        void heard(InetSocketAddress group, InetSocketAddress from, ByteBuffer datagram);
    }

    private final class Group implements Datagrams.Reader {
        private final InetSocketAddress address;
        private final Datagrams socket;
        private final Set<NetworkInterface> joined = new HashSet<>();
        private int members;

        Group(InetSocketAddress address) throws IOException {
            this.address = address;
            socket = Datagrams.group(loop, address, this);
        }

        @Override
        public void read(InetSocketAddress from, ByteBuffer datagram) {
            reader.heard(address, from, datagram);
        }

        void join() {
            Set<NetworkInterface> found = new HashSet<>(Datagrams.interfaces(address.getAddress()));
            joined.retainAll(found); // an interface that comes back has to be joined again
            for (NetworkInterface one : found) {
                if (!joined.contains(one) && socket.join(address.getAddress(), one)) joined.add(one);
            }
        }
    }

    private final Loop loop;
    private final Reader reader;
    private final Map<InetSocketAddress, Group> groups = new LinkedHashMap<>();
    private Loop.Timer look;

    Groups(Loop loop, Reader reader) {
        this.loop = loop;
        this.reader = reader;
    }

    /** The group of a provider, or null if its address is none. */
    static InetSocketAddress of(Match provider) {
        InetAddress address = provider.address().isEmpty() || !provider.protocol().equals("udp") ? null : Addresses.read(provider.address());
        return address != null && address.isMulticastAddress() ? new InetSocketAddress(address, provider.port()) : null;
    }

    void enter(InetSocketAddress address) {
        Group group = groups.get(address);
        if (group == null) {
            try {
                group = new Group(address);
            } catch (IOException fault) {
                loop.problem("no socket for the group " + address + ": " + fault.getMessage());
                return;
            }
            groups.put(address, group);
            group.join();
        }
        ++group.members;
        if (look == null) look = loop.after(MulticastOutlet.LOOK, this::look);
    }

    private void look() {
        groups.values().forEach(Group::join);
        look = loop.after(MulticastOutlet.LOOK, this::look);
    }

    void leave(InetSocketAddress address) {
        Group group = groups.get(address);
        if (group == null || --group.members > 0) return;
        groups.remove(address);
        group.socket.close();
        if (!groups.isEmpty() || look == null) return;
        look.cancel();
        look = null;
    }

    /** Reads what the sockets hold now; whether they hold nothing more. */
    boolean drain() {
        boolean isEmpty = true;
        for (Group group : Set.copyOf(groups.values())) isEmpty &= group.socket.drain();
        return isEmpty;
    }
}
