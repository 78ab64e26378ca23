/**
 * The Java client of Geminga: services are offered and asked for in the words of GCNP, and messages flow between publishers and subscribers.
 * {@link geminga.Node} is where to begin.
 */
module geminga {
    requires jdk.net; // to notice hosts that were switched off: keep-alive times of TCP

    exports geminga;
}
