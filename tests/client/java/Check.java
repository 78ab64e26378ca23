import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Random;

/** Assertions of the tests, and the vectors that all languages share. */
final class Check {
    /** An action that may throw. */
    interface Action {
        void run() throws Exception;
    }

    private Check() {}

    static void that(boolean holds, String text) {
        if (!holds) throw new AssertionError(text);
    }

    static void equal(Object expected, Object actual) {
        if (!Objects.equals(expected, actual)) throw new AssertionError("expected: " + expected + "\n     but is: " + actual);
    }

    static <T extends Throwable> T fails(Class<T> kind, Action action) throws Exception {
        try {
            action.run();
        } catch (Throwable fault) {
            if (kind.isInstance(fault)) return kind.cast(fault);
            throw fault;
        }
        throw new AssertionError("no " + kind.getSimpleName());
    }

    /** Random numbers; GEMINGA_SEED gives the same ones again. */
    static Random chance() {
        String given = System.getenv("GEMINGA_SEED");
        long seed = given == null ? System.nanoTime() : Long.parseLong(given);
        System.out.println("GEMINGA_SEED=" + seed);
        return new Random(seed);
    }

    private static Path root() {
        return Path.of(System.getProperty("geminga.root", "."));
    }

    /** The rows of a table of vectors. */
    static List<String[]> rows(String name) throws IOException {
        List<String[]> rows = new ArrayList<>();
        for (String line : Files.readAllLines(root().resolve("tests/client/vectors").resolve(name))) {
            if (!line.isEmpty() && !line.startsWith("#")) rows.add(line.split("\t", -1));
        }
        that(!rows.isEmpty(), name + " is empty");
        return rows;
    }

    /** The lines of a block of GCNP.md. */
    static List<String> block(String name) throws IOException {
        List<String> lines = Files.readAllLines(root().resolve("src/discovery/gcnp/GCNP.md"));
        int begin = lines.indexOf("```" + name) + 1;
        that(begin > 0, "there is no block " + name);
        int end = begin;
        while (!lines.get(end).equals("```")) ++end;
        return lines.subList(begin, end);
    }
}
