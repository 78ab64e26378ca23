package geminga.channels;

import geminga.Match;

/** The sockets of the channel from one provider. All calls are made with the loop's lock. */
interface Inlet {
    /** No sockets: there is no channel to the provider, or not yet. */
    Inlet NONE = new Inlet() {
        @Override
        public void changed(Match match) {}

        @Override
        public void answered(boolean isAskedAgain) {}

        @Override
        public void keysChanged() {}

        @Override
        public void ending() {}

        @Override
        public void close() {}
    };

    /** The statement or the address of the provider has changed. */
    void changed(Match match);

    /** The provider has answered a hello. With {@code isAskedAgain}, it waits for another one at once. */
    void answered(boolean isAskedAgain);

    /** The keys of the channel are other ones. */
    void keysChanged();

    /** The provider was withdrawn; messages on their way are still taken. */
    void ending();

    /** Whether it has stopped reading until there is room. Datagrams are always read. */
    default boolean isPaused() {
        return false;
    }

    /** There is room again. */
    default void resume() {}

    /** Whether there is a connection, with which the channel goes on without its daemons. */
    default boolean hasConnection() {
        return false;
    }

    void close();
}
