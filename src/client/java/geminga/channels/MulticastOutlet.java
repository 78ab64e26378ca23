package geminga.channels;

import geminga.protocol.Frame;
import geminga.protocol.Handshake;
import geminga.protocol.PublisherFrames;
import geminga.protocol.SealedFrame;
import geminga.protocol.WireFrame;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** The outlet of {@code otm/stream} over UDP to a multicast address: sends to the group on every interface, whether anybody listens or not. */
final class MulticastOutlet implements StreamOutlet {
    /** The time between two looks at the interfaces. */
    static final long LOOK = TimeUnit.SECONDS.toNanos(2);

    private final Loop loop;
    private final Owner owner;
    private final PublisherFrames frames;
    private final Greeter greeter;
    private final InetSocketAddress group;
    private final Datagrams socket;
    /** Where hellos are taken; null while frames are plain. */
    private Datagrams hellos;
    private List<NetworkInterface> interfaces = List.of();
    private Loop.Timer look;

    MulticastOutlet(Loop loop, Owner owner, PublisherFrames frames, InetAddress group, int port) throws IOException {
        this.loop = loop;
        this.owner = owner;
        this.frames = frames;
        greeter = new Greeter(loop, owner, frames, null);
        socket = Datagrams.group(loop, new InetSocketAddress(group, port), null);
        this.group = new InetSocketAddress(group, socket.port());
        look();
    }

    private void look() {
        List<NetworkInterface> found = Datagrams.interfaces(group.getAddress());
        if (found.size() == 1 && !found.equals(interfaces)) socket.via(found.get(0));
        interfaces = found;
        look = loop.after(LOOK, this::look);
    }

    @Override
    public int port() {
        return socket.port();
    }

    @Override
    public boolean hasConsumer() {
        return true;
    }

    @Override
    public void send(byte[] payload) {
        say(loop.outgoing(frames.message(payload, helloPort())));
    }

    private int helloPort() {
        return hellos == null ? 0 : hellos.port();
    }

    /** A listener proves by its key that it may be answered, so it is asked for no cookie. */
    private void hear(InetSocketAddress from, ByteBuffer datagram) {
        WireFrame frame = WireFrame.ofDatagram(datagram);
        boolean isSealedHello = frame != null && frame.kind() == Frame.Kind.HELLO && (frame instanceof SealedFrame || frames.takesPlain());
        Frame said = isSealedHello ? frames.open(frame) : null;
        Handshake handshake = said == null ? null : Handshake.read(said.payload());
        if (handshake == null || handshake.life() != frames.life()) {
            owner.dropped();
            return;
        }
        greeter.answer(hellos, from, Frame.Kind.FLOOR, new Handshake(frame.life(), handshake.challenge(), 0));
    }

    private void say(ByteBuffer datagram) {
        boolean isSent = false;
        if (interfaces.size() == 1) {
            isSent = socket.send(datagram, group);
        } else {
            for (NetworkInterface one : interfaces) isSent |= socket.via(one) && socket.send(datagram, group);
        }
        if (!isSent) owner.leftOut();
    }

    @Override
    public boolean hasRoom(int octets) {
        return socket.hasRoom();
    }

    @Override
    public void keysChanged(boolean beginsToSeal, boolean isStrict) {
        boolean isNeeded = frames.keys() != null && frames.keys().hasRing();
        if (isNeeded == (hellos != null)) return;
        if (!isNeeded) {
            hellos.close();
            hellos = null;
            return;
        }
        try {
            hellos = Datagrams.open(loop, null, 0, this::hear);
        } catch (IOException fault) {
            owner.problem("no socket for the listeners of a publisher: " + fault.getMessage());
        }
    }

    @Override
    public void end() {
        byte[] end = frames.end(helloPort());
        if (end != null) say(ByteBuffer.wrap(end));
    }

    @Override
    public boolean hasEnded() {
        return true;
    }

    @Override
    public void close() {
        look.cancel();
        if (hellos != null) hellos.close();
        socket.close();
    }
}
