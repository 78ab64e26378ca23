package geminga.channels;

import geminga.Match;
import geminga.protocol.Addresses;
import geminga.protocol.Frame;
import geminga.protocol.Limits;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;

/** The inlet of one provider over UDP, whose messages come to the subscriber's socket. Says hello to a stream once a second. */
final class UdpInlet implements Inlet {
    private final Loop loop;
    private final Datagrams socket;
    private final long ownLife;
    private final boolean saysHello;
    private Match provider;
    private InetSocketAddress address;
    private Loop.Timer hello;
    private boolean isEnding;

    UdpInlet(Loop loop, Datagrams socket, long ownLife, Match provider, boolean saysHello) {
        this.loop = loop;
        this.socket = socket;
        this.ownLife = ownLife;
        this.saysHello = saysHello && provider.life() != 0;
        changed(provider);
    }

    /** Whether a datagram from this address may be this provider's. */
    boolean isAt(InetSocketAddress from) {
        return address != null && from.getPort() == address.getPort() && Addresses.areSame(from.getAddress(), address.getAddress());
    }

    private void sayHello() {
        say(Frame.Kind.HELLO);
        hello = loop.after(Limits.HELLO_INTERVAL, this::sayHello);
    }

    private void say(Frame.Kind kind) {
        if (address != null) socket.send(ByteBuffer.wrap(Frame.toPublisher(kind, ownLife, provider.life()).write()), address);
    }

    @Override
    public void changed(Match match) {
        InetSocketAddress before = address;
        InetAddress read = match.address().isEmpty() || match.port() == 0 ? null : Addresses.read(match.address());
        provider = match;
        address = read == null ? null : new InetSocketAddress(read, match.port());
        isEnding = false;
        boolean isElsewhere = before == null ? address != null : !before.equals(address);
        if (!saysHello || !isElsewhere) return;
        if (hello != null) hello.cancel();
        sayHello();
    }

    @Override
    public void ending() {
        isEnding = true;
        if (hello != null) hello.cancel();
        hello = null;
    }

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
        if (saysHello && !isEnding) say(Frame.Kind.END);
        if (hello != null) hello.cancel();
        hello = null;
    }
}
