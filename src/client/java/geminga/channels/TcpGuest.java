package geminga.channels;

import geminga.protocol.Frame;
import geminga.protocol.FrameReader;
import geminga.protocol.Handshake;
import geminga.protocol.Life;
import geminga.protocol.Limits;
import geminga.protocol.PublisherFrames;
import geminga.protocol.Said;
import geminga.protocol.SealedFrame;
import geminga.protocol.SendQueue;
import geminga.protocol.WireFrame;
import java.io.IOException;
import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.util.random.RandomGenerator;

/** One connection to a publisher, of a consumer or of a stranger: its handshake, and what waits for it. */
final class TcpGuest implements Stream.Reader {
    /** The outlet of a connection. */
    interface Host {
        /** Its hello was accepted. */
        void introduced(TcpGuest guest);

        /** It is gone, or said what is not believed, or has been silent for too long. */
        void left(TcpGuest guest);

        /** Counts a frame that was not believed. */
        void dropped();

        /** It has room again. */
        void changed();
    }

    private final Loop loop;
    private final Host host;
    private final PublisherFrames publisher;
    private final RandomGenerator chance;
    private final FrameReader frames = new FrameReader(Handshake.OCTETS);
    private final Stream stream;
    private final Said said = new Said();
    private Loop.Timer patience;
    /** The hello that came before the keys were known. */
    private WireFrame pending;
    private long cookie;
    private long waitingBefore;
    private boolean isIntroduced;
    private boolean isFloorDue;
    private boolean isLeftOut;
    private boolean isLeftOutAnew;
    private boolean isClosed;

    TcpGuest(Loop loop, Host host, PublisherFrames publisher, RandomGenerator chance, SocketChannel channel, SendQueue.Pool pool) throws IOException {
        this.loop = loop;
        this.host = host;
        this.publisher = publisher;
        this.chance = chance;
        try {
            stream = Stream.accepted(loop, channel, this, pool);
        } catch (IOException fault) {
            channel.close();
            throw fault;
        }
        patience = loop.after(Limits.UNKNOWN_CONNECTION, () -> host.left(this));
    }

    /** Its last hello that was believed. */
    Said said() {
        return said;
    }

    /** The address by which places are shared. */
    InetAddress host() {
        return stream.peer() == null ? InetAddress.getLoopbackAddress() : stream.peer().getAddress();
    }

    /** Its life, for texts. */
    String name() {
        return Life.write(said.life());
    }

    @Override
    public void connected() {}

    @Override
    public void read(ByteBuffer octets) {
        for (WireFrame frame = frames.next(octets); frame != null && !isClosed; frame = frames.next(octets)) take(frame);
        if (!frames.isBroken() || isClosed) return;
        host.dropped();
        host.left(this);
    }

    private void take(WireFrame frame) {
        if (publisher.keys() == null) {
            if (pending == null) pending = frame;
            return;
        }
        if (isAsked() && frame instanceof Frame) {
            loop.after(Limits.ASK_AGAIN, this::ask); // its host does not seal yet
            return;
        }
        boolean isForPublisher = frame.kind() == Frame.Kind.HELLO || frame.kind() == Frame.Kind.END;
        Frame opened = isForPublisher ? publisher.open(frame) : null;
        if (opened != null && frame.kind() == Frame.Kind.END) {
            host.left(this);
            return;
        }
        Handshake handshake = opened == null ? null : Handshake.read(opened.payload());
        boolean isSame = said.life() == 0 || said.life() == frame.life();
        boolean isBelieved = handshake != null && handshake.life() == publisher.life() && isSame;
        if (isBelieved && isIntroduced && frame instanceof SealedFrame && !said.isSealed()) {
            proves(frame, handshake);
        } else if (!isBelieved || !said.take(frame, handshake.challenge())) {
            host.dropped();
            host.left(this);
        } else if (!isIntroduced) {
            introduce(frame instanceof SealedFrame || publisher.seals(), handshake);
        }
    }

    /** Without keys the first hello is enough; otherwise it has to give a cookie back, which no recorded hello has. */
    private void introduce(boolean isSealed, Handshake handshake) {
        if (isSealed && cookie == 0) {
            cookie = Life.draw(chance);
            answer(Frame.Kind.FLOOR, cookie);
            return;
        }
        if (isSealed && handshake.cookie() != cookie) {
            host.dropped();
            host.left(this);
            return;
        }
        isIntroduced = true;
        isFloorDue = isSealed;
        host.introduced(this);
    }

    /** A consumer that said a plain hello says a sealed one: it counts with the cookie that it was asked with. */
    private void proves(WireFrame hello, Handshake handshake) {
        boolean isRight = cookie != 0 && handshake.cookie() == cookie && handshake.challenge() == said.challenge() && said.take(hello, handshake.challenge());
        if (!isRight) {
            host.dropped();
            return;
        }
        patience.cancel();
        answer(Frame.Kind.FLOOR, 0);
    }

    /** Plain frames are taken no more: a consumer that said a plain hello has to say a sealed one, and has some time for it. */
    void askForSealed() {
        patience.cancel();
        patience = loop.after(Limits.UNKNOWN_CONNECTION, () -> {
            if (isAsked()) host.left(this);
        });
        ask();
    }

    private boolean isAsked() {
        return isIntroduced && !isClosed && !said.isSealed() && !publisher.takesPlain();
    }

    private void ask() {
        if (!isAsked()) return;
        cookie = Life.draw(chance);
        answer(Frame.Kind.FLOOR, cookie);
    }

    /** It is a consumer from now on. */
    void admitted() {
        patience.cancel();
        if (isFloorDue) answer(Frame.Kind.FLOOR, 0);
    }

    /** The keys are known, or are other ones. */
    void keysChanged() {
        WireFrame first = pending;
        pending = null;
        if (first != null) take(first);
    }

    /** Says a floor or a full. */
    void answer(Frame.Kind kind, long withCookie) {
        byte[] octets = publisher.answer(kind, new Handshake(said.life(), said.challenge(), withCookie));
        if (octets != null) stream.write(octets);
    }

    void sayFull() {
        answer(Frame.Kind.FULL, 0);
    }

    /** Writes a message, or leaves it out where too much waits. Whether it was written. */
    boolean send(SendQueue.Shared frame) {
        boolean hasRoom = stream.hasRoom(frame.size());
        isLeftOutAnew = !hasRoom && !isLeftOut;
        isLeftOut = !hasRoom;
        if (hasRoom) stream.write(frame);
        return hasRoom;
    }

    /** Whether the message before the last one was not left out, but the last one was. */
    boolean isLeftOutAnew() {
        return isLeftOutAnew;
    }

    void write(byte[] octets) {
        stream.write(octets);
    }

    boolean hasRoom(int octets) {
        return stream.hasRoom((publisher.seals() ? SealedFrame.HEADER + SealedFrame.TAG : Frame.HEADER) + octets);
    }

    long waiting() {
        return stream.waiting();
    }

    long taken() {
        return stream.taken();
    }

    /** Reads what has come already. */
    void look() {
        if (!isClosed) stream.look();
    }

    @Override
    public void drained() {
        host.changed();
    }

    @Override
    public void finished() {
        host.left(this);
    }

    @Override
    public void broke(String reason) {
        host.left(this);
    }

    /** Writes the frames that wait, and closes the own half. It is left if it takes nothing for a while. */
    void finish() {
        patience.cancel();
        stream.finish();
        waitingBefore = stream.waiting();
        patience = loop.after(Limits.CLOSING, this::lookAgain);
    }

    private void lookAgain() {
        boolean hasTaken = stream.waiting() < waitingBefore;
        waitingBefore = stream.waiting();
        if (hasTaken) {
            patience = loop.after(Limits.CLOSING, this::lookAgain);
        } else {
            host.left(this);
        }
    }

    void close() {
        isClosed = true;
        patience.cancel();
        stream.close();
    }
}
