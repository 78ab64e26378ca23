package geminga;

import java.io.IOException;

/** The daemon has refused an offer or a request, which is not stated again. */
public final class RefusedException extends IOException {
    private static final long serialVersionUID = 1;

    /** The code of GCNP. */
    private final int code;

    /**
     * Makes one.
     *
     * @param code of GCNP
     * @param text the daemon's
     */
    public RefusedException(int code, String text) {
        super(text);
        this.code = code;
    }

    /** {@return the code of GCNP, as 422} */
    public int code() {
        return code;
    }
}
