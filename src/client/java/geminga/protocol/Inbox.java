package geminga.protocol;

import geminga.Message;
import java.util.ArrayDeque;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The messages of a subscriber that wait until the application takes them (src/client/CHANNELS.md, "A full inbox"). Full at either limit, but one message always has room. A
 * datagram that comes then takes the place of the eldest one; a stream is to be read no more. The message behind one that was lost says so in {@link Message#missed}.
 */
public final class Inbox {
    private record Waiting(Message message, boolean isDatagram) {}

    private final int room;
    private final ArrayDeque<Waiting> waiting = new ArrayDeque<>();
    private long octets;
    private int datagrams;
    /** By life, how many messages were lost since the last one that was taken. */
    private final Map<Long, Long> lost = new LinkedHashMap<>();

    public Inbox() {
        this(Limits.WAITING_MESSAGES);
    }

    /** One with room for so many messages. */
    public Inbox(int room) {
        this.room = room;
    }

    public boolean isEmpty() {
        return waiting.isEmpty();
    }

    /** Whether another message may come. */
    public boolean hasRoom() {
        return waiting.size() < room && octets < Limits.WAITING_OCTETS;
    }

    /** Whether so much has been taken that reading on is worth while. */
    public boolean isHalfEmpty() {
        return waiting.size() <= room / 2 && octets <= Limits.WAITING_OCTETS / 2;
    }

    /** Keeps a message of a stream, which cannot be lost. */
    public void putStreamed(Message message) {
        put(new Waiting(message, false));
    }

    /** Keeps a message that came in a datagram. How many are lost for it: the eldest datagrams, or this one. */
    public int putDatagram(Message message) {
        int count = 0;
        for (Iterator<Waiting> each = waiting.iterator(); !hasRoom() && datagrams > 0;) {
            Waiting one = each.next();
            if (!one.isDatagram()) continue;
            each.remove();
            --datagrams;
            octets -= one.message().payload().length;
            lose(one.message());
            ++count;
        }
        if (!hasRoom()) {
            lose(message);
            return count + 1;
        }
        ++datagrams;
        put(new Waiting(message, true));
        return count;
    }

    /** The eldest message, or null where none waits. */
    public Message take() {
        Waiting first = waiting.poll();
        if (first == null) return null;
        Message message = first.message();
        octets -= message.payload().length;
        if (first.isDatagram()) --datagrams;
        Long before = lost.remove(message.life());
        return before == null ? message : new Message(message.payload(), message.life(), message.sequence(), message.missed() + before, message.provider());
    }

    public void clear() {
        waiting.clear();
        lost.clear();
        octets = 0;
        datagrams = 0;
    }

    private void put(Waiting one) {
        waiting.add(one);
        octets += one.message().payload().length;
    }

    private void lose(Message message) {
        if (message.life() == 0) return;
        if (lost.size() == Limits.REMEMBERED_LIVES && !lost.containsKey(message.life())) lost.remove(lost.keySet().iterator().next());
        lost.merge(message.life(), message.missed() + 1, Long::sum);
    }
}
