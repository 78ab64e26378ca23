package geminga.channels;

import geminga.Match;
import geminga.protocol.Counterparts.Entry;

/** The outlet of one publisher, by mode and protocol (src/client/CHANNELS.md, "Who opens what"). All calls are made with the loop's lock. */
interface Outlet {
    /** The publisher of an outlet. */
    interface Owner {
        /** The connection of a consumer has come. */
        void arrived(Entry<Consumer> entry);

        /** The connection of a consumer is gone. */
        void departed(Entry<Consumer> entry);

        /** Counts a message that was left out for one consumer. */
        void leftOut();

        /** Counts a datagram or connection that was not believed. */
        void dropped();

        /** Listeners or connections came or went, or there is room again. */
        void changed();

        /** Tells the application of a problem. */
        void problem(String text);

        /** States another port of the channel. */
        void moved(int port);
    }

    /** The outlet's part of a consumer that the daemon has named. */
    interface Consumer {
        /** Whether messages reach it. */
        boolean isThere();
    }

    int port();

    /** Whether there is a consumer. */
    boolean hasConsumer();

    /** Sends to every consumer. */
    void send(byte[] payload, long sequence);

    /** Whether every consumer has room for a message of this size. */
    boolean hasRoom(int octets);

    /** The daemon has named a consumer. */
    void opened(Entry<Consumer> entry);

    void changed(Entry<Consumer> entry, Match before);

    void closed(Entry<Consumer> entry);

    /** Whether it has a connection, with which it goes on without its daemon. */
    boolean hasConnection(Entry<Consumer> entry);

    /** Sends the end after the frames that wait. */
    void end(long sequence);

    /** Whether every consumer has the end, or none is left. */
    boolean hasEnded();

    void close();
}
