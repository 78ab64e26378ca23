package geminga;

import geminga.channels.PublisherChannel;
import java.io.IOException;
import java.time.Duration;
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
     * <p>A consumer over TCP for which 4 MiB wait misses it; {@link #leftOut} counts that, and {@link #awaitRoom} waits before.
     *
     * @param payload up to 65 000 octets over UDP, 16 MiB over TCP; it may be changed when this returns
     * @return whether there was a consumer
     * @throws MessageTooLargeException where the payload is larger
     * @throws RefusedException where the daemon refused the offer
     * @throws java.nio.channels.ClosedChannelException where the publisher is closed
     */
    public boolean send(byte[] payload) throws IOException {
        return channel.send(payload);
    }

    /**
     * Waits for a consumer.
     *
     * @param atMost how long
     * @return whether there is one
     * @throws InterruptedException where the thread is interrupted
     */
    public boolean awaitConsumer(Duration atMost) throws InterruptedException {
        return node.await(channel::isHeard, atMost);
    }

    /**
     * Waits until a message of that size would be left out for no consumer that is connected.
     *
     * @param octets its size
     * @param atMost how long
     * @return whether there is room
     * @throws InterruptedException where the thread is interrupted
     */
    public boolean awaitRoom(int octets, Duration atMost) throws InterruptedException {
        return node.await(() -> channel.hasRoom(octets), atMost);
    }

    /**
     * Changes the offer, as {@code publisher.modify(offer -> offer.attribute("rate", "15"))}. Mode, port, address and protocol stay.
     *
     * @param change makes the new offer from the one that holds
     * @return completes when the daemon has taken it, or fails with {@link RefusedException}, and the former offer holds; on the thread that serves the node
     */
    public CompletionStage<Void> modify(UnaryOperator<Offer> change) {
        return node.locking(() -> channel.modify(change.apply(channel.offer())));
    }

    /** {@return what is offered, with the port where it is reached} */
    public Offer offer() {
        return node.locking(channel::offer);
    }

    /** {@return the life of this publisher, which each of its messages carries} */
    public long life() {
        return channel.life();
    }

    /** {@return completes when the daemon has taken the offer, which may be there later, or fails with {@link RefusedException}; on the thread that serves the node} */
    public CompletionStage<Void> taken() {
        return channel.taken().minimalCompletionStage();
    }

    /**
     * Waits until the daemon has taken the offer.
     *
     * @param atMost how long
     * @return whether it has
     * @throws RefusedException where it refused it
     * @throws InterruptedException where the thread is interrupted
     */
    public boolean awaitTaken(Duration atMost) throws RefusedException, InterruptedException {
        node.await(() -> channel.isTaken() || channel.refusal() != null, atMost);
        if (channel.refusal() != null) throw channel.refusal();
        return node.locking(channel::isTaken);
    }

    /** {@return how many messages it was given while it had a consumer} */
    public long sent() {
        return node.locking(channel::sent);
    }

    /** {@return how often a message was left out for a consumer that did not read, or could not be reached} */
    public long leftOut() {
        return node.locking(channel::leftOutCount);
    }

    /** {@return what came to its sockets and was no frame, or from nobody who is known} */
    public long dropped() {
        return node.locking(channel::droppedCount);
    }

    /** Withdraws the offer. Consumers over TCP are given what still waits for them, until one takes nothing for 5 s; an interruption ends the waiting and stays set. */
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
