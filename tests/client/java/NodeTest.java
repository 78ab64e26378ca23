import geminga.Event;
import geminga.Identity;
import geminga.Mode;
import geminga.Node;
import geminga.Offer;
import geminga.Options;
import geminga.Publisher;
import geminga.RefusedException;
import geminga.Request;
import geminga.Subscriber;
import java.io.IOException;
import java.net.BindException;
import java.net.DatagramSocket;
import java.nio.channels.ClosedChannelException;
import java.time.Duration;
import java.util.Set;
import java.util.concurrent.CompletionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/** A node and its daemon: what is stated, what is refused, and what happens to it when the daemon goes and comes back. */
final class NodeTest {
    private static final Duration LONG = Duration.ofSeconds(30);
    private static final Offer OFFER = Offer.of(Mode.ONE_TO_ONE, Identity.text("x"));
    private static final Request REQUEST = Request.of(Mode.ONE_TO_ONE, Identity.text("x"));

    private static Options options(ScriptedDaemon daemon) {
        return Options.named("test").connect(daemon.address());
    }

    static void itStatesWhatItOffersAndAsksForWithItsLifeAndPorts() throws Exception {
        try (ScriptedDaemon daemon = new ScriptedDaemon(); Node node = Node.open(options(daemon), Node::newThread)) {
            daemon.greet();
            Publisher publisher = node.publish(OFFER.attribute("rate", "3"));
            Check.equal("1 pub create mode=oto text=x port=" + publisher.offer().port() + " channel=" + geminga.protocol.Life.write(publisher.life()) + " rate=3", daemon.takes());
            Check.that(publisher.awaitTaken(LONG), "taken");
            Subscriber subscriber = node.subscribe(REQUEST);
            Check.equal("2 sub create mode=oto text=x protocol=udp,tcp port=" + subscriber.request().port() + " channel=" + geminga.protocol.Life.write(subscriber.life()), daemon.takes());
            Check.that(subscriber.request().port() > 0 && publisher.offer().port() > 0, "a port of its own");
            publisher.close();
            Check.equal("1 pub remove", daemon.heard());
            subscriber.close();
            Check.equal("2 sub remove", daemon.heard());
        }
    }

    static void itSaysGoodbye() throws Exception {
        LinkedBlockingQueue<String> heard = new LinkedBlockingQueue<>();
        try (ScriptedDaemon daemon = new ScriptedDaemon()) {
            try (Node node = Node.open(options(daemon), Node::newThread)) {
                daemon.greet();
                Check.that(node.awaitConnected(LONG), "connected");
                new Thread(() -> {
                    try {
                        heard.add(daemon.heard());
                        daemon.die();
                    } catch (IOException fault) {
                        heard.add(fault.toString());
                    }
                }).start();
            }
            Check.equal("0 sys bye", heard.poll(30, TimeUnit.SECONDS));
        }
    }

    static void whatTheDaemonRefusesIsAnErrorAndNotStatedAgain() throws Exception {
        try (ScriptedDaemon daemon = new ScriptedDaemon(); Node node = Node.open(options(daemon), Node::newThread)) {
            daemon.greet();
            Subscriber bad = node.subscribe(REQUEST.where("rate >"));
            daemon.heard();
            daemon.heard();
            daemon.say("1 422 where: cannot be read").say("0 msg pong");
            RefusedException refusal = Check.fails(RefusedException.class, () -> bad.awaitTaken(LONG));
            Check.equal(422, refusal.code());
            Check.equal("422 where: cannot be read", refusal.getMessage());
            Check.fails(RefusedException.class, bad::receive);
            Check.fails(CompletionException.class, () -> bad.taken().toCompletableFuture().join());
            Publisher good = node.publish(OFFER);
            Check.that(daemon.takes().startsWith("2 pub create "), "the other");
            Check.that(good.awaitTaken(LONG), "taken");
            daemon.die();
            daemon.comeBack();
            daemon.greet();
            Check.that(daemon.takes().startsWith("2 pub create "), "the other alone");
        }
    }

    static void whatIsTakenBackIsAProblemAndEnds() throws Exception {
        LinkedBlockingQueue<Event> told = new LinkedBlockingQueue<>();
        try (ScriptedDaemon daemon = new ScriptedDaemon(); Node node = Node.open(options(daemon).listener(told::add), Node::newThread)) {
            daemon.greet();
            Publisher publisher = node.publish(OFFER, told::add);
            daemon.takes();
            Check.that(publisher.awaitTaken(LONG), "taken");
            daemon.say(ScriptedDaemon.consumer(1, "5e6f7a8b/3/1", 9, "000000000000000a"));
            daemon.say("1 429 taken back: others need the room");
            Check.that(next(told) instanceof Event.Connected connected && connected.host().equals("host"), "connected");
            Check.that(next(told) instanceof Event.ConsumerEvent added && added.reason().equals("-"), "added");
            Check.that(next(told) instanceof Event.Problem problem && problem.source() == publisher && problem.text().startsWith("429 taken back"), "told");
            Check.that(next(told) instanceof Event.ConsumerEvent removed && removed.reason().equals("refused"), "removed");
            Check.fails(RefusedException.class, () -> publisher.send(new byte[1]));
        }
    }

    static void aChangeThatIsRefusedIsUndone() throws Exception {
        try (ScriptedDaemon daemon = new ScriptedDaemon(); Node node = Node.open(options(daemon), Node::newThread)) {
            daemon.greet();
            Subscriber subscriber = node.subscribe(REQUEST.where("rate > 1"));
            daemon.takes();
            Check.that(subscriber.awaitTaken(LONG), "taken");
            var wrong = subscriber.modify(request -> request.where("rate >")).toCompletableFuture();
            Check.equal("1 sub modify where=\"rate >\"", daemon.heard());
            Check.equal("0 sys ping", daemon.heard());
            var right = subscriber.modify(request -> request.attribute("role", "keeper")).toCompletableFuture();
            Check.that(daemon.heard().contains("role=keeper"), "the second change");
            Check.equal("0 sys ping", daemon.heard());
            daemon.say("1 422 where: cannot be read").say("0 msg pong").say("0 msg pong");
            CompletionException refused = Check.fails(CompletionException.class, wrong::join);
            Check.that(refused.getCause() instanceof RefusedException, "refused");
            right.get(30, TimeUnit.SECONDS);
            Check.fails(IllegalArgumentException.class, () -> subscriber.modify(request -> request.port(1)));
        }
    }

    static void whatCannotBeOpenedOrStatedIsAnErrorOfTheCall() throws Exception {
        try (ScriptedDaemon daemon = new ScriptedDaemon(); Node node = Node.open(options(daemon)); DatagramSocket other = new DatagramSocket()) {
            Check.fails(BindException.class, () -> node.publish(OFFER.port(other.getLocalPort())));
            Check.fails(BindException.class, () -> node.subscribe(REQUEST.port(other.getLocalPort())));
            Check.fails(IllegalArgumentException.class, () -> node.publish(Offer.read("mode=oto text=x protocol=shm")));
            Check.fails(IllegalArgumentException.class, () -> node.publish(Offer.read("mode=oto text=x address=239.1.2.3")));
            Offer full = OFFER;
            for (int i = 0; i < 32; ++i) full = full.attribute("n" + i, "");
            Offer all = full;
            Check.fails(IllegalArgumentException.class, () -> node.publish(all)); // the library's own attribute is one, too
            Check.fails(IllegalArgumentException.class, () -> Node.open(Options.named("test").connect("robot2:4717")));
        }
    }

    static void withoutADaemonTheLogSaysSoOnceAndWhenItAnswers() throws Exception {
        LinkedBlockingQueue<String> log = new LinkedBlockingQueue<>();
        try (ScriptedDaemon daemon = new ScriptedDaemon()) {
            daemon.die();
            try (Node node = Node.open(options(daemon).log(log::add), Node::newThread)) {
                for (int lives = 0; lives < 2; ++lives) {
                    Check.equal("no daemon at " + daemon.address() + " for 1 s (Connection refused): start gemingad, or say where it is with GEMINGA_CONNECT", log.poll(30, TimeUnit.SECONDS));
                    daemon.comeBack();
                    daemon.greet();
                    Check.equal("the daemon at " + daemon.address() + " answers", log.poll(30, TimeUnit.SECONDS));
                    Check.that(node.isConnected() && log.isEmpty(), "once");
                    daemon.die();
                }
            }
        }
    }

    static void aRefusalIsWrittenToTheLog() throws Exception {
        LinkedBlockingQueue<String> log = new LinkedBlockingQueue<>();
        try (ScriptedDaemon daemon = new ScriptedDaemon(); Node node = Node.open(options(daemon).log(log::add), Node::newThread)) {
            daemon.greet();
            Subscriber bad = node.subscribe(REQUEST.where("rate >"));
            daemon.heard();
            daemon.heard();
            daemon.say("1 422 where: cannot be read").say("0 msg pong");
            Check.fails(RefusedException.class, () -> bad.awaitTaken(LONG));
            String line = log.poll(30, TimeUnit.SECONDS);
            Check.that(line.matches("the request mode=oto text=x where=\"rate >\" .* is refused: where: cannot be read"), line);
        }
    }

    static void wrongArgumentsAreErrorsOfTheCallThatNameThem() throws Exception {
        Check.equal("port: 0 to 65535, not '99999'", Check.fails(IllegalArgumentException.class, () -> OFFER.port(99999)).getMessage());
        Check.equal("port: 0 to 65535, not '-1'", Check.fails(IllegalArgumentException.class, () -> REQUEST.port(-1)).getMessage());
        Check.that(Check.fails(IllegalArgumentException.class, () -> Options.named("")).getMessage().startsWith("name: 1 to 64 octets"), "an empty name");
        Check.fails(IllegalArgumentException.class, () -> Options.named("n".repeat(65)));
        for (int size : new int[] {1, 63, 64}) Check.equal(size, Options.named("n".repeat(size)).name().length());
        Check.equal("", Options.unnamed().name());
        Check.that(Check.fails(IllegalArgumentException.class, () -> Offer.read("mode=oto text=x prot=1")).getMessage().contains("did you mean port"), "an unknown parameter");
        Check.that(Check.fails(IllegalArgumentException.class, () -> Offer.read("mode=oto text=x match=exact")).getMessage().contains("match"), "a parameter of requests");
        try (ScriptedDaemon daemon = new ScriptedDaemon(); Node node = Node.open(options(daemon))) {
            Publisher publisher = node.publish(OFFER);
            Check.that(Check.fails(NullPointerException.class, () -> publisher.send(null)).getMessage().startsWith("payload: "), "no payload");
        }
    }

    static void theDaemonMayStartLaterAndComeBack() throws Exception {
        LinkedBlockingQueue<Event> told = new LinkedBlockingQueue<>();
        try (ScriptedDaemon daemon = new ScriptedDaemon()) {
            daemon.die();
            try (Node node = Node.open(options(daemon).listener(told::add), Node::newThread)) {
                Publisher publisher = node.publish(OFFER);
                Check.that(!publisher.awaitTaken(Duration.ofMillis(1)), "not yet");
                for (int lives = 0; lives < 2; ++lives) {
                    daemon.comeBack();
                    daemon.greet();
                    Check.that(daemon.takes().startsWith("1 pub create "), "stated again");
                    Check.that(next(told) instanceof Event.Connected, "connected");
                    daemon.die();
                    Check.that(next(told) instanceof Event.Disconnected, "disconnected");
                }
            }
        }
    }

    static void withoutAnExecutorThereIsNoThread() throws Exception {
        Set<Thread> before = Thread.getAllStackTraces().keySet();
        try (ScriptedDaemon daemon = new ScriptedDaemon(); Node node = Node.open(options(daemon)); Publisher publisher = node.publish(OFFER)) {
            Thread tester = new Thread(() -> {
                try {
                    daemon.greet();
                    daemon.takes();
                } catch (IOException fault) {
                    throw new AssertionError(fault);
                }
            }, "tester");
            tester.start();
            Check.that(publisher.awaitTaken(LONG), "who waits serves");
            tester.join();
            Set<Thread> after = new java.util.HashSet<>(Thread.getAllStackTraces().keySet());
            after.removeAll(before);
            Check.equal(Set.of(), after);
            Check.that(node.isConnected(), "still there");
        }
    }

    static void whoWaitsIsInterruptedAndNoSocketIsClosed() throws Exception {
        try (ScriptedDaemon daemon = new ScriptedDaemon(); Node node = Node.open(options(daemon))) {
            Subscriber subscriber = node.subscribe(REQUEST);
            Publisher publisher = node.publish(Offer.of(Mode.STREAM, Identity.text("y")).tcp());
            Thread.currentThread().interrupt();
            Check.fails(InterruptedException.class, () -> subscriber.receive(LONG));
            Thread.currentThread().interrupt();
            publisher.send(new byte[1]);
            Check.that(Thread.interrupted(), "it stays set where nobody waits");
            Thread waiting = Thread.currentThread();
            new Thread(() -> {
                while (waiting.getState() == Thread.State.RUNNABLE && !waiting.isInterrupted()) waiting.interrupt();
            }).start();
            Check.fails(InterruptedException.class, () -> subscriber.receive(LONG));
            daemon.greetInBackground();
            Check.that(publisher.awaitTaken(LONG), "all goes on");
        }
    }

    static void anExecutorsTaskThatIsInterruptedClosesTheNode() throws Exception {
        try (ScriptedDaemon daemon = new ScriptedDaemon()) {
            Thread[] serving = new Thread[1];
            Node node = Node.open(options(daemon), task -> (serving[0] = new Thread(task)).start());
            Subscriber subscriber = node.subscribe(REQUEST);
            serving[0].interrupt();
            Check.fails(ClosedChannelException.class, subscriber::receive);
            serving[0].join();
            Check.fails(ClosedChannelException.class, () -> node.publish(OFFER));
            node.close();
        }
    }

    static void closingIsForEverAndWakesWhoWaits() throws Exception {
        try (ScriptedDaemon daemon = new ScriptedDaemon()) {
            Node node = Node.open(options(daemon), Node::newThread);
            Subscriber subscriber = node.subscribe(REQUEST);
            Publisher publisher = node.publish(OFFER);
            new Thread(node::close).start();
            Check.fails(ClosedChannelException.class, subscriber::receive);
            node.close();
            subscriber.close();
            publisher.close();
            Check.fails(ClosedChannelException.class, () -> publisher.send(new byte[1]));
        }
    }

    static void whatTheDaemonSaysWrongCostsOnlyItsLine() throws Exception {
        LinkedBlockingQueue<Event> told = new LinkedBlockingQueue<>();
        try (ScriptedDaemon daemon = new ScriptedDaemon(); Node node = Node.open(options(daemon).listener(told::add), Node::newThread)) {
            daemon.greet();
            node.publish(OFFER, told::add);
            daemon.takes();
            daemon.say("no line").say("1 sub add subscription=\"").say("1 sub add").say("1 pub add service=a/1/1").say("77 sub add subscription=1").say("0 msg lagged").say("x".repeat(70_000));
            daemon.say(ScriptedDaemon.consumer(1, "5e6f7a8b/3/1", 9, "000000000000000a"));
            Event last = next(told);
            while (!(last instanceof Event.ConsumerEvent)) last = next(told);
            Check.equal(10L, ((Event.ConsumerEvent) last).consumer().life());
        }
    }

    private static Event next(LinkedBlockingQueue<Event> told) throws InterruptedException {
        Event event = told.poll(30, TimeUnit.SECONDS);
        Check.that(event != null, "nothing was told");
        return event;
    }
}
