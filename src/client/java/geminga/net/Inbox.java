package geminga.net;

import geminga.Message;
import geminga.core.Sizes;
import java.util.ArrayDeque;

/** The messages of a subscriber that wait until the application takes them, {@link Sizes#WAITING_MESSAGES} and {@link Sizes#WAITING_OCTETS} at most. */
public final class Inbox {
    private final ArrayDeque<Message> waiting = new ArrayDeque<>();
    private long octets;

    public boolean isEmpty() {
        return waiting.isEmpty();
    }

    /** Whether another message may come. */
    public boolean hasRoom() {
        return waiting.size() < Sizes.WAITING_MESSAGES && octets < Sizes.WAITING_OCTETS;
    }

    /** Whether so much has been taken that reading on is worth while. */
    public boolean isHalfEmpty() {
        return waiting.size() <= Sizes.WAITING_MESSAGES / 2 && octets <= Sizes.WAITING_OCTETS / 2;
    }

    public void add(Message message) {
        waiting.add(message);
        octets += message.payload().length;
    }

    public Message poll() {
        Message message = waiting.poll();
        if (message != null) octets -= message.payload().length;
        return message;
    }

    public void clear() {
        waiting.clear();
        octets = 0;
    }
}
