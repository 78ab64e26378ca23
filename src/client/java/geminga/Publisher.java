package geminga;

import geminga.channels.PublisherChannel;
import java.io.IOException;
import java.time.Duration;
import java.util.Objects;
import java.util.concurrent.CompletionStage;
import java.util.function.UnaryOperator;

/** A service that is offered, and the channel to its consumers. */
public final class Publisher implements AutoCloseable {
    private final Node node;
    private final PublisherChannel channel;

    Publisher(Node node, PublisherChannel channel) {
        this.node = node;
        this.channel = channel;
    }

    /**
     * Sends one message to every consumer, and never waits. Without a consumer it touches no socket.
     *
     * <p>A TCP consumer for which 4 MiB wait is left out; {@link #leftOut} counts that, and {@link #awaitRoom} waits for room.
     *
     * @param payload up to 65 000 octets over UDP, 16 MiB over TCP; it may be changed when this returns
     * @return whether there was a consumer
     * @throws NullPointerException if there is no payload
     * @throws MessageTooLargeException if the payload is larger
     * @throws RefusedException if the daemon refused the offer
     * @throws java.nio.channels.ClosedChannelException if the publisher is closed
     */
    public boolean send(byte[] payload) throws IOException {
        return channel.send(Objects.requireNonNull(payload, "payload: an array of octets, not null"));
    }

    /**
     * Waits for a consumer.
     *
     * @param atMost how long
     * @return whether there is one
     * @throws InterruptedException if the thread is interrupted
     */
    public boolean awaitConsumer(Duration atMost) throws InterruptedException {
        return node.await(channel::isHeard, atMost);
    }

    /**
     * Waits until every connected consumer has room for a message of this size.
     *
     * @param octets its size
     * @param atMost how long
     * @return whether there is room
     * @throws InterruptedException if the thread is interrupted
     */
    public boolean awaitRoom(int octets, Duration atMost) throws InterruptedException {
        return node.await(() -> channel.hasRoom(octets), atMost);
    }

    /**
     * Changes the offer, as {@code publisher.modify(offer -> offer.attribute("rate", "15"))}. Mode, port, address and protocol cannot be changed.
     *
     * @param change makes the new offer from the one that holds
     * @return completes when the daemon has accepted it, or fails with {@link RefusedException}, and the former offer holds; on the thread that serves the node
     */
    public CompletionStage<Void> modify(UnaryOperator<Offer> change) {
        return node.locking(() -> channel.modify(change.apply(channel.offer())));
    }

    /** {@return the offer, with the port where it is reached} */
    public Offer offer() {
        return node.locking(channel::offer);
    }

    /** {@return the life of this publisher, which its messages carry} */
    public long life() {
        return channel.life();
    }

    /** {@return completes when the daemon has accepted the offer, or fails with {@link RefusedException}; on the thread that serves the node} */
    public CompletionStage<Void> taken() {
        return channel.taken().minimalCompletionStage();
    }

    /**
     * Waits until the daemon has accepted the offer.
     *
     * @param atMost how long
     * @return whether it has
     * @throws RefusedException if it refused it
     * @throws InterruptedException if the thread is interrupted
     */
    public boolean awaitTaken(Duration atMost) throws RefusedException, InterruptedException {
        return node.awaitTaken(channel, atMost);
    }

    /** {@return how many messages were sent while there was a consumer} */
    public long sent() {
        return node.locking(channel::sent);
    }

    /** {@return how often a message was left out for a consumer that did not read or could not be reached} */
    public long leftOut() {
        return node.locking(channel::leftOutCount);
    }

    /** {@return the number of datagrams and connections that were not believed} */
    public long dropped() {
        return node.locking(channel::droppedCount);
    }

    /** Withdraws the offer. TCP consumers get all messages that wait; one that takes nothing for 5 s is not waited for. An interruption ends the waiting and stays set. */
    @Override
    public void close() {
        node.locking(() -> {
            channel.end();
            return null;
        });
        node.settle(channel::hasEnded);
        node.locking(() -> {
            channel.close();
            return null;
        });
    }
}
