package geminga.channels;

import geminga.Event;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.SelectableChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.ArrayDeque;
import java.util.PriorityQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * One selector with its timers, and the notices to the application. The thread that holds {@code driver} serves the sockets: that of an executor until the node is closed, or
 * else a caller that waits. {@code lock} guards all state of a node; notices run without it.
 */
public final class Loop {
    /** The user of a socket, called with the lock when the socket is ready. */
    interface Ready {
        void ready(SelectionKey key);
    }

    /** An action that is due once. */
    final class Timer implements Comparable<Timer> {
        private final long due;
        private Runnable action;

        private Timer(long due, Runnable action) {
            this.due = due;
            this.action = action;
        }

        void cancel() {
            action = null;
            timers.remove(this);
        }

        @Override
        public int compareTo(Timer other) {
            return Long.compare(due - other.due, 0);
        }
    }

    private static final long LONGEST = TimeUnit.HOURS.toNanos(1);

    final ReentrantLock lock = new ReentrantLock();
    /** The buffers of one read and one write of a socket; guarded by the lock. */
    final ByteBuffer incoming = ByteBuffer.allocateDirect(128 * 1024);
    final ByteBuffer outgoing = ByteBuffer.allocateDirect(128 * 1024);
    private final ReentrantLock driver = new ReentrantLock();
    private final Condition changed = lock.newCondition();
    private final Selector selector;
    private final PriorityQueue<Timer> timers = new PriorityQueue<>();
    private final ArrayDeque<Runnable> notices = new ArrayDeque<>();
    private final Consumer<Event> listener;
    private final Consumer<String> log;
    private volatile boolean isClosed;

    /** With the node's listener, and the application's function for lines of the log. */
    public Loop(Consumer<Event> listener, Consumer<String> log) throws IOException {
        this.listener = listener;
        this.log = log;
        selector = Selector.open();
    }

    long now() {
        return System.nanoTime();
    }

    /** The octets in the buffer for writing, which is void after the next call. With the lock. */
    ByteBuffer outgoing(byte[] octets) {
        return outgoing.clear().put(octets).flip();
    }

    /** Serves a socket from now on. With the lock. */
    SelectionKey register(SelectableChannel channel, int operations, Ready ready) {
        try {
            SelectionKey key = channel.register(selector, operations, ready);
            wakeUp();
            return key;
        } catch (ClosedChannelException own) {
            throw new IllegalStateException(own);
        }
    }

    /** Sets whether a socket waits for an operation. With the lock. */
    void interest(SelectionKey key, int operation, boolean isWanted) {
        if (!key.isValid()) return;
        int operations = isWanted ? key.interestOps() | operation : key.interestOps() & ~operation;
        if (operations == key.interestOps()) return;
        key.interestOps(operations);
        wakeUp();
    }

    /** Closes a socket, and wakes the selector, which then releases it. With the lock. */
    void close(SelectableChannel channel) {
        try {
            channel.close();
        } catch (IOException isClosedAnyway) {
            problem("closing a socket: " + isClosedAnyway.getMessage());
        }
        wakeUp();
    }

    /** Runs an action later. With the lock. */
    Timer after(long nanoseconds, Runnable action) {
        Timer timer = new Timer(now() + nanoseconds, action);
        timers.add(timer);
        wakeUp();
        return timer;
    }

    /** Takes the lock. */
    public void lock() {
        lock.lock();
    }

    /** Gives the lock back. */
    public void unlock() {
        lock.unlock();
    }

    /** Has a notice run by the thread that drives, in order. With the lock. */
    public void tell(Runnable notice) {
        notices.add(notice);
        wakeUp();
    }

    Consumer<Event> listener() {
        return listener;
    }

    /** Tells the node's listener. With the lock. */
    void tell(Event event) {
        tell(() -> listener.accept(event));
    }

    /** Tells the node's listener and the log of a problem. With the lock. */
    void problem(String text) {
        tell(new Event.Problem(null, text));
        log(text);
    }

    /** Writes a line of the log. With the lock. */
    void log(String line) {
        tell(() -> log.accept(line));
    }

    /** Wakes callers, which check their conditions again. With the lock. */
    void changed() {
        changed.signalAll();
        wakeUp();
    }

    void wakeUp() {
        if (!driver.isHeldByCurrentThread()) selector.wakeup();
    }

    /** Serves until the loop is closed, or its thread is interrupted. */
    public void run() throws InterruptedException {
        await(() -> isClosed, Long.MAX_VALUE);
    }

    /**
     * Waits until {@code condition} holds, which is checked with the lock. Serves the sockets meanwhile, unless another thread does.
     *
     * @param nanoseconds the longest wait; {@link Long#MAX_VALUE} for ever
     * @return whether it holds
     */
    public boolean await(BooleanSupplier condition, long nanoseconds) throws InterruptedException {
        long begin = now();
        while (true) {
            if (isClosed) tellRest();
            if (Thread.interrupted()) throw new InterruptedException();
            long left = nanoseconds == Long.MAX_VALUE ? LONGEST : nanoseconds - (now() - begin);
            lock.lock();
            try {
                if (condition.getAsBoolean()) return true;
                if (left <= 0 || isClosed) return false;
                if (driver.isLocked() && !driver.isHeldByCurrentThread()) {
                    changed.awaitNanos(left);
                    continue;
                }
            } finally {
                lock.unlock();
            }
            if (!driver.tryLock()) continue;
            try {
                turn(left, condition);
            } finally {
                driver.unlock();
                lock.lock();
                changed.signalAll(); // so that another thread may drive
                lock.unlock();
            }
        }
    }

    /** Serves what is ready now, unless another thread does. */
    public void poll() {
        if (!driver.tryLock()) return;
        try {
            turn(0, () -> true);
        } finally {
            driver.unlock();
        }
    }

    private void turn(long longest, BooleanSupplier condition) {
        long wait = longest;
        lock.lock();
        try {
            if (isClosed) return;
            if (!notices.isEmpty() || condition.getAsBoolean()) wait = 0;
            if (!timers.isEmpty()) wait = Math.min(wait, timers.peek().due - now());
        } finally {
            lock.unlock();
        }
        select(wait);
        lock.lock();
        try {
            if (isClosed) return;
            for (SelectionKey key : selector.selectedKeys()) {
                if (key.isValid()) ((Ready) key.attachment()).ready(key);
            }
            selector.selectedKeys().clear();
            while (!timers.isEmpty() && timers.peek().due - now() <= 0) {
                Runnable action = timers.poll().action;
                if (action != null) action.run();
            }
            changed.signalAll();
        } finally {
            lock.unlock();
        }
        runNotices();
    }

    private void select(long wait) {
        try {
            if (wait <= 0) {
                selector.selectNow();
            } else {
                selector.select(TimeUnit.NANOSECONDS.toMillis(wait - 1) + 1);
            }
        } catch (ClosedSelectorException wasClosedMeanwhile) {
            return;
        } catch (IOException fault) {
            throw new UncheckedIOException(fault);
        }
    }

    /** Runs all notices. An exception of a listener goes to the handler of its thread. */
    private void runNotices() {
        for (Runnable notice = nextNotice(); notice != null; notice = nextNotice()) {
            try {
                notice.run();
            } catch (RuntimeException fault) {
                Thread.currentThread().getUncaughtExceptionHandler().uncaughtException(Thread.currentThread(), fault);
            }
        }
    }

    private Runnable nextNotice() {
        lock.lock();
        try {
            return notices.poll();
        } finally {
            lock.unlock();
        }
    }

    /** Ends the loop: no socket is served after it, and callers that wait are woken. Notices so far still run, on the thread that drives or on this one. */
    public void close() {
        lock.lock();
        try {
            if (isClosed) return;
            isClosed = true;
            changed.signalAll();
        } finally {
            lock.unlock();
        }
        try {
            selector.close();
        } catch (IOException isClosedAnyway) {
            throw new UncheckedIOException(isClosedAnyway);
        }
        tellRest();
    }

    private void tellRest() {
        if (!driver.tryLock()) return; // the thread that drives does it
        try {
            runNotices();
        } finally {
            driver.unlock();
        }
    }
}
