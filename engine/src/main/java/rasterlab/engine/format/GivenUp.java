package rasterlab.engine.format;

/** An answer that is not waited for to its end, or that is too long to be kept. */
public final class GivenUp extends RuntimeException {
    private static final long serialVersionUID = 1L;

    public GivenUp(String message) {
        super(message);
    }
}
