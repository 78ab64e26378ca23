package geminga;

import geminga.channels.DaemonLink;
import geminga.channels.Endpoint;
import geminga.channels.Loop;
import geminga.channels.PublisherChannel;
import geminga.channels.Stated;
import geminga.channels.SubscriberChannel;
import geminga.protocol.Life;
import java.io.IOException;
import java.nio.channels.ClosedChannelException;
import java.security.SecureRandom;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.random.RandomGenerator;

/**
 * One program's connection to its daemon, and the sockets of all its channels. The daemon may start later, end and come back: the node connects again and states its
 * requests again, and channels go on meanwhile.
 *
 * <p><b>Threads.</b> A node starts none. With an executor ({@link #open(Options, Executor)}) one task there serves its selector until the node is closed. Without one
 * ({@link #open(Options)}) the calls that wait serve it: {@link #run}, {@link #poll}, {@link #awaitConnected}, {@link Subscriber#receive}, the other methods that take a
 * duration, and {@link #close}; nothing happens between such calls. All methods may be called from any thread. Events come on the thread that serves, one after the other and
 * without a lock held. A listener may call everything but should not block.
 *
 * <p><b>Interruption.</b> A call that waits ends with {@link InterruptedException}, and no socket is closed by that. If the task of an executor is interrupted, it closes the node.
 */
public final class Node implements AutoCloseable {
    private final Loop loop;
    private final DaemonLink daemon;
    private final RandomGenerator chance = new SecureRandom();
    private final List<PublisherChannel> publishers = new ArrayList<>();
    private final List<SubscriberChannel> subscribers = new ArrayList<>();
    private final AtomicBoolean isClosing = new AtomicBoolean();

    private Node(Options options) throws IOException {
        loop = new Loop(options.listener(), options.log());
        try {
            daemon = new DaemonLink(loop, Endpoint.of(options.connect()), options.name(), chance);
        } catch (RuntimeException fault) {
            loop.close();
            throw fault;
        }
        daemon.open();
    }

    /**
     * Opens a node that is served by the calls that wait.
     *
     * @param options its name and its daemon, which need not be there yet
     * @return the node
     * @throws IOException if the system gives no selector
     */
    public static Node open(Options options) throws IOException {
        return new Node(options);
    }

    /**
     * Opens a node that is served by one task of an executor until it is closed.
     *
     * @param options its name and its daemon, which need not be there yet
     * @param executor runs the task on a thread of its own, as {@link #newThread} does
     * @return the node
     * @throws IOException if the system gives no selector
     */
    public static Node open(Options options, Executor executor) throws IOException {
        Node node = new Node(options);
        executor.execute(() -> {
            try {
                node.loop.run();
            } catch (InterruptedException isAskedToEnd) {
                Thread.currentThread().interrupt();
                node.close();
            }
        });
        return node;
    }

    /**
     * Starts one thread, which does not keep the program alive: the simplest executor for {@link #open(Options, Executor)}.
     *
     * @param task the task of the thread
     */
    public static void newThread(Runnable task) {
        Thread thread = new Thread(task, "geminga");
        thread.setDaemon(true);
        thread.start();
    }

    /**
     * Offers a service with a channel.
     *
     * @param offer the service, and how it is reached
     * @return the publisher; {@link Publisher#taken} tells the answer of the daemon
     * @throws IOException if the stated port is taken
     */
    public Publisher publish(Offer offer) throws IOException {
        return publish(offer, event -> { });
    }

    /**
     * Offers a service with a channel, and tells a listener of its consumers.
     *
     * @param offer the service, and how it is reached
     * @param listener told of each consumer; not for {@link Mode#STREAM}, where the daemon names none
     * @return the publisher; {@link Publisher#taken} tells the answer of the daemon
     * @throws IOException if the stated port is taken
     */
    public Publisher publish(Offer offer, Consumer<Event.ConsumerEvent> listener) throws IOException {
        return locked(() -> {
            PublisherChannel channel = new PublisherChannel(loop, daemon, offer, Life.draw(chance), chance, listener);
            publishers.removeIf(PublisherChannel::isClosed);
            publishers.add(channel);
            Publisher made = new Publisher(this, channel);
            channel.owner(made);
            return made;
        });
    }

    /**
     * Asks for a service and receives its messages.
     *
     * @param request the request
     * @return the subscriber; {@link Subscriber#taken} tells the answer of the daemon
     * @throws IOException if the stated port is taken
     */
    public Subscriber subscribe(Request request) throws IOException {
        return subscribe(request, event -> { });
    }

    /**
     * Asks for a service, receives its messages, and tells a listener of its providers.
     *
     * @param request the request
     * @param listener told of each provider
     * @return the subscriber; {@link Subscriber#taken} tells the answer of the daemon
     * @throws IOException if the stated port is taken
     */
    public Subscriber subscribe(Request request, Consumer<Event.ProviderEvent> listener) throws IOException {
        return locked(() -> {
            SubscriberChannel channel = new SubscriberChannel(loop, daemon, request, Life.draw(chance), chance, listener);
            subscribers.removeIf(SubscriberChannel::isClosed);
            subscribers.add(channel);
            Subscriber made = new Subscriber(this, channel);
            channel.owner(made);
            return made;
        });
    }

    /** {@return whether the daemon is there now} */
    public boolean isConnected() {
        loop.lock();
        try {
            return daemon.isUp();
        } finally {
            loop.unlock();
        }
    }

    /**
     * Waits for the daemon.
     *
     * @param atMost how long
     * @return whether it is there
     * @throws InterruptedException if the thread is interrupted
     */
    public boolean awaitConnected(Duration atMost) throws InterruptedException {
        return await(daemon::isUp, atMost);
    }

    /**
     * Serves the node until it is closed.
     *
     * @throws InterruptedException if the thread is interrupted; the node stays open
     */
    public void run() throws InterruptedException {
        loop.run();
    }

    /**
     * Serves the node for so long, at least once.
     *
     * @param time how long
     * @throws InterruptedException if the thread is interrupted
     */
    public void poll(Duration time) throws InterruptedException {
        loop.poll();
        await(() -> false, time);
    }

    /**
     * Withdraws everything and says goodbye to the daemon. TCP consumers get all messages that wait; one that takes nothing for 5 s is not waited for. An interruption ends the waiting and stays set.
     */
    @Override
    public void close() {
        if (!isClosing.compareAndSet(false, true)) return;
        List<PublisherChannel> ending = locking(() -> {
            subscribers.forEach(SubscriberChannel::close);
            publishers.forEach(PublisherChannel::end);
            daemon.close();
            return List.copyOf(publishers);
        });
        settle(() -> daemon.isGone() && ending.stream().allMatch(PublisherChannel::hasEnded));
        locking(() -> {
            ending.forEach(PublisherChannel::close);
            return null;
        });
        loop.close();
    }

    /** Waits for a condition that comes by itself, unless the thread is interrupted. */
    void settle(BooleanSupplier condition) {
        try {
            loop.await(condition, Long.MAX_VALUE);
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
        }
    }

    boolean await(BooleanSupplier condition, Duration atMost) throws InterruptedException {
        return loop.await(condition, atMost.compareTo(Duration.ofDays(1000)) > 0 ? Long.MAX_VALUE : atMost.toNanos());
    }

    /** Waits until the daemon has accepted what was stated. Returns whether it has; throws its refusal. */
    boolean awaitTaken(Stated stated, Duration atMost) throws RefusedException, InterruptedException {
        await(() -> stated.isTaken() || stated.refusal() != null, atMost);
        if (stated.refusal() != null) throw stated.refusal();
        return locking(stated::isTaken);
    }

    /** Runs an action with the lock, unless the node is closed. */
    private <T> T locked(Opening<T> action) throws IOException {
        loop.lock();
        try {
            if (isClosing.get()) throw new ClosedChannelException();
            return action.open();
        } finally {
            loop.unlock();
        }
    }

    <T> T locking(Supplier<T> action) {
        loop.lock();
        try {
            return action.get();
        } finally {
            loop.unlock();
        }
    }

    /** Has a notice run by the thread that serves. With the lock. */
    void tell(Runnable notice) {
        loop.tell(notice);
    }

    private interface Opening<T> {
        T open() throws IOException;
    }
}
