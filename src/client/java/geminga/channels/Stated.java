package geminga.channels;

import geminga.Event;
import geminga.RefusedException;
import geminga.protocol.ChannelKeys;
import geminga.protocol.Parameter;
import geminga.protocol.Statement;
import geminga.protocol.Told;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;

/** An offer or a request that is stated to every daemon, and the answers to it. The loop's lock guards all of it. */
public abstract class Stated {
    final Loop loop;
    final DaemonLink daemon;
    final long number;
    private final String command;
    private final CompletableFuture<Void> taken = new CompletableFuture<>();
    private volatile AutoCloseable owner;
    private volatile RefusedException refusal;
    /** The pings that follow a {@code create} and have no pong yet: while there is one, an error is about the create. */
    private int creating;
    private final ArrayDeque<Modification> modifying = new ArrayDeque<>();
    private boolean isTaken;
    private boolean isWithdrawn;

    Stated(Loop loop, DaemonLink daemon, String command) {
        this.loop = loop;
        this.daemon = daemon;
        this.command = command;
        number = daemon.nextNumber();
    }

    /** Sets the publisher or subscriber of the application. With the lock. */
    public final void owner(AutoCloseable made) {
        owner = made;
    }

    /** Tells the application and the log of a problem. With the lock. */
    public final void problem(String text) {
        loop.tell(() -> loop.listener().accept(new Event.Problem(owner, text)));
        loop.log(text);
    }

    /** The parameters of {@code create}. */
    abstract Map<String, String> parameters();

    /** Takes an event of the daemon. */
    abstract void told(Told event);

    /** Takes the keys of the channel of a publisher. */
    abstract void keys(long life, ChannelKeys keys);

    /** The daemon has said hello, and whether it has keys. */
    abstract void daemonKeys(boolean hasKeys);

    /** The mode of this host has become known, or another one. */
    void modeChanged() {}

    abstract void daemonLost();

    abstract void daemonBack();

    /** Ends the channel, because the daemon has refused the request or taken it back. */
    abstract void refused();

    /** States the request for the first time. */
    final void begin() {
        daemon.add(this);
        if (daemon.isUp()) state();
    }

    /** States the request to a daemon that does not have it. */
    final void state() {
        if (refusal != null || isWithdrawn) return;
        daemon.say(number, command, "create", parameters());
        ++creating;
        daemon.whenHandled(() -> {
            --creating;
            if (refusal != null || isTaken) return;
            isTaken = true;
            loop.tell(() -> taken.complete(null));
        });
    }

    /** States a change; {@code undo} is called if it is refused. Without a daemon it will be stated with the whole request. */
    final CompletionStage<Void> modify(Map<String, String> changes, Runnable undo) {
        CompletableFuture<Void> done = new CompletableFuture<>();
        if (changes.isEmpty() || !daemon.isUp() || refusal != null) {
            done.complete(null);
            return done;
        }
        daemon.pingWhereDue(); // so that an error is known to be about this
        daemon.say(number, command, "modify", changes);
        modifying.add(new Modification(done, undo));
        daemon.whenHandled(() -> {
            Modification handled = modifying.poll();
            if (handled != null && !handled.isRefused) loop.tell(() -> done.complete(null));
        });
        daemon.pingWhereDue();
        return done;
    }

    /** A change that the daemon has not answered yet. */
    private static final class Modification {
        private final CompletableFuture<Void> done;
        private final Runnable undo;
        private boolean isRefused;

        Modification(CompletableFuture<Void> done, Runnable undo) {
            this.done = done;
            this.undo = undo;
        }
    }

    final void withdraw() {
        isWithdrawn = true;
        if (daemon.isUp() && refusal == null) daemon.say(number, command, "remove", Map.of());
        daemon.forget(this);
    }

    /** The daemon is gone and will not answer. */
    final void lost() {
        creating = 0;
        for (Modification one = modifying.poll(); one != null; one = modifying.poll()) {
            CompletableFuture<Void> done = one.done;
            loop.tell(() -> done.complete(null)); // it will be stated with the whole request
        }
        daemonLost();
    }

    final void error(int code, String text) {
        boolean isTakenBack = code == 429 && text.startsWith("taken back");
        boolean isOfCreate = creating > 0 && code != 409 && code != 503;
        Modification modification = modifying.peek();
        if (!isOfCreate && !isTakenBack && modification != null && code != 409) {
            RefusedException told = new RefusedException(code, code + " " + text);
            modification.isRefused = true;
            modification.undo.run();
            loop.tell(() -> modification.done.completeExceptionally(told));
            return;
        }
        if (!isOfCreate && !isTakenBack) {
            problem(code + " " + text);
            return;
        }
        refusal = new RefusedException(code, code + " " + text);
        if (isTaken) problem(code + " " + text);
        RefusedException told = refusal;
        if (!isTaken) loop.log("the request " + words() + " is refused: " + text);
        loop.tell(() -> taken.completeExceptionally(told));
        refused();
        loop.changed();
    }

    /** The request as the daemon is told it. */
    private String words() {
        List<Parameter> written = new ArrayList<>();
        parameters().forEach((key, value) -> written.add(new Parameter(key, value)));
        String line = new Statement(number, command, "create", written).write();
        return line.substring(line.indexOf("create ") + "create ".length());
    }

    public final CompletableFuture<Void> taken() {
        return taken;
    }

    public final boolean isTaken() {
        return isTaken;
    }

    public final RefusedException refusal() {
        return refusal;
    }
}
