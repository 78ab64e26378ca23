package geminga.channels;

import geminga.Match;
import geminga.protocol.Addresses;
import geminga.protocol.Frame;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;

/** The inlet of one provider over UDP, whose messages come to the subscriber's socket. Says hello to a stream, and on every channel that may be sealed. */
final class UdpInlet implements Inlet {
    private final Loop loop;
    private final Datagrams socket;
    private final ProviderChannel channel;
    private final boolean isStream;
    private InetSocketAddress address;
    private Loop.Timer hello;
    private boolean isEnding;

    UdpInlet(Loop loop, Datagrams socket, ProviderChannel channel, boolean isStream) {
        this.loop = loop;
        this.socket = socket;
        this.channel = channel;
        this.isStream = isStream;
        changed(channel.match());
    }

    /** Whether a datagram from this address may be this provider's. */
    boolean isAt(InetSocketAddress from) {
        return address != null && from.getPort() == address.getPort() && Addresses.areSame(from.getAddress(), address.getAddress());
    }

    private boolean saysHello() {
        return channel.match().life() != 0 && (isStream || channel.mayBeSealed());
    }

    private void sayHello() {
        if (hello != null) hello.cancel();
        hello = null;
        if (!saysHello() || isEnding) return;
        say(Frame.Kind.HELLO);
        hello = loop.after(channel.greeting().next(), this::sayHello);
    }

    private void say(Frame.Kind kind) {
        byte[] octets = address == null ? null : channel.say(kind);
        if (octets != null) socket.send(ByteBuffer.wrap(octets), address);
    }

    @Override
    public void changed(Match match) {
        InetSocketAddress before = address;
        InetAddress read = match.address().isEmpty() || match.port() == 0 ? null : Addresses.read(match.address());
        address = read == null ? null : new InetSocketAddress(read, match.port());
        boolean isElsewhere = before == null ? address != null : !before.equals(address);
        boolean wasEnding = isEnding;
        isEnding = false;
        if (isElsewhere) channel.greeting().begin();
        if (isElsewhere || wasEnding) sayHello();
    }

    @Override
    public void answered(boolean isAskedAgain) {
        if (isAskedAgain) {
            sayHello();
            return;
        }
        if (hello == null) return;
        hello.cancel();
        hello = loop.after(channel.greeting().next(), this::sayHello);
    }

    @Override
    public void keysChanged() {
        sayHello();
    }

    @Override
    public void ending() {
        isEnding = true;
        if (hello != null) hello.cancel();
        hello = null;
    }

    @Override
    public void close() {
        if (saysHello() && !isEnding) say(Frame.Kind.END);
        if (hello != null) hello.cancel();
        hello = null;
    }
}
