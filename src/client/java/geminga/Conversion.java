package geminga;

/** Turns a payload from one representation into another. What it throws costs this message only. */
@FunctionalInterface
public interface Conversion {
    /**
     * Converts one payload.
     *
     * @param payload in the first representation
     * @return in the second one
     * @throws Exception where the payload cannot be converted: the message is dropped and counted
     */
    byte[] convert(byte[] payload) throws Exception;
}
