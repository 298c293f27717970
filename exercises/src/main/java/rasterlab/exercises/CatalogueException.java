package rasterlab.exercises;

import static java.util.stream.Collectors.joining;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.exercises.score.Phrase;

/**
 * An exercise folder, or what was handed in, cannot be read; the message names file, field, value
 * and what is allowed. One exception may stand for faults at several places.
 */
public final class CatalogueException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    /** Faults of one document that are told; how many more there are is told in one. */
    private static final int MOST_TOLD = 12;

    private final transient Phrase said;
    private final transient List<CatalogueException> more;

    public CatalogueException(Phrase said) {
        this(said, null);
    }

    public CatalogueException(Phrase said, Throwable cause) {
        super(said.toString(), cause);
        this.said = said;
        this.more = List.of();
    }

    private CatalogueException(CatalogueException first, List<CatalogueException> more) {
        super(joined(first, more, "en"), first);
        this.said = first.said;
        this.more = List.copyOf(more);
    }

    /**
     * All these faults as one; the only one itself.
     *
     * @param faults one at least; behind the first of very many stands how many are left out
     */
    public static CatalogueException of(List<CatalogueException> faults) {
        CatalogueException first = faults.get(0);
        if (faults.size() == 1) return first;
        if (faults.size() <= MOST_TOLD)
            return new CatalogueException(first, faults.subList(1, faults.size()));
        List<CatalogueException> told = new ArrayList<>(faults.subList(1, MOST_TOLD));
        told.add(new CatalogueException(Phrase.of("faults.more", faults.size() - MOST_TOLD)));
        return new CatalogueException(first, told);
    }

    /** Refuses a catalogue, with the place in front of the reason. */
    public CatalogueException(Path place, Phrase reason, Throwable cause) {
        this(Phrase.of("folder.at", place.toString(), reason), cause);
    }

    /** The message in any language; of several faults the first. */
    public Phrase phrase() {
        return said;
    }

    /** The faults it stands for, each alone. */
    public List<CatalogueException> all() {
        if (more.isEmpty()) return List.of(this);
        List<CatalogueException> all = new ArrayList<>(List.of(new CatalogueException(said)));
        all.addAll(more);
        return all;
    }

    /**
     * The message in that language.
     *
     * @param language such as "ru"
     */
    public String in(String language) {
        return joined(this, more, language);
    }

    private static String joined(
            CatalogueException first, List<CatalogueException> more, String language) {
        return Stream.concat(Stream.of(first.said), more.stream().map(CatalogueException::phrase))
                .map(one -> one.in(language))
                .collect(joining("; "));
    }
}
