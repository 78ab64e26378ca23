package geminga.channels;

import geminga.protocol.SendQueue;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.SocketOption;
import java.net.StandardProtocolFamily;
import java.net.StandardSocketOptions;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;

/** A connection, and the octets that wait to be written. All calls are made with the loop's lock. */
final class Stream implements Loop.Ready {
    /** The reader of a connection. */
    interface Reader {
        /** The connection is open. */
        void connected();

        /** Takes octets. Octets that are left in the buffer are lost. */
        void read(ByteBuffer octets);

        /** Everything is written. */
        void drained();

        /** The other side has closed its half. */
        void finished();

        /** The connection is gone. Not called after {@link Stream#close}. */
        void broke(String reason);
    }

    /** Reads of one connection before the others have their turn. */
    private static final int READS = 4;
    private static final int CHUNK = 256 * 1024;

    private final Loop loop;
    private final Reader reader;
    private final SocketChannel channel;
    private final SelectionKey key;
    private final InetSocketAddress peer;
    private final SendQueue waiting;
    /** When it last took something of what waits, or nothing waited. */
    private long taken;
    private boolean isConnected;
    private boolean isClosed;
    private boolean endsWhenDrained;
    private boolean isPaused;

    private Stream(Loop loop, SocketChannel channel, Reader reader, boolean isConnected, SendQueue.Pool pool) throws IOException {
        this.loop = loop;
        waiting = new SendQueue(pool);
        this.reader = reader;
        this.channel = channel;
        this.isConnected = isConnected;
        peer = channel.getRemoteAddress() instanceof InetSocketAddress address ? address : null;
        channel.configureBlocking(false);
        key = loop.register(channel, isConnected ? SelectionKey.OP_READ : SelectionKey.OP_CONNECT, this);
    }

    /** Begins to connect; the reader is told the result. */
    static Stream connect(Loop loop, SocketAddress address, Reader reader) throws IOException {
        boolean isUnix = address instanceof UnixDomainSocketAddress;
        SocketChannel channel = isUnix ? SocketChannel.open(StandardProtocolFamily.UNIX) : SocketChannel.open();
        try {
            if (!isUnix) tune(channel);
            channel.configureBlocking(false);
            if (!channel.connect(address)) return new Stream(loop, channel, reader, false, new SendQueue.Pool());
            Stream stream = new Stream(loop, channel, reader, true, new SendQueue.Pool());
            loop.after(0, () -> {
                if (!stream.isClosed) reader.connected();
            });
            return stream;
        } catch (IOException | RuntimeException fault) {
            channel.close();
            throw fault instanceof IOException ? (IOException) fault : new IOException(fault);
        }
    }

    /** Takes over a connection that was accepted. What waits for it counts in the pool. */
    static Stream accepted(Loop loop, SocketChannel channel, Reader reader, SendQueue.Pool pool) throws IOException {
        tune(channel);
        return new Stream(loop, channel, reader, true, pool);
    }

    /** Sets options: small messages leave at once, and a host that was switched off is noticed. */
    private static void tune(SocketChannel channel) throws IOException {
        channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
        channel.setOption(StandardSocketOptions.SO_KEEPALIVE, true);
        for (SocketOption<?> option : channel.supportedOptions()) {
            switch (option.name()) { // of jdk.net.ExtendedSocketOptions, where the platform has them
                case "TCP_KEEPIDLE" -> set(channel, option, 10);
                case "TCP_KEEPINTERVAL" -> set(channel, option, 5);
                case "TCP_KEEPCOUNT" -> set(channel, option, 3);
                default -> { }
            }
        }
    }

    @SuppressWarnings("unchecked")
    private static void set(SocketChannel channel, SocketOption<?> option, int value) throws IOException {
        channel.setOption((SocketOption<Integer>) option, value);
    }

    @Override
    public void ready(SelectionKey ready) {
        try {
            if (!isConnected) {
                if (!channel.finishConnect()) return;
                isConnected = true;
                key.interestOps(SelectionKey.OP_READ);
                reader.connected();
                return;
            }
            if (ready.isWritable()) flush();
            if (!isClosed && ready.isValid() && ready.isReadable()) receive();
        } catch (IOException fault) {
            fail(fault.getMessage());
        }
    }

    /** Reads octets that have come already. */
    void look() {
        try {
            receive();
        } catch (IOException fault) {
            fail(fault.getMessage());
        }
    }

    private void receive() throws IOException {
        for (int i = 0; i < READS && !isClosed && !isPaused; ++i) {
            ByteBuffer octets = loop.incoming.clear();
            int read = channel.read(octets);
            if (read == 0) return;
            if (read < 0) {
                loop.interest(key, SelectionKey.OP_READ, false);
                reader.finished();
                return;
            }
            reader.read(octets.flip());
            if (read < octets.capacity()) return;
        }
    }

    /** The octets that wait to be written. */
    long waiting() {
        return waiting.octets();
    }

    /** When the other side last took something of what waits. */
    long taken() {
        return taken;
    }

    /** Whether a frame of this size may wait. */
    boolean hasRoom(int octets) {
        return waiting.hasRoom(octets);
    }

    /** The address of the other side, or null. */
    InetSocketAddress peer() {
        return peer;
    }

    /** Writes octets to an open connection. */
    void write(byte[] octets) {
        write(new SendQueue.Shared(octets));
    }

    /** Writes a frame to an open connection: as much as it takes now, and the rest later. */
    void write(SendQueue.Shared frame) {
        if (isClosed) return;
        ByteBuffer octets = frame.octets();
        try {
            if (waiting.isEmpty()) {
                put(octets);
                taken = loop.now();
            }
            if (!octets.hasRemaining()) return;
            waiting.put(frame, octets);
            loop.interest(key, SelectionKey.OP_WRITE, true);
        } catch (IOException fault) {
            failSoon(fault.getMessage());
        }
    }

    /** Writes what the connection takes now, in pieces, because Java copies each piece whole. */
    private void put(ByteBuffer octets) throws IOException {
        int end = octets.limit();
        try {
            while (octets.position() < end) {
                octets.limit(Math.min(end, octets.position() + CHUNK));
                channel.write(octets);
                if (octets.hasRemaining()) return;
            }
        } finally {
            octets.limit(end);
        }
    }

    private void flush() throws IOException {
        while (!waiting.isEmpty()) {
            ByteBuffer first = waiting.first();
            int before = first.remaining();
            put(first);
            boolean isWhole = !first.hasRemaining();
            if (before > first.remaining()) taken = loop.now();
            waiting.written(before - first.remaining());
            if (!isWhole) return;
        }
        loop.interest(key, SelectionKey.OP_WRITE, false);
        if (endsWhenDrained) channel.shutdownOutput();
        reader.drained();
    }

    /** Closes the own half as soon as everything is written. */
    void finish() {
        endsWhenDrained = true;
        if (isClosed || !waiting.isEmpty()) return;
        try {
            channel.shutdownOutput();
        } catch (IOException fault) {
            failSoon(fault.getMessage());
        }
    }

    /** Stops reading, or goes on. */
    void pause(boolean stop) {
        isPaused = stop;
        if (!isClosed && isConnected) loop.interest(key, SelectionKey.OP_READ, !stop);
    }

    void close() {
        if (isClosed) return;
        isClosed = true;
        waiting.clear();
        loop.close(channel);
    }

    private void fail(String reason) {
        if (isClosed) return;
        close();
        reader.broke(reason);
    }

    /** Fails after the present call, so that a writer is not called back. */
    private void failSoon(String reason) {
        loop.after(0, () -> fail(reason));
    }
}
