package geminga;

import java.util.List;
import java.util.Map;

/** Applies the functions of an application along a chain of representations. */
final class Conversions {
    private Conversions() {}

    /** The payload in the last representation of the chain; an exception where a function is missing or throws. */
    static byte[] apply(Map<String, Conversion> functions, List<String> chain, byte[] payload) throws Exception {
        if (chain.size() < 2) return payload;
        String whole = chain.get(0) + '>' + chain.get(chain.size() - 1);
        Conversion atOnce = functions.get(whole);
        if (atOnce != null) return made(whole, atOnce, payload);
        byte[] octets = payload;
        for (int i = 1; i < chain.size(); ++i) {
            String step = chain.get(i - 1) + '>' + chain.get(i);
            Conversion function = functions.get(step);
            if (function == null) throw new IllegalStateException("no function for " + step);
            octets = made(step, function, octets);
        }
        return octets;
    }

    private static byte[] made(String step, Conversion function, byte[] payload) throws Exception {
        try {
            byte[] octets = function.convert(payload.clone());
            if (octets != null) return octets;
        } catch (Exception fault) {
            throw new IllegalStateException("the function for " + step + " throws " + fault, fault);
        }
        throw new IllegalStateException("the function for " + step + " makes nothing");
    }
}
