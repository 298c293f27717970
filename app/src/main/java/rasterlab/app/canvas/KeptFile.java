package rasterlab.app.canvas;

import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.Supplier;

/**
 * Brings back what a lab showed of the user's files: they are read once more, while something of
 * the lab's stands in their place, and shown unless the user has chosen another meanwhile.
 *
 * @param <K> names the files
 */
public final class KeptFile<K> implements Kept<K> {
    private final Class<K> type;
    private final Supplier<K> present;
    private final Supplier<?> standing;
    private final Predicate<K> reading;
    private Optional<Coming<K>> coming = Optional.empty();

    private record Coming<K>(K files, Object inTheirPlace) {}

    /**
     * @param present the files of what is shown now
     * @param standing what of the lab's is shown now, with {@code equals}
     * @param reading begins to read files, unless there are none, and says which; when that is done
     *     {@link #awaited} is to be asked
     */
    public KeptFile(
            Class<K> type, Supplier<K> present, Supplier<?> standing, Predicate<K> reading) {
        this.type = type;
        this.present = present;
        this.standing = standing;
        this.reading = reading;
    }

    @Override
    public Class<K> keptType() {
        return type;
    }

    /** Also what is still being read. */
    @Override
    public K kept() {
        return coming().map(Coming::files).orElseGet(present);
    }

    @Override
    public void bringBack(K files) {
        coming = Optional.of(new Coming<>(files, standing.get()));
        if (!reading.test(files)) coming = Optional.empty();
    }

    /** Files that the user opened stand in their place: these are not awaited any more. */
    public void forget() {
        coming = Optional.empty();
    }

    private Optional<Coming<K>> coming() {
        return coming.filter(one -> one.inTheirPlace().equals(standing.get()));
    }

    /** As what the files that were read just now are to be shown; asked once. */
    public Optional<K> awaited() {
        Optional<K> awaited = coming().map(Coming::files);
        coming = Optional.empty();
        return awaited;
    }
}
