/**
 * The Java client of Geminga: services are offered and asked for in the words of GCNP, and messages flow between publishers and subscribers.
 * {@link geminga.Node} is where to begin.
 */
module geminga {
    requires static jdk.net;

    exports geminga;
}
