package rasterlab.app.canvas;

import java.util.Optional;
import java.util.function.BiPredicate;
import java.util.function.Function;
import java.util.function.Supplier;

/**
 * Brings back what a lab showed of the user's files: they are read once more, while something of
 * the lab's stands in their place, and shown unless the user has chosen another meanwhile.
 *
 * @param <K> names the files
 * @param <S> what a lab shows
 */
public final class KeptFile<K, S> implements Kept<K> {
    private final Class<K> type;
    private final Supplier<S> shown;
    private final Function<S, K> files;
    private final Function<S, ?> place;
    private final BiPredicate<K, S> reading;
    private Optional<Coming<K, S>> coming = Optional.empty();

    private record Coming<K, S>(K files, S inTheirPlace) {}

    /**
     * @param files of what is shown
     * @param place the part of what is shown that files take the place of, with {@code equals}
     * @param reading begins to read files, unless there are none, and says which; told too what was
     *     shown when that was first asked. When it is done, {@link #awaited} is to be asked
     */
    public KeptFile(
            Class<K> type,
            Supplier<S> shown,
            Function<S, K> files,
            Function<S, ?> place,
            BiPredicate<K, S> reading) {
        this.type = type;
        this.shown = shown;
        this.files = files;
        this.place = place;
        this.reading = reading;
    }

    @Override
    public Class<K> keptType() {
        return type;
    }

    /** Also what is still being read. */
    @Override
    public K kept() {
        return coming().map(Coming::files).orElseGet(() -> files.apply(shown.get()));
    }

    @Override
    public void bringBack(K kept) {
        coming = Optional.of(new Coming<>(kept, shown.get()));
        read();
    }

    /** Files that the user opened stand in their place: these are not awaited any more. */
    public void forget() {
        coming = Optional.empty();
    }

    /** Reads those still awaited once more: what the user opened came before them, to nothing. */
    public void again() {
        coming = coming();
        read();
    }

    private void read() {
        coming = coming.filter(one -> reading.test(one.files(), one.inTheirPlace()));
    }

    private Optional<Coming<K, S>> coming() {
        return coming.filter(
                one -> place.apply(one.inTheirPlace()).equals(place.apply(shown.get())));
    }

    /** As what the files that were read just now are to be shown; asked once. */
    public Optional<K> awaited() {
        Optional<K> awaited = coming().map(Coming::files);
        coming = Optional.empty();
        return awaited;
    }
}
