package rasterlab.exercises;

/** An exercise folder cannot be read; the message names file, field, value and what is allowed. */
public final class CatalogueException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    public CatalogueException(String message) {
        super(message);
    }

    public CatalogueException(String message, Throwable cause) {
        super(message, cause);
    }
}
