package geminga.channels;

import geminga.protocol.Counterparts;
import geminga.protocol.Counterparts.Entry;
import geminga.protocol.Frame;
import geminga.protocol.WireFrame;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.List;

/** The UDP sockets of one subscriber, its own and those of its groups, and which provider a datagram is believed to come from. All calls are made with the loop's lock. */
final class DatagramInlets implements Datagrams.Reader, Groups.Reader {
    private final Loop loop;
    private final SubscriberChannel owner;
    private final Counterparts<ProviderChannel> providers;
    private final Groups groups;
    private Datagrams socket;
    /** Whether there has been a provider that states no life. */
    private boolean hasStrangers;

    DatagramInlets(Loop loop, SubscriberChannel owner, Counterparts<ProviderChannel> providers) {
        this.loop = loop;
        this.owner = owner;
        this.providers = providers;
        groups = new Groups(loop, this);
    }

    void open(InetAddress address, int port) throws IOException {
        socket = Datagrams.open(loop, address, port, this);
    }

    /** The port of the subscriber's own socket; 0 if it has none. */
    int port() {
        return socket == null ? 0 : socket.port();
    }

    /** The inlet of a provider over UDP. */
    Inlet inlet(ProviderChannel channel, boolean isStream) {
        hasStrangers |= channel.match().life() == 0;
        InetSocketAddress group = Groups.of(channel.match());
        return group != null ? new MulticastInlet(loop, groups, socket, channel, group) : new UdpInlet(loop, socket, channel, isStream);
    }

    @Override
    public void read(InetSocketAddress from, ByteBuffer datagram) {
        for (Entry<ProviderChannel> entry : strangers()) {
            if (entry.channel.inlet() instanceof UdpInlet inlet && inlet.isAt(from)) {
                owner.deliverPlain(entry.channel, octets(datagram));
                return;
            }
        }
        WireFrame frame = WireFrame.ofDatagram(datagram);
        Entry<ProviderChannel> entry = frame == null ? null : providers.of(frame.life());
        if (entry != null && isFrom(entry.channel.inlet(), frame, from)) {
            entry.channel.take(frame, from);
            return;
        }
        owner.dropped();
        if (frame != null && (frame.kind() == Frame.Kind.MESSAGE || frame.kind() == Frame.Kind.END)) owner.keepEarly(from, frame);
    }

    /** Whether a frame on the own socket may be this provider's: over multicast only the answer to a hello is. */
    private static boolean isFrom(Inlet inlet, WireFrame frame, InetSocketAddress from) {
        boolean isAnswer = frame.kind() == Frame.Kind.FLOOR || frame.kind() == Frame.Kind.FULL;
        return inlet instanceof UdpInlet one && one.isAt(from) || isAnswer && inlet instanceof MulticastInlet group && group.isGreeted(from);
    }

    @Override
    public void heard(InetSocketAddress group, InetSocketAddress from, ByteBuffer datagram) {
        for (Entry<ProviderChannel> entry : strangers()) {
            if (entry.channel.inlet() instanceof MulticastInlet inlet && inlet.isOf(group) && from.getPort() == entry.match().port()) {
                owner.deliverPlain(entry.channel, octets(datagram));
                return;
            }
        }
        WireFrame frame = WireFrame.ofDatagram(datagram);
        Entry<ProviderChannel> entry = frame == null ? null : providers.of(frame.life());
        boolean isBelieved = entry != null && entry.channel.inlet() instanceof MulticastInlet inlet && inlet.isOf(group) && from.getPort() == entry.match().port();
        if (isBelieved) {
            entry.channel.take(frame, from);
        } else {
            owner.dropped();
        }
    }

    private List<Entry<ProviderChannel>> strangers() {
        return hasStrangers ? providers.all().stream().filter(entry -> entry.match().life() == 0).toList() : List.of();
    }

    private static byte[] octets(ByteBuffer datagram) {
        byte[] octets = new byte[datagram.remaining()];
        datagram.get(octets);
        return octets;
    }

    /** Reads what the sockets hold now; whether they hold nothing more. */
    boolean drain() {
        return (socket == null || socket.drain()) & groups.drain();
    }

    void close() {
        if (socket != null) socket.close();
    }
}
