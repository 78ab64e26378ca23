package geminga.channels;

import geminga.Match;
import geminga.protocol.Counterparts.Entry;
import geminga.protocol.Places;

/** The outlet of one publisher, by mode and protocol (src/client/CHANNELS.md, "Who opens what"). All calls are made with the loop's lock. */
interface Outlet {
    /** The publisher of an outlet. */
    interface Owner {
        /** Messages reach a consumer from now on, or still do. */
        void arrived(Entry<Consumer> entry);

        /** The connection of a consumer is gone, for a reason that a daemon does not give. */
        void departed(Entry<Consumer> entry, String reason);

        /** Counts a message that was left out for one consumer. */
        void leftOut();

        /** Counts a datagram or connection that was not believed. */
        void dropped();

        /** Listeners or connections came or went, or there is room again. */
        void changed();

        /** Tells the application of a problem. */
        void problem(String text);

        /** Places were taken or given back: {@code count} of them for what {@code holders} names. */
        void placesChanged(Places<?> places, int count, String holders);

        /** States another port of the channel. */
        void moved(int port);
    }

    /** The outlet's part of a consumer that the daemon has named. */
    abstract class Consumer {
        /** Whether the application was told of it. */
        boolean isTold;

        /** Whether messages reach it. */
        abstract boolean isThere();
    }

    int port();

    /** Whether there is a consumer. */
    boolean hasConsumer();

    /** Sends the next message to every consumer. */
    void send(byte[] payload);

    /** Whether every consumer has room for a message of this size. */
    boolean hasRoom(int octets);

    /** The daemon has named a consumer. */
    void opened(Entry<Consumer> entry);

    void changed(Entry<Consumer> entry, Match before);

    void closed(Entry<Consumer> entry);

    /** Whether it has a connection, with which it goes on without its daemon. */
    boolean hasConnection(Entry<Consumer> entry);

    /**
     * The keys are other ones.
     *
     * @param beginsToSeal whether plain frames were sent until now, and sealed ones from now on
     * @param isStrict whether plain frames are taken no more
     */
    void keysChanged(boolean beginsToSeal, boolean isStrict);

    /** Sends the end after the frames that wait. */
    void end();

    /** Whether every consumer has the end, or none is left. */
    boolean hasEnded();

    void close();
}
