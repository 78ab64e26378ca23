package geminga.protocol;

import geminga.Conversion;
import java.util.List;
import java.util.Map;

/** The application's conversions, applied along the chain of a match (src/discovery/matching/conversions/CONVERSIONS.md). */
public final class Converter {
    private Converter() {}

    /**
     * The payload in the last representation of the chain. Throws if a function is missing, with the service of {@code via} that
     * does the step, or if a function throws.
     */
    public static byte[] apply(Map<String, Conversion> functions, List<String> chain, String via, byte[] payload) throws Exception {
        if (chain.size() < 2) return payload;
        String whole = chain.get(0) + '>' + chain.get(chain.size() - 1);
        Conversion atOnce = functions.get(whole);
        if (atOnce != null) return made(whole, atOnce, payload);
        byte[] octets = payload;
        for (int i = 1; i < chain.size(); ++i) {
            String step = chain.get(i - 1) + '>' + chain.get(i);
            Conversion function = functions.get(step);
            if (function == null) {
                String service = serviceOf(via, i - 1);
                throw new IllegalStateException("there is no function for the conversion " + step
                        + (service.isEmpty() ? "" : ", which the service " + service + " does"));
            }
            octets = made(step, function, octets);
        }
        return octets;
    }

    /** The service that does a step, counted from 0; empty if the consumer does it. */
    private static String serviceOf(String via, int step) {
        String[] words = via.split(",");
        return step < words.length && !words[step].equals("-") ? words[step] : "";
    }

    private static byte[] made(String step, Conversion function, byte[] payload) throws Exception {
        try {
            byte[] octets = function.convert(payload.clone());
            if (octets != null) return octets;
        } catch (Exception fault) {
            throw new IllegalStateException("the conversion " + step + " failed: " + fault, fault);
        }
        throw new IllegalStateException("the conversion " + step + " gave nothing");
    }
}
