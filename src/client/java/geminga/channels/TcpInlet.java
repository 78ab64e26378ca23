package geminga.channels;

import geminga.Match;
import geminga.protocol.Addresses;
import geminga.protocol.Backoff;
import geminga.protocol.Frame;
import geminga.protocol.FrameReader;
import geminga.protocol.Limits;
import geminga.protocol.WireFrame;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.random.RandomGenerator;

/** The inlet of one provider over TCP: connects when it has a place, says hello, and connects again with back-off while the provider is matched. */
final class TcpInlet implements Inlet, Stream.Reader {
    private final Loop loop;
    private final TcpPlaces places;
    private final ProviderChannel channel;
    private final Backoff backoff;
    private InetSocketAddress address;
    private Stream stream;
    private FrameReader frames;
    /** Octets that were read and wait for room. */
    private ByteBuffer rest = ByteBuffer.allocate(0);
    private Loop.Timer retry;
    private long unconnectedSince;
    private boolean hasPlace;
    private boolean isConnected;
    private boolean isPaused;
    private boolean isFinished;
    private boolean isClosed;

    TcpInlet(Loop loop, TcpPlaces places, ProviderChannel channel, RandomGenerator chance) {
        this.loop = loop;
        this.places = places;
        this.channel = channel;
        backoff = new Backoff(chance);
        address = address(channel.match());
        places.enter(this);
    }

    private static InetSocketAddress address(Match match) {
        InetAddress read = match.address().isEmpty() ? null : Addresses.read(match.address());
        return read == null ? null : new InetSocketAddress(read, match.port());
    }

    /** The address by which places are shared. */
    Object host() {
        return address == null ? "" : address.getAddress();
    }

    /** It has a place. */
    void placed() {
        hasPlace = true;
        unconnectedSince = loop.now();
        connect();
    }

    /** Its place was given to another provider. */
    void displaced() {
        hasPlace = false;
        disconnect();
    }

    /** The time since which it has had a place without a connection. */
    long unconnectedSince() {
        return unconnectedSince;
    }

    private void connect() {
        retry = null;
        frames = new FrameReader(Limits.TCP_MESSAGE);
        rest = ByteBuffer.allocate(0);
        isConnected = false;
        isPaused = false;
        isFinished = false;
        try {
            if (address == null) throw new IOException("no address");
            stream = Stream.connect(loop, address, this);
        } catch (IOException fault) {
            stream = null;
            later();
        }
    }

    private void later() {
        retry = loop.after(backoff.next(), this::connect);
    }

    @Override
    public void connected() {
        isConnected = true;
        channel.greeting().begin();
        sayHello();
    }

    private void sayHello() {
        byte[] hello = channel.say(Frame.Kind.HELLO);
        if (hello != null && stream != null) stream.write(hello);
    }

    @Override
    public void answered(boolean isAskedAgain) {
        if (isAskedAgain) sayHello();
    }

    @Override
    public void keysChanged() {}

    @Override
    public void read(ByteBuffer octets) {
        Stream from = stream;
        while (channel.hasRoom()) {
            WireFrame frame = frames.next(octets);
            if (frame == null) {
                if (frames.isBroken()) brokenFrame();
                return;
            }
            take(frame);
            if (stream != from) return; // closed, or another connection
        }
        rest = ByteBuffer.allocate(octets.remaining()).put(octets).flip();
        isPaused = true;
        stream.pause(true);
    }

    private void brokenFrame() {
        channel.dropped();
        stream.close();
        broke("no frame");
    }

    private void take(WireFrame frame) {
        if (frame.life() != channel.match().life()) {
            channel.dropped();
            return;
        }
        Stream from = stream;
        boolean isOpened = channel.take(frame, null);
        if (stream != from || stream == null) return;
        if (!isOpened) {
            stream.close();
            broke("a frame cannot be opened");
        } else if (frame.kind() == Frame.Kind.MESSAGE) {
            backoff.reset();
            places.served(this);
        }
    }

    @Override
    public void resume() {
        if (!isPaused || isClosed || !channel.hasRoom()) return;
        isPaused = false;
        ByteBuffer octets = rest;
        rest = ByteBuffer.allocate(0);
        Stream from = stream;
        stream.pause(isFinished);
        read(octets);
        if (stream == from && !isPaused && isFinished) finished();
    }

    @Override
    public void drained() {}

    @Override
    public void finished() {
        isFinished = true;
        if (isPaused) return; // frames that were read come first
        stream.close();
        broke("the provider closed the connection");
    }

    @Override
    public void broke(String reason) {
        stream = null;
        if (isConnected) unconnectedSince = loop.now();
        isConnected = false;
        isPaused = false;
        if (channel.broke() && !isClosed && hasPlace) later();
    }

    @Override
    public void changed(Match match) {
        InetSocketAddress next = address(match);
        if (java.util.Objects.equals(next, address)) return;
        address = next;
        disconnect();
        places.leave(this); // places are shared by address
        hasPlace = false;
        places.enter(this);
    }

    @Override
    public void ending() {}

    @Override
    public boolean isPaused() {
        return isPaused;
    }

    @Override
    public boolean hasConnection() {
        return isConnected;
    }

    private void disconnect() {
        if (retry != null) retry.cancel();
        retry = null;
        if (stream != null) stream.close();
        stream = null;
        isConnected = false;
    }

    @Override
    public void close() {
        isClosed = true;
        disconnect();
        places.leave(this);
    }
}
