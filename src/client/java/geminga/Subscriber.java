package geminga;

import geminga.channels.SubscriberChannel;
import geminga.protocol.Converter;
import java.nio.channels.ClosedChannelException;
import java.time.Duration;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Flow;
import java.util.function.UnaryOperator;

/**
 * A service that is asked for, and the channel from its providers. Messages are taken by {@link #receive}, or by one {@link Flow.Subscriber}, which gets as many as it
 * requests.
 *
 * <p>At most 1024 messages and 16 MiB wait, but always one. Then the eldest message that came over UDP is lost for a new one, and connections are
 * not read, which holds their providers back; {@link Message#missed} tells what was lost. Frames that a provider sends over UDP before the daemon has named it wait for a second, 64 of them and 256 KiB at most.
 */
public final class Subscriber implements AutoCloseable, Flow.Publisher<Message> {
    private final Node node;
    private final SubscriberChannel channel;
    private final Set<String> unconverted = new HashSet<>();
    private Delivery delivery;
    private long received;
    private long failed;

    Subscriber(Node node, SubscriberChannel channel) {
        this.node = node;
        this.channel = channel;
    }

    /**
     * Waits for a message.
     *
     * @return the next one
     * @throws InterruptedException if the thread is interrupted
     * @throws RefusedException if the daemon refused the request
     * @throws ClosedChannelException if the subscriber is closed, perhaps meanwhile
     */
    public Message receive() throws InterruptedException, ClosedChannelException, RefusedException {
        while (true) {
            Optional<Message> message = receive(Duration.ofDays(10_000));
            if (message.isPresent()) return message.get();
        }
    }

    /**
     * Waits for a message.
     *
     * @param atMost how long
     * @return the next one, or nothing
     * @throws InterruptedException if the thread is interrupted
     * @throws RefusedException if the daemon refused the request
     * @throws ClosedChannelException if the subscriber is closed, perhaps meanwhile
     */
    public Optional<Message> receive(Duration atMost) throws InterruptedException, ClosedChannelException, RefusedException {
        long begin = System.nanoTime();
        while (true) {
            if (node.locking(() -> delivery != null)) throw new IllegalStateException("the messages go to a Flow.Subscriber");
            Duration left = atMost.minusNanos(System.nanoTime() - begin);
            node.await(() -> channel.hasMessage() || channel.isClosed(), left.isNegative() ? Duration.ZERO : left);
            Message message = node.locking(channel::poll);
            if (message == null) {
                if (channel.refusal() != null) throw channel.refusal();
                if (node.locking(channel::isClosed)) throw new ClosedChannelException();
                return Optional.empty();
            }
            Message converted = take(message);
            if (converted != null) return Optional.of(converted);
        }
    }

    /** The converted message; null if it cannot be converted. Without the lock. */
    Message take(Message message) {
        byte[] payload = message.payload();
        try {
            var provider = message.provider();
            payload = Converter.apply(channel.request().conversions(), provider.conversion(), provider.via(), payload);
        } catch (Exception fault) {
            boolean isNew = node.locking(() -> {
                ++failed;
                return unconverted.size() < 1024 && unconverted.add(message.provider().lifeText());
            });
            if (isNew) problem(fault.getMessage());
            return null;
        }
        node.locking(() -> ++received);
        return payload == message.payload() ? message : new Message(payload, message.life(), message.sequence(), message.missed(), message.provider());
    }

    /**
     * Gives all further messages to a taker, on the thread that serves the node. There can be one at a time: another one gets an {@link IllegalStateException}.
     *
     * @param taker requests and takes them
     */
    @Override
    public void subscribe(Flow.Subscriber<? super Message> taker) {
        Delivery made = new Delivery(node, this, channel, taker);
        boolean isFirst = node.locking(() -> {
            if (delivery != null) return false;
            delivery = made;
            channel.onMessage(() -> node.tell(made::pump));
            return true;
        });
        made.begin(isFirst);
    }

    void problem(String text) {
        node.locking(() -> {
            channel.problem(text);
            return null;
        });
    }

    /** Forgets a taker that wants no more messages. */
    void released(Delivery was) {
        node.locking(() -> {
            if (delivery == was) {
                delivery = null;
                channel.onMessage(() -> { });
            }
            return null;
        });
    }

    /**
     * Changes the request, as {@code subscriber.modify(request -> request.where("rate > 10"))}. Mode, port, address and protocol cannot be changed.
     *
     * @param change makes the new request from the one that holds
     * @return completes when the daemon has accepted it, or fails with {@link RefusedException}, and the former request holds; on the thread that serves the node
     */
    public CompletionStage<Void> modify(UnaryOperator<Request> change) {
        return node.locking(() -> channel.modify(change.apply(channel.request())));
    }

    /** {@return the request, with the port and the life that the library states} */
    public Request request() {
        return channel.request();
    }

    /** {@return the life of this subscriber} */
    public long life() {
        return channel.life();
    }

    /** {@return completes when the daemon has accepted the request, or fails with {@link RefusedException}; on the thread that serves the node} */
    public CompletionStage<Void> taken() {
        return channel.taken().minimalCompletionStage();
    }

    /**
     * Waits until the daemon has accepted the request.
     *
     * @param atMost how long
     * @return whether it has
     * @throws RefusedException if it refused it
     * @throws InterruptedException if the thread is interrupted
     */
    public boolean awaitTaken(Duration atMost) throws RefusedException, InterruptedException {
        return node.awaitTaken(channel, atMost);
    }

    /** {@return how many messages the application has taken} */
    public long received() {
        return node.locking(() -> received);
    }

    /** {@return how many messages are missing, those lost in a full inbox with them} */
    public long missed() {
        return node.locking(channel::missedCount);
    }

    /** {@return the number of datagrams and frames that were not believed, were not new, or could not be converted} */
    public long dropped() {
        return node.locking(() -> channel.droppedCount() + failed);
    }

    /** Withdraws the request and closes its sockets. A taker gets {@link Flow.Subscriber#onComplete}. */
    @Override
    public void close() {
        node.locking(() -> {
            channel.close();
            return null;
        });
    }
}
