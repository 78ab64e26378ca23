package geminga.channels;

import geminga.Match;

/** The inlet from one provider. All calls are made with the loop's lock. */
interface Inlet {
    /** The subscriber of an inlet. */
    interface Owner {
        /** Whether another message may wait. If not, an inlet over TCP stops reading. */
        boolean hasRoom();

        /** Takes a message that is believed. {@code life} is 0 if the provider states none. */
        void deliver(Match provider, byte[] payload, long life, long sequence);

        /** Counts a frame or datagram that was not believed. */
        void dropped();

        /** The provider of that life has ended after the message of that sequence. */
        void ended(long life, long sequence);

        /** The connection broke. Whether to make another one. */
        boolean broke(long life);
    }

    /** The statement or the address of the provider has changed. */
    void changed(Match match);

    /** The provider was withdrawn; messages on their way are still taken. */
    void ending();

    /** Whether it has stopped reading until there is room. */
    boolean isPaused();

    /** There is room again. */
    void resume();

    /** Whether there is a connection, with which the channel goes on without its daemons. */
    boolean hasConnection();

    void close();
}
