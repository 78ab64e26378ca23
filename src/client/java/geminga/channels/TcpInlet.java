package geminga.channels;

import geminga.Match;
import geminga.protocol.Addresses;
import geminga.protocol.Backoff;
import geminga.protocol.Frame;
import geminga.protocol.FrameReader;
import geminga.protocol.Limits;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.random.RandomGenerator;

/** The inlet of one provider over TCP: connects, says hello, and connects again with back-off while the provider is matched. */
final class TcpInlet implements Inlet, Stream.Reader {
    private final Loop loop;
    private final Owner owner;
    private final long ownLife;
    private final Backoff backoff;
    private Match provider;
    private Stream stream;
    private FrameReader frames;
    /** Octets that were read and wait for room. */
    private ByteBuffer rest = ByteBuffer.allocate(0);
    private Loop.Timer retry;
    private boolean isConnected;
    private boolean isPaused;
    private boolean isFinished;
    private boolean isClosed;

    TcpInlet(Loop loop, Owner owner, long ownLife, Match provider, RandomGenerator chance) {
        this.loop = loop;
        this.owner = owner;
        this.ownLife = ownLife;
        this.provider = provider;
        backoff = new Backoff(chance);
        connect();
    }

    private void connect() {
        retry = null;
        frames = new FrameReader(Limits.TCP_MESSAGE);
        rest = ByteBuffer.allocate(0);
        isConnected = false;
        isPaused = false;
        isFinished = false;
        InetAddress address = provider.address().isEmpty() ? null : Addresses.read(provider.address());
        try {
            if (address == null) throw new IOException("no address");
            stream = Stream.connect(loop, new InetSocketAddress(address, provider.port()), this);
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
        stream.write(ByteBuffer.wrap(Frame.hello(ownLife).write()));
    }

    @Override
    public void read(ByteBuffer octets) {
        Stream from = stream;
        while (owner.hasRoom()) {
            Frame frame = frames.next(octets);
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
        owner.dropped();
        stream.close();
        broke("no frame");
    }

    private void take(Frame frame) {
        if (frame.life() != provider.life() || frame.kind() == Frame.Kind.HELLO) {
            owner.dropped();
            return;
        }
        backoff.reset();
        if (frame.kind() == Frame.Kind.END) {
            owner.ended(provider.life(), frame.sequence());
        } else {
            owner.deliver(provider, frame.payload(), frame.life(), frame.sequence());
        }
    }

    @Override
    public void resume() {
        if (!isPaused || isClosed || !owner.hasRoom()) return;
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
        isConnected = false;
        isPaused = false;
        if (owner.broke(provider.life()) && !isClosed) later();
    }

    @Override
    public void changed(Match match) {
        boolean isElsewhere = !match.address().equals(provider.address()) || match.port() != provider.port();
        provider = match;
        if (!isElsewhere) return;
        disconnect();
        connect();
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
        if (stream != null) stream.close();
        stream = null;
        isConnected = false;
    }

    @Override
    public void close() {
        isClosed = true;
        disconnect();
    }
}
