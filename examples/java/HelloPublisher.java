import static java.nio.charset.StandardCharsets.UTF_8;

import geminga.Identity;
import geminga.Mode;
import geminga.Node;
import geminga.Offer;
import geminga.Options;
import geminga.Publisher;

/** Says where the ball is, ten times a second, to whoever asks for it: needs a gemingad with the soccer ontology. */
public final class HelloPublisher {
    public static void main(String[] arguments) throws Exception {
        long count = arguments.length > 0 ? Long.parseLong(arguments[0]) : Long.MAX_VALUE;
        Offer offer = Offer.of(Mode.PUBSUB, Identity.concept("soccer:BallInfo")).attribute("camera", "front");
        try (Node node = Node.open(Options.named("hello-publisher"), Node::newThread);
                Publisher ball = node.publish(offer, event -> System.err.println(event.consumer().name() + " " + event.change() + " " + event.reason()))) {
            while (ball.sent() < count) { // only what reaches somebody is counted
                ball.send(("{\"x\": 1.5, \"y\": -0.2, \"number\": " + (ball.sent() + 1) + "}").getBytes(UTF_8));
                Thread.sleep(100);
            }
        }
    }
}
