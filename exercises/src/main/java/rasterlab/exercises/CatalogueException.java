package rasterlab.exercises;

import java.nio.file.Path;
import rasterlab.exercises.score.Phrase;

/** An exercise folder cannot be read; the message names file, field, value and what is allowed. */
public final class CatalogueException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    private final transient Phrase said;

    public CatalogueException(Phrase said) {
        this(said, null);
    }

    public CatalogueException(Phrase said, Throwable cause) {
        super(said.toString(), cause);
        this.said = said;
    }

    /** Refuses a catalogue, with the place in front of the reason. */
    public CatalogueException(Path place, Phrase reason, Throwable cause) {
        this(Phrase.of("folder.at", place.toString(), reason), cause);
    }

    /** The message in any language. */
    public Phrase said() {
        return said;
    }

    /**
     * The message in that language.
     *
     * @param language such as "ru"
     */
    public String in(String language) {
        return said.in(language);
    }
}
