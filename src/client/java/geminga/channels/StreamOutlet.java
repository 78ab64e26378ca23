package geminga.channels;

import geminga.Match;
import geminga.protocol.Counterparts.Entry;

/** An outlet of {@code otm/stream}, where the daemon tells a publisher of no consumers. */
interface StreamOutlet extends Outlet {
    @Override
    default void opened(Entry<Consumer> entry) {
        throw new IllegalStateException("the daemon tells of no consumers of a stream");
    }

    @Override
    default void changed(Entry<Consumer> entry, Match before) {}

    @Override
    default void closed(Entry<Consumer> entry) {}

    @Override
    default boolean hasConnection(Entry<Consumer> entry) {
        return false;
    }
}
