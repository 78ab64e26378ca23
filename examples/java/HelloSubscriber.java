import geminga.Identity;
import geminga.Mode;
import geminga.Node;
import geminga.Options;
import geminga.Request;
import geminga.Subscriber;

/** Prints where the ball is, whoever in the team knows it: needs a gemingad with the soccer ontology. It has one thread. */
public final class HelloSubscriber {
    public static void main(String[] arguments) throws Exception {
        long count = arguments.length > 0 ? Long.parseLong(arguments[0]) : Long.MAX_VALUE;
        Request request = Request.of(Mode.PUBSUB, Identity.concept("soccer:TrackedObject"));
        try (Node node = Node.open(Options.named("hello-subscriber"));
                Subscriber balls = node.subscribe(request, event -> System.err.println(event.provider().name() + " on " + event.provider().host() + " " + event.change()))) {
            for (long number = 0; number < count; ++number) System.out.println(balls.receive().text());
        }
    }
}
