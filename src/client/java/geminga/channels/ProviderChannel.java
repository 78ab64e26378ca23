package geminga.channels;

import geminga.Match;
import geminga.protocol.ChannelKeys;
import geminga.protocol.Frame;
import geminga.protocol.Greeting;
import geminga.protocol.Handshake;
import geminga.protocol.Limits;
import geminga.protocol.SealedFrame;
import geminga.protocol.WireFrame;
import java.net.InetSocketAddress;

/** The channel from one provider: its keys, its handshake, and what is believed of its frames (src/client/CHANNELS.md). All calls are made with the loop's lock. */
final class ProviderChannel {
    /** The subscriber of a channel. */
    interface Owner {
        /** Whether another message may wait. If not, an inlet over TCP stops reading. */
        boolean hasRoom();

        /** Takes a message that is believed. With {@code isProved}, nobody but the provider can have sent it. */
        void deliver(ProviderChannel from, Frame message, boolean isProved);

        /** Counts a frame that was not believed. */
        void dropped();

        /** Keeps a frame that may be believed soon. */
        void keepEarly(InetSocketAddress from, WireFrame frame);

        /** Frames that were kept may be believed. */
        void deliverEarly(ProviderChannel channel);

        /** The provider has ended behind the message of that sequence. */
        void ended(ProviderChannel channel, long sequence, boolean isProved);

        /** The connection broke. Whether to make another one. */
        boolean broke(ProviderChannel channel);

        /** A frame of this subscriber; null if it can send no more. */
        byte[] write(ChannelKeys keys, Frame.Kind kind, byte[] payload);

        void problem(String text);

        /** The life of this subscriber. */
        long life();
    }

    private final Loop loop;
    private final Owner owner;
    private final Greeting greeting;
    private Match match;
    private ChannelKeys keys;
    private Inlet inlet = Inlet.NONE;
    /** Whether a sealed frame has been taken, after which no plain one is. */
    private boolean hasSealed;
    private boolean hasToldFull;
    private boolean isEnding;
    /** The end over UDP without a key, which anybody can forge. */
    private boolean hasEnd;
    private long endSequence;
    private long endUntil;

    ProviderChannel(Loop loop, Owner owner, Match match, ChannelKeys keys, long challenge) {
        this.loop = loop;
        this.owner = owner;
        this.match = match;
        this.keys = keys;
        greeting = new Greeting(challenge);
    }

    Match match() {
        return match;
    }

    Greeting greeting() {
        return greeting;
    }

    /** The keys, or null until the daemon has told them. */
    ChannelKeys keys() {
        return keys;
    }

    Inlet inlet() {
        return inlet;
    }

    void inlet(Inlet opened) {
        inlet = opened;
    }

    void changed(Match told) {
        match = told;
        isEnding = false;
    }

    /** Takes other keys. Whether the inlet is to be opened. */
    boolean keys(ChannelKeys told) {
        boolean isFirst = keys == null;
        keys = told;
        if (!isFirst) inlet.keysChanged();
        return isFirst;
    }

    /** Whether this side must say hello over UDP though the channel is no stream. */
    boolean mayBeSealed() {
        return keys != null && keys.hasRing();
    }

    /** The provider was withdrawn; messages on their way are still taken. */
    void ending() {
        isEnding = true;
        inlet.ending();
    }

    /** A hello, or the end of this listener; null if there is no frame left. */
    byte[] say(Frame.Kind kind) {
        return owner.write(keys, kind, greeting.hello(match.life()).write());
    }

    /** Takes a frame that has this life. {@code from} is null over TCP. False if it cannot be opened, so that nothing behind it in a stream is believed. */
    boolean take(WireFrame frame, InetSocketAddress from) {
        boolean isSealed = frame instanceof SealedFrame;
        Frame opened = keys == null || hasSealed && !isSealed ? null : keys.open(frame, SealedFrame.Direction.FORWARD);
        if (opened == null || opened.kind() == Frame.Kind.HELLO) {
            owner.dropped();
            return opened != null;
        }
        switch (opened.kind()) {
            case FLOOR, FULL -> answered(opened, isSealed);
            default -> {
                if (isSealed) return takeSealed(frame, opened, from);
                if (opened.kind() == Frame.Kind.MESSAGE) {
                    owner.deliver(this, opened, from == null);
                } else {
                    plainEnd(opened.sequence(), from == null);
                }
            }
        }
        return true;
    }

    /** Takes a message or an end that proves who made it, but not when. */
    private boolean takeSealed(WireFrame frame, Frame opened, InetSocketAddress from) {
        if (!greeting.hasFloor(keys.mode().takesPlain())) {
            owner.dropped();
            if (from == null) return false; // the connection is made again, and the floor comes first
            owner.keepEarly(from, frame);
            if (inlet instanceof MulticastInlet group) group.heardSealed(from, ((SealedFrame) frame).port());
            return true;
        }
        boolean isEnd = opened.kind() == Frame.Kind.END;
        if (!isEnd && !greeting.isFresh(opened.sequence())) {
            owner.dropped();
            return true;
        }
        hasSealed = true;
        if (isEnd) {
            owner.ended(this, opened.sequence(), true);
        } else {
            owner.deliver(this, opened, true);
        }
        return true;
    }

    private void plainEnd(long sequence, boolean isConnection) {
        if (isConnection || isEnding) {
            owner.ended(this, sequence, isConnection);
            return;
        }
        hasEnd = true;
        endSequence = sequence;
        endUntil = loop.now() + Limits.END_HINT;
    }

    /** The daemon tells that the provider is gone. Whether it has said its end shortly before, so that the channel ends. */
    boolean endsAsSaid() {
        boolean isSaid = hasEnd && endUntil - loop.now() > 0;
        hasEnd = false;
        if (isSaid) owner.ended(this, endSequence, false);
        return isSaid;
    }

    private void answered(Frame opened, boolean isSealed) {
        Handshake answer = Handshake.read(opened.payload());
        if (!greeting.isAnswer(answer, owner.life())) {
            owner.dropped();
            return;
        }
        if (opened.kind() == Frame.Kind.FULL) {
            greeting.refused();
            inlet.answered(false);
            if (!hasToldFull) owner.problem("the provider " + Endpoint.text(match.address(), match.port()) + " has no place for another consumer");
            hasToldFull = true;
            return;
        }
        hasSealed |= isSealed;
        boolean isAskedAgain = greeting.floor(answer, opened.sequence(), isSealed);
        if (greeting.isAccepted()) hasToldFull = false;
        inlet.answered(isAskedAgain);
        owner.deliverEarly(this);
    }

    boolean hasRoom() {
        return owner.hasRoom();
    }

    void dropped() {
        owner.dropped();
    }

    boolean broke() {
        return owner.broke(this);
    }
}
