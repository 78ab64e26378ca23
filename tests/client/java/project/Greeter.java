package project;

import geminga.Identity;
import geminga.Mode;
import geminga.Node;
import geminga.Offer;
import geminga.Options;
import geminga.Publisher;
import java.time.Duration;

/** A project of its own that knows the library by its jar alone; no daemon is there. */
public final class Greeter {
    private Greeter() {}

    public static void main(String[] arguments) throws Exception {
        Identity vision = Identity.text("vision");
        try (Node node = Node.open(Options.named("project").connect("127.0.0.1:1")); Publisher publisher = node.publish(Offer.of(Mode.STREAM, vision))) {
            node.poll(Duration.ofMillis(1));
            if (publisher.send(new byte[1])) throw new IllegalStateException("nobody listens");
            System.out.println("vision is " + vision.id32() + " and listens at " + (publisher.offer().port() > 0 ? "a port" : "none"));
        }
    }
}
