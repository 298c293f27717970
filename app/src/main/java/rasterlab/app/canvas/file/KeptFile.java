package rasterlab.app.canvas.file;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rasterlab.app.canvas.work.LatestReading;

/**
 * Opens the user's files in a lab, and brings back what the lab showed of them in an earlier run:
 * that is read once more, while something of the lab's stands in its place, and shown unless the
 * user has chosen another meanwhile.
 *
 * <p>What the user opens goes first. What is brought back waits for it, is forgotten where it is
 * shown, and is read again where it is not.
 *
 * @param <K> names the files
 * @param <S> what the lab shows
 * @param <A> what was read, or why nothing was
 */
public final class KeptFile<K, S, A> implements Kept<K> {
    /** Reads files and shows them. */
    public interface FileLab<K, S, A> {
        Class<K> keptType();

        S shown();

        /** The files in what is shown. */
        K files(S shown);

        /** The part of what is shown that files take the place of, with {@code equals}. */
        Object place(S shown);

        /**
         * The reader of kept files, on any thread; empty where there are none.
         *
         * @param before what was shown when they were first asked for
         */
        Optional<Supplier<A>> reading(K kept, S before);

        /** Shows what the user opened, or tells why not; whether it is shown. */
        boolean open(A read);

        /** Shows what was kept, if it can; answers what is to be told of it, "" for nothing. */
        String restore(K kept, A read);

        /** The last remark on files; "" for none. */
        String remark();

        void tell(String problem);
    }

    private final FileLab<K, S, A> lab;
    private final Consumer<Supplier<Runnable>> reader;
    private Optional<Coming<K, S>> coming = Optional.empty();
    private int asked;
    private int answered;

    private record Coming<K, S>(K files, S inTheirPlace) {}

    /**
     * @param reader as {@link LatestReading}: runs on the lab's thread what a reading answers,
     *     unless a newer one has come meanwhile
     */
    public KeptFile(FileLab<K, S, A> lab, Consumer<Supplier<Runnable>> reader) {
        this.lab = lab;
        this.reader = reader;
    }

    /** Reads what the user opens, and shows it. */
    public void open(Supplier<A> reading) {
        int number = ++asked;
        read(reading, read -> opened(number, read));
    }

    @Override
    public Class<K> keptType() {
        return lab.keptType();
    }

    /** The files to keep, also while they are still being read. */
    @Override
    public K kept() {
        return coming().map(Coming::files).orElseGet(() -> lab.files(lab.shown()));
    }

    @Override
    public void restore(K kept) {
        coming = Optional.of(new Coming<>(kept, lab.shown()));
        readComing();
    }

    /** The files that are being read, as long as what they shall replace still stands there. */
    private Optional<Coming<K, S>> coming() {
        return coming.filter(one -> lab.place(one.inTheirPlace()).equals(lab.place(lab.shown())));
    }

    private void opened(int number, A read) {
        answered = number;
        coming = lab.open(read) ? Optional.empty() : coming();
        readComing();
    }

    private boolean usersIsRead() {
        return answered < asked;
    }

    private void readComing() {
        if (usersIsRead()) return;
        Optional<Supplier<A>> reading =
                coming.flatMap(one -> lab.reading(one.files(), one.inTheirPlace()));
        if (reading.isEmpty()) coming = Optional.empty();
        else read(reading.get(), this::restored);
    }

    private void restored(A read) {
        if (usersIsRead()) return;
        Optional<Coming<K, S>> awaited = coming();
        coming = Optional.empty();
        if (awaited.isEmpty()) return;
        String users = lab.remark();
        String own = lab.restore(awaited.get().files(), read);
        lab.tell(
                Stream.of(users, own)
                        .filter(said -> !said.isEmpty())
                        .collect(Collectors.joining("; besides, ")));
    }

    private void read(Supplier<A> reading, Consumer<A> then) {
        reader.accept(
                () -> {
                    A read = reading.get();
                    return () -> then.accept(read);
                });
    }
}
