package rasterlab.exercises.catalogue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.score.Phrase;

/**
 * The files of an instructor's folder. Only regular files are opened, since a pipe would be waited
 * for and a device such as /dev/zero read without end; links are followed.
 */
final class DiskFiles {
    private DiskFiles() {}

    /**
     * The folder's sub-folders by name; its other files are passed over, and whatever has a name
     * that begins with a dot, such as an editor's lock, which is a link to nothing.
     *
     * @throws CatalogueException naming what cannot be read, in one line
     */
    static List<Path> subFolders(Path folder) {
        List<Path> found = new ArrayList<>();
        for (Path entry : entries(folder))
            if (!entry.getFileName().toString().startsWith(".") && attributes(entry).isDirectory())
                found.add(entry);
        return found;
    }

    private static List<Path> entries(Path folder) {
        try (Stream<Path> entries = Files.list(folder)) {
            return entries.sorted().toList();
        } catch (NoSuchFileException e) {
            throw new CatalogueException(folder, Phrase.of("disk.folder-none"), e);
        } catch (NotDirectoryException e) {
            throw new CatalogueException(folder, Phrase.of("disk.folder-not"), e);
        } catch (AccessDeniedException e) {
            throw new CatalogueException(folder, Phrase.of("disk.folder-right"), e);
        } catch (IOException e) {
            throw new CatalogueException(folder, Phrase.of("disk.unlisted", reason(e)), e);
        }
    }

    private static BasicFileAttributes attributes(Path entry) {
        try {
            return Files.readAttributes(entry, BasicFileAttributes.class);
        } catch (AccessDeniedException e) {
            throw new CatalogueException(entry, Phrase.of("disk.right"), e);
        } catch (NoSuchFileException e) {
            throw new CatalogueException(entry, Phrase.of("disk.link"), e);
        } catch (IOException e) {
            throw new CatalogueException(entry, Phrase.of("disk.unread", reason(e)), e);
        }
    }

    /**
     * @throws CatalogueException naming the file and why it is not read, in one line
     */
    static InputStream open(Path file) {
        try {
            BasicFileAttributes found = Files.readAttributes(file, BasicFileAttributes.class);
            if (found.isDirectory())
                throw new CatalogueException(file, Phrase.of("disk.folder"), null);
            if (!found.isRegularFile())
                throw new CatalogueException(file, Phrase.of("disk.special"), null);
            return Files.newInputStream(file);
        } catch (NoSuchFileException e) {
            throw new CatalogueException(file, Phrase.of("disk.none"), e);
        } catch (AccessDeniedException e) {
            throw new CatalogueException(file, Phrase.of("disk.right"), e);
        } catch (IOException e) {
            throw new CatalogueException(file, Phrase.of("disk.unread", reason(e)), e);
        }
    }

    /** The message of the system, without the path that ours already has. */
    private static String reason(IOException e) {
        if (e instanceof FileSystemException file && file.getReason() != null)
            return file.getReason();
        return String.valueOf(e.getMessage());
    }
}
