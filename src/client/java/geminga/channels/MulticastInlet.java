package geminga.channels;

import geminga.Match;
import geminga.protocol.Addresses;
import geminga.protocol.Frame;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;

/**
 * The inlet of one provider over multicast. Providers of the same group and port share a socket. Where the provider seals, this side says hello from the subscriber's own socket,
 * so that a recording is told from the present.
 */
final class MulticastInlet implements Inlet {
    private final Loop loop;
    private final Groups groups;
    private final Datagrams socket;
    private final ProviderChannel channel;
    private InetSocketAddress group;
    /** Where the provider takes hellos; null until something sealed was heard. */
    private InetSocketAddress greeted;
    private Loop.Timer hello;

    MulticastInlet(Loop loop, Groups groups, Datagrams socket, ProviderChannel channel, InetSocketAddress group) {
        this.loop = loop;
        this.groups = groups;
        this.socket = socket;
        this.channel = channel;
        this.group = group;
        groups.enter(group);
    }

    /** Whether a datagram to that group may be this provider's. */
    boolean isOf(InetSocketAddress heard) {
        return group.equals(heard);
    }

    /** Whether an answer from there may be this provider's. */
    boolean isGreeted(InetSocketAddress from) {
        return greeted != null && from.getPort() == greeted.getPort() && Addresses.areSame(from.getAddress(), greeted.getAddress());
    }

    /** A sealed frame was heard before the floor: it is asked for at the port that the frame names. */
    void heardSealed(InetSocketAddress from, int port) {
        if (port == 0) return;
        // A host without any other interface sends to its own loopback from no address.
        InetAddress address = from.getAddress().isAnyLocalAddress() ? InetAddress.getLoopbackAddress() : from.getAddress();
        greeted = new InetSocketAddress(address, port);
        if (hello == null) sayHello();
    }

    private void sayHello() {
        hello = null;
        if (channel.greeting().isAccepted()) return;
        byte[] octets = channel.say(Frame.Kind.HELLO);
        if (octets != null) socket.send(ByteBuffer.wrap(octets), greeted);
        hello = loop.after(channel.greeting().next(), this::sayHello);
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
    public void answered(boolean isAskedAgain) {
        if (!channel.greeting().isAccepted() || hello == null) return;
        hello.cancel();
        hello = null;
    }

    @Override
    public void keysChanged() {
        channel.greeting().begin();
    }

    @Override
    public void ending() {}

    @Override
    public void close() {
        if (hello != null) hello.cancel();
        groups.leave(group);
    }
}
