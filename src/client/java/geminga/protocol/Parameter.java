package geminga.protocol;

/** A key of a statement and its value, which is empty where none is written. */
public record Parameter(String key, String value) {}
