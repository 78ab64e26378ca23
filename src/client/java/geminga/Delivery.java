package geminga;

import geminga.channels.SubscriberChannel;
import java.util.Objects;
import java.util.concurrent.Flow;

/** Gives the messages of one subscriber to its taker, as many as it requests, one after the other (Reactive Streams, rules 1.3, 2.7, 3.3 and 3.9). */
final class Delivery implements Flow.Subscription {
    private final Node node;
    private final Subscriber subscriber;
    private final SubscriberChannel channel;
    private final Flow.Subscriber<? super Message> taker;
    private long demand;
    private Throwable fault;
    private volatile boolean hasBegun;
    private volatile boolean isDone;
    private boolean isPumping;

    Delivery(Node node, Subscriber subscriber, SubscriberChannel channel, Flow.Subscriber<? super Message> taker) {
        this.node = node;
        this.subscriber = subscriber;
        this.channel = channel;
        this.taker = Objects.requireNonNull(taker);
    }

    void begin(boolean isFirst) {
        if (!isFirst) {
            isDone = true;
            taker.onSubscribe(this);
            taker.onError(new IllegalStateException("somebody takes the messages already"));
            return;
        }
        taker.onSubscribe(this);
        hasBegun = true;
        later();
    }

    @Override
    public void request(long more) {
        node.locking(() -> {
            if (isDone) return null;
            if (more <= 0) fault = new IllegalArgumentException("rule 3.9: request(" + more + ")");
            demand = more > Long.MAX_VALUE - demand ? Long.MAX_VALUE : demand + Math.max(more, 0);
            return null;
        });
        later();
    }

    @Override
    public void cancel() {
        isDone = true;
        subscriber.released(this);
    }

    private void later() {
        node.locking(() -> {
            node.tell(this::pump);
            return null;
        });
    }

    /** Gives the messages that are here and requested; on the thread that serves. */
    void pump() {
        if (isPumping || !hasBegun) return;
        isPumping = true;
        try {
            for (Message message = next(); message != null; message = next()) {
                Message converted = subscriber.take(message);
                if (converted == null || isDone) continue;
                node.locking(() -> --demand);
                taker.onNext(converted);
            }
        } catch (RuntimeException thrown) {
            cancel();
            subscriber.problem("a taker of messages threw " + thrown);
        } finally {
            isPumping = false;
        }
        end();
    }

    private Message next() {
        return node.locking(() -> isDone || fault != null || demand == 0 ? null : channel.poll());
    }

    private void end() {
        boolean isOver = node.locking(() -> !isDone && (fault != null || channel.isClosed()));
        if (!isOver) return;
        cancel();
        Throwable why = fault != null ? fault : channel.refusal();
        if (why != null) {
            taker.onError(why);
        } else {
            taker.onComplete();
        }
    }
}
