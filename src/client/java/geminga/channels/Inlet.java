package geminga.channels;

import geminga.Match;

/** How messages of one provider come. All calls are made with the loop's lock. */
interface Inlet {
    /** What an inlet tells its subscriber. */
    interface Owner {
        /** Whether another message may wait; an inlet stops reading where not. */
        boolean hasRoom();

        /** A message that came from where it should; {@code life} is 0 where the sender is no library of this kind. */
        void deliver(Match provider, byte[] payload, long life, long sequence);

        /** What was no frame, or not believed. */
        void dropped();

        /** The provider of that life said its end behind the message of that sequence. */
        void ended(long life, long sequence);

        /** The connection broke; whether to make another one. */
        boolean broke(long life);
    }

    /** What is stated of the provider changed, perhaps where it is. */
    void changed(Match match);

    /** It was withdrawn: what is on its way is still taken. */
    void ending();

    /** Whether it waits for room, so that nothing is heard of it. */
    boolean isPaused();

    /** There is room again. */
    void resume();

    /** Whether a connection is there, which makes the channel live on without its daemons. */
    boolean hasConnection();

    void close();
}
