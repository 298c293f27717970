package rasterlab.app.exercise;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.FileKind;
import rasterlab.app.outcome.FileToRead;
import rasterlab.app.outcome.WholeFile;

/**
 * One exercise's source on the disk, held by one window.
 *
 * <p>Each window that has the exercise open holds a file of its own, {@code ID.java}, {@code
 * ID.2.java}, …, by a lock that ends with the process: two windows never write the same file. What
 * is handed in as JSON ends with {@code .json}; earlier versions of the window named that {@code
 * .java}, too, and such a file is renamed when it is taken.
 */
public final class DraftFile implements Closeable {
    /** Windows at once, and the number of drafts kept of one exercise. */
    static final int MOST = 9;

    /** The ending of every draft of earlier versions. */
    private static final String EARLIER = "java";

    /** The text that another window wrote. */
    public record Other(String file, Instant changed, String text) {}

    private final Path folder;
    private final String exercise;
    private final String ending;
    private final int number;
    private final FileChannel held;
    private final Optional<String> found;

    private DraftFile(
            Path folder,
            String exercise,
            String ending,
            int number,
            FileChannel held,
            Optional<String> found) {
        this.folder = folder;
        this.exercise = exercise;
        this.ending = ending;
        this.number = number;
        this.held = held;
        this.found = found;
    }

    /**
     * Takes the first file that no other window holds. One that cannot be read as text is passed
     * over, so that it is not written over.
     *
     * @param folder made where it is missing
     * @param ending of the file's name, without the dot
     * @throws IOException if no file there can be held
     */
    static DraftFile hold(Path folder, String exercise, String ending) throws IOException {
        Files.createDirectories(folder);
        for (int number = 1; number <= MOST; number++) {
            Optional<FileChannel> held = held(folder.resolve(stem(exercise, number) + ".lock"));
            if (held.isEmpty()) continue;
            try {
                Path file = file(folder, exercise, number, ending);
                Path earlier = file(folder, exercise, number, EARLIER);
                if (!Files.exists(file) && Files.exists(earlier)) Files.move(earlier, file);
                return new DraftFile(folder, exercise, ending, number, held.get(), read(file));
            } catch (CharacterCodingException e) {
                held.get().close();
            } catch (IOException e) {
                held.get().close();
                throw e;
            }
        }
        throw new IOException("all " + MOST + " drafts of " + exercise + " are in use");
    }

    /** The lock of the file; empty where another window, of this process or another, holds it. */
    private static Optional<FileChannel> held(Path file) throws IOException {
        FileChannel channel =
                FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        try {
            FileLock lock = channel.tryLock();
            if (lock != null) return Optional.of(channel);
        } catch (OverlappingFileLockException heldByThisProcess) {
            channel.close();
            return Optional.empty();
        } catch (IOException e) {
            channel.close();
            throw e;
        }
        channel.close();
        return Optional.empty();
    }

    /** The text on the disk when the file was taken; for a later window, that of the first one. */
    Optional<String> found() {
        if (found.isPresent() || number == 1) return found;
        return others().stream().map(Other::text).findFirst();
    }

    /**
     * Replaces the file whole.
     *
     * @throws Complaint if it cannot be written
     */
    void write(String text) {
        WholeFile.write(path(number), text.getBytes(StandardCharsets.UTF_8));
    }

    /**
     * Keeps a text beside this file, as if another window had written it: in the first file that
     * there is not yet.
     *
     * @throws IOException if there is no place for one more
     * @throws Complaint if it cannot be written
     */
    void keepBeside(String text) throws IOException {
        for (int each = 1; each <= MOST; each++) {
            if (each == number || Files.exists(path(each))) continue;
            Optional<FileChannel> place = held(folder.resolve(stem(exercise, each) + ".lock"));
            if (place.isEmpty()) continue;
            try {
                WholeFile.write(path(each), text.getBytes(StandardCharsets.UTF_8));
                return;
            } finally {
                place.get().close();
            }
        }
        throw new IOException("all " + MOST + " drafts of " + exercise + " are in use");
    }

    /** The readable texts of other windows, in the order of the windows. */
    List<Other> others() {
        List<Other> others = new ArrayList<>();
        for (int each = 1; each <= MOST; each++) {
            if (each == number) continue;
            Path file = path(each);
            try {
                Optional<String> text = read(file);
                if (text.isPresent())
                    others.add(
                            new Other(
                                    file.getFileName().toString(),
                                    Files.getLastModifiedTime(file).toInstant(),
                                    text.get()));
            } catch (IOException unreadable) {
                continue;
            }
        }
        return others;
    }

    Path path() {
        return path(number);
    }

    /** The file of what was said to the text. */
    Path outcomePath() {
        return folder.resolve(stem(exercise, number) + ".result.json");
    }

    private Path path(int of) {
        return file(folder, exercise, of, ending);
    }

    private static Path file(Path folder, String exercise, int number, String ending) {
        return folder.resolve(stem(exercise, number) + "." + ending);
    }

    private static String stem(String exercise, int number) {
        return number == 1 ? exercise : exercise + "." + number;
    }

    private static Optional<String> read(Path file) throws IOException {
        if (!Files.exists(file)) return Optional.empty();
        if (FileToRead.obstacle(file, FileKind.DRAFT).isPresent())
            throw new CharacterCodingException();
        ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(file));
        return Optional.of(StandardCharsets.UTF_8.newDecoder().decode(bytes).toString());
    }

    /** Lets another window hold it. */
    @Override
    public void close() throws IOException {
        held.close();
    }
}
