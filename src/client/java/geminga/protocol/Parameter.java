package geminga.protocol;

/** A key of a statement and its value, which is empty if none is written. */
public record Parameter(String key, String value) {}
