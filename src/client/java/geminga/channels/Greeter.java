package geminga.channels;

import geminga.protocol.AnswerRate;
import geminga.protocol.Cookies;
import geminga.protocol.Frame;
import geminga.protocol.Handshake;
import geminga.protocol.PublisherFrames;
import geminga.protocol.Said;
import geminga.protocol.SealedFrame;
import geminga.protocol.WireFrame;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.security.SecureRandom;

/**
 * A publisher's part of the handshake over UDP (src/client/CHANNELS.md, "The handshake"): nothing is sent to an address before it has given back a cookie, but floors of the size
 * of a hello, and a limited number of them.
 */
final class Greeter {
    /** The consumers of an outlet. */
    interface Guests {
        /** The last hello of the consumer at this address, of this life; null if there is none. */
        Said known(InetSocketAddress from, long life);

        /** A consumer that was accepted has said hello again. */
        void renewed(InetSocketAddress from, long life);

        /** Whether this life may be accepted yet. */
        boolean isExpected(long life);

        /** A consumer shows that it receives at this address. What it says is written there; null if it has no place. */
        Said accept(InetSocketAddress from, long life);

        /** The consumer leaves. */
        void left(InetSocketAddress from, long life);
    }

    private final Loop loop;
    private final Outlet.Owner owner;
    private final PublisherFrames frames;
    private final Guests guests;
    private final Cookies cookies;
    private final AnswerRate rate;

    Greeter(Loop loop, Outlet.Owner owner, PublisherFrames frames, Guests guests) {
        this.loop = loop;
        this.owner = owner;
        this.frames = frames;
        this.guests = guests;
        byte[] secret = new byte[Cookies.SECRET];
        new SecureRandom().nextBytes(secret);
        cookies = new Cookies(secret, loop.now());
        rate = new AnswerRate(loop.now());
    }

    /** Takes a datagram that came to the publisher's socket. */
    void read(Datagrams socket, InetSocketAddress from, ByteBuffer datagram) {
        WireFrame frame = WireFrame.ofDatagram(datagram);
        boolean isForUs = frame != null && (frame.kind() == Frame.Kind.HELLO || frame.kind() == Frame.Kind.END);
        Frame said = isForUs ? frames.open(frame) : null;
        Handshake handshake = said == null ? null : Handshake.read(said.payload());
        if (handshake == null || handshake.life() != frames.life()) {
            owner.dropped();
            return;
        }
        Said known = guests.known(from, frame.life());
        // A consumer that said a plain hello first proves by a cookie that its sealed one is not recorded.
        if (known != null && !known.isSealed() && frame instanceof SealedFrame) known = null;
        boolean isNew = known == null || known.take(frame, handshake.challenge());
        if (!isNew || known == null && frame.kind() == Frame.Kind.END) {
            owner.dropped();
        } else if (frame.kind() == Frame.Kind.END) {
            guests.left(from, frame.life());
        } else if (known != null) {
            guests.renewed(from, frame.life());
            if (rate.take(true, loop.now())) send(socket, from, Frame.Kind.FLOOR, new Handshake(frame.life(), handshake.challenge(), 0));
        } else {
            welcome(socket, from, frame, handshake);
        }
    }

    private void welcome(Datagrams socket, InetSocketAddress from, WireFrame hello, Handshake handshake) {
        long life = hello.life();
        long challenge = handshake.challenge();
        if (!cookies.isRight(handshake.cookie(), from, life, challenge, loop.now())) {
            answer(socket, from, Frame.Kind.FLOOR, new Handshake(life, challenge, cookies.make(from, life, challenge, loop.now())));
            return;
        }
        // It is accepted when it says hello again. An answer would make it say hello at once, in a circle.
        if (!guests.isExpected(life)) return;
        Said said = guests.accept(from, life);
        if (said != null) said.take(hello, challenge);
        answer(socket, from, said == null ? Frame.Kind.FULL : Frame.Kind.FLOOR, new Handshake(life, challenge, 0));
    }

    /** Answers, where the rate of answers allows it. */
    void answer(Datagrams socket, InetSocketAddress to, Frame.Kind kind, Handshake handshake) {
        if (rate.take(false, loop.now())) send(socket, to, kind, handshake);
    }

    private void send(Datagrams socket, InetSocketAddress to, Frame.Kind kind, Handshake handshake) {
        byte[] octets = frames.answer(kind, handshake);
        if (octets != null) socket.send(ByteBuffer.wrap(octets), to);
    }
}
