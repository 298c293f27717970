package rasterlab.app.exercise;

import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.WholeFile;

/**
 * The sources as they are typed: each change is written to the disk on a thread of its own, of
 * several quick ones the last.
 *
 * <p>Where nothing can be written the text stays in memory, every change tries again, and the
 * reason is told.
 */
final class Drafts implements AutoCloseable {
    private final Path folder;
    private final UnaryOperator<String> endings;
    private final Consumer<Saving> told;
    private final Thread writer = new Thread(this::writeAll, "drafts");
    private final Map<String, DraftFile> files = new HashMap<>();
    private final Map<String, String> waiting = new LinkedHashMap<>();
    private final Map<String, UnsavedDraft> unsaved = new LinkedHashMap<>();
    private final Map<String, String> unread = new HashMap<>();
    private boolean writing;
    private boolean closed;

    /**
     * How a change fared.
     *
     * @param problem why it is not on the disk; empty when it is
     */
    record Saving(String exercise, String problem) {}

    /**
     * @param endings of the names of an exercise's files, without the dot
     * @param told each change's fate, on the writer's thread
     */
    Drafts(Path folder, UnaryOperator<String> endings, Consumer<Saving> told) {
        this.folder = folder;
        this.endings = endings;
        this.told = told;
        writer.setDaemon(true);
        writer.start();
    }

    /** The kept text of that exercise; empty where there is none or it cannot be read. */
    synchronized Optional<String> open(String exercise) {
        try {
            return file(exercise).found();
        } catch (IOException e) {
            unread.put(exercise, problem(e));
            told.accept(new Saving(exercise, problem(e)));
            return Optional.empty();
        }
    }

    /** The texts that other windows wrote for that exercise. */
    synchronized List<DraftFile.Other> others(String exercise) {
        DraftFile file = files.get(exercise);
        return file == null ? List.of() : file.others();
    }

    /**
     * Keeps a text beside the exercise's own, among those of other windows.
     *
     * @throws IOException if it cannot be kept
     * @throws Complaint if it cannot be written
     */
    synchronized void keepBeside(String exercise, String text) throws IOException {
        DraftFile file = file(exercise);
        if (file.others().stream().noneMatch(one -> one.text().equals(text))) file.keepBeside(text);
    }

    /** The texts that other windows wrote to it, but for that text. */
    List<DraftFile.Other> others(String exercise, String own) {
        return others(exercise).stream().filter(one -> !one.text().equals(own)).toList();
    }

    /** Where the exercise's text is; empty before it was written. */
    synchronized Optional<Path> path(String exercise) {
        return Optional.ofNullable(files.get(exercise)).map(DraftFile::path).filter(Files::exists);
    }

    /** Where what was said to the exercise's text is; empty before that is opened. */
    synchronized Optional<Path> outcomePath(String exercise) {
        return Optional.ofNullable(files.get(exercise)).map(DraftFile::outcomePath);
    }

    synchronized void save(String exercise, String text) {
        waiting.put(exercise, text);
        notifyAll();
    }

    /** Why the exercise's text is not on the disk, or cannot be; "" when nothing is in the way. */
    synchronized String problem(String exercise) {
        UnsavedDraft draft = unsaved.get(exercise);
        return draft == null ? unread.getOrDefault(exercise, "") : draft.problem();
    }

    /** The texts that could not be written, not even just now. */
    List<UnsavedDraft> unsaved() throws InterruptedException {
        settle();
        synchronized (this) {
            unsaved.forEach((exercise, draft) -> waiting.put(exercise, draft.text()));
            notifyAll();
        }
        settle();
        synchronized (this) {
            return List.copyOf(unsaved.values());
        }
    }

    /** Waits until every change so far is written or told to be impossible. */
    synchronized void settle() throws InterruptedException {
        while (writing || !waiting.isEmpty()) wait();
    }

    /**
     * Writes what waits and lets other windows have the files, each whatever became of the others.
     *
     * @throws UncheckedIOException for the first that could not be let go; the others' reasons are
     *     suppressed in it
     */
    @Override
    public void close() {
        synchronized (this) {
            closed = true;
            notifyAll();
        }
        try {
            writer.join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        closeAll(List.copyOf(files.values()));
    }

    static void closeAll(List<? extends Closeable> files) {
        var failures = new ArrayList<IOException>();
        for (Closeable file : files) {
            try {
                file.close();
            } catch (IOException e) {
                failures.add(e);
            }
        }
        if (failures.isEmpty()) return;
        IOException first = failures.get(0);
        failures.subList(1, failures.size()).forEach(first::addSuppressed);
        throw new UncheckedIOException(first);
    }

    private void writeAll() {
        for (Optional<Saving> next = next(); next.isPresent(); next = next())
            told.accept(next.get());
    }

    /** Writes one change and says how it fared; empty when closed and all is written. */
    private Optional<Saving> next() {
        String exercise;
        String text;
        synchronized (this) {
            writing = false;
            notifyAll();
            try {
                while (waiting.isEmpty() && !closed) wait();
            } catch (InterruptedException e) {
                closed = true;
            }
            if (waiting.isEmpty()) return Optional.empty();
            exercise = waiting.keySet().iterator().next();
            text = waiting.remove(exercise);
            writing = true;
        }
        String problem = written(exercise, text);
        synchronized (this) {
            unread.remove(exercise);
            if (problem.isEmpty()) unsaved.remove(exercise);
            else unsaved.put(exercise, new UnsavedDraft(exercise, text, problem));
        }
        return Optional.of(new Saving(exercise, problem));
    }

    private String written(String exercise, String text) {
        try {
            DraftFile file;
            synchronized (this) {
                file = file(exercise);
            }
            file.write(text);
            return "";
        } catch (IOException e) {
            return problem(e);
        } catch (Complaint e) {
            return e.getMessage();
        }
    }

    private DraftFile file(String exercise) throws IOException {
        DraftFile file = files.get(exercise);
        if (file == null) {
            file = DraftFile.hold(folder, exercise, endings.apply(exercise));
            files.put(exercise, file);
        }
        return file;
    }

    private String problem(IOException e) {
        return folder + ": " + WholeFile.reason(e);
    }
}
