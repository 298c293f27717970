package rasterlab.app.outcome;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.AccessMode;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Every file that the user names is read by way of this: only regular files of a stated size are.
 *
 * <p>A pipe would be waited for and a device such as /dev/zero read without end. Links are
 * followed.
 */
public final class FileToRead {
    private FileToRead() {}

    /**
     * Why the file cannot be read, without its name; empty where it can.
     *
     * @param kind what it should be
     */
    public static Optional<String> obstacle(Path file, FileKind kind) {
        try {
            file.getFileSystem().provider().checkAccess(file, AccessMode.READ);
            if (Files.isDirectory(file)) return Optional.of("is a folder, not " + kind);
            if (!Files.isRegularFile(file))
                return Optional.of("is a device, pipe or socket, not " + kind);
            long size = Files.size(file);
            return size > kind.most() ? Optional.of(tooLong(size, kind)) : Optional.empty();
        } catch (AccessDeniedException e) {
            return Optional.of("no right to read it");
        } catch (NoSuchFileException e) {
            return Optional.of("no such file to read");
        } catch (IOException e) {
            return Optional.of("cannot be read: " + WholeFile.reason(e));
        }
    }

    private static String tooLong(long bytes, FileKind kind) {
        return "has %d bytes, %s has at most %d".formatted(bytes, kind, kind.most());
    }

    /**
     * Passes if the file can be read.
     *
     * @throws Complaint if it is not there, no regular file, too large, or the user has no right to
     *     read it
     */
    public static void require(Path file, FileKind kind) {
        Optional<String> obstacle = obstacle(file, kind);
        if (obstacle.isPresent()) throw Complaint.badInput(file + ": " + obstacle.get());
    }

    /**
     * The file's bytes, one after the other.
     *
     * @return throws a {@link Complaint} where the file grows beyond what its kind may have
     * @throws Complaint as {@link #require}
     */
    public static InputStream stream(Path file, FileKind kind) throws IOException {
        require(file, kind);
        return new BoundedStream(
                Files.newInputStream(file),
                kind.most(),
                () -> Complaint.badInput(file + ": " + tooLong(kind.most() + 1L, kind)));
    }

    /**
     * All of a text in UTF-8.
     *
     * @throws Complaint as {@link #require}, and if it is no such text
     */
    public static String text(Path file, FileKind kind) {
        byte[] bytes;
        try (InputStream in = stream(file, kind)) {
            bytes = in.readAllBytes();
        } catch (IOException e) {
            throw Complaint.badInput(file + ": cannot be read: " + WholeFile.reason(e));
        }
        Optional<String> obstacle = TextEncoding.obstacle(bytes);
        if (obstacle.isEmpty()) return new String(bytes, StandardCharsets.UTF_8);
        Optional<PictureSign> sign = PictureSign.in(bytes);
        String what = sign.map(of -> of.obstacle(kind)).orElse(obstacle.get());
        throw Complaint.badInput(file + ": " + what);
    }

    /**
     * Passes unless the file begins as a picture does.
     *
     * @throws Complaint as {@link #require}, and if it is a picture
     */
    public static void requireNoPicture(Path file, FileKind kind) throws IOException {
        try (InputStream in = stream(file, kind)) {
            Optional<PictureSign> sign = PictureSign.in(in.readNBytes(PictureSign.LENGTH));
            if (sign.isPresent()) throw Complaint.badInput(file + ": " + sign.get().obstacle(kind));
        }
    }
}
