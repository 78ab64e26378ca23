package geminga;

/** Turns a payload of one representation into another. If it throws, this message alone is dropped. */
@FunctionalInterface
public interface Conversion {
    /**
     * Converts one payload.
     *
     * @param payload in the first representation
     * @return in the second one
     * @throws Exception if the payload cannot be converted: the message is dropped and counted
     */
    byte[] convert(byte[] payload) throws Exception;
}
