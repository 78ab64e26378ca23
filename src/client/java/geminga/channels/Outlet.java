package geminga.channels;

import geminga.Match;
import geminga.protocol.Counterparts.Entry;

/** The sockets of one publisher, by mode and protocol (src/client/CHANNELS.md, "Who opens what"). All calls are made with the loop's lock. */
interface Outlet {
    /** What an outlet tells its publisher. */
    interface Owner {
        /** A consumer over TCP has come with its connection. */
        void arrived(Entry<Consumer> entry);

        /** Its connection is gone. */
        void departed(Entry<Consumer> entry);

        /** Something could not be sent to one of the consumers. */
        void leftOut();

        /** What was no frame, or not believed. */
        void dropped();

        /** Listeners or connections came or went, or there is room again. */
        void changed();

        /** What the application is told. */
        void problem(String text);

        /** The channel is reached at another port from now on. */
        void moved(int port);
    }

    /** What the outlet keeps of a consumer that the daemon told of. */
    interface Consumer {
        /** Whether it is there, so that what is sent counts. */
        boolean isThere();
    }

    int port();

    /** Whether anybody hears what is sent. */
    boolean hasConsumer();

    /** Sends to everybody. */
    void send(byte[] payload, long sequence);

    /** Whether a message of that size would be left out for nobody. */
    boolean hasRoom(int octets);

    /** A consumer that the daemon told of. */
    void opened(Entry<Consumer> entry);

    void changed(Entry<Consumer> entry, Match before);

    void closed(Entry<Consumer> entry);

    /** Whether its connection is there, which makes it live on without its daemon. */
    boolean hasConnection(Entry<Consumer> entry);

    /** Says the end behind what waits. */
    void end(long sequence);

    /** Whether the end has been heard, or nobody is left to hear it. */
    boolean hasEnded();

    void close();
}
