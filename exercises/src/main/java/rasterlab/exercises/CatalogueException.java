package rasterlab.exercises;

import java.nio.file.Path;
import rasterlab.exercises.score.Message;

/** An exercise folder cannot be read; the message names file, field, value and what is allowed. */
public final class CatalogueException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    /** With what stands behind it; empty where the message is in English only. */
    private final String place;

    private final transient Message reason;

    public CatalogueException(String message) {
        this(message, null);
    }

    public CatalogueException(String message, Throwable cause) {
        super(message, cause);
        place = "";
        reason = Message.quoted(message);
    }

    public CatalogueException(Path place, Message reason, Throwable cause) {
        super(place + ": " + reason, cause);
        this.place = place + ": ";
        this.reason = reason;
    }

    /**
     * The message in that language; in English where it has no other.
     *
     * @param language such as "ru"
     */
    public String in(String language) {
        return place + reason.in(language);
    }
}
