package rasterlab.exercises.catalogue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.score.Phrase;

/** The files of one exercise, from a folder or from the class path; remembers texts it read. */
final class ExerciseFolder {
    /**
     * The limit for a file, above any honest statement or case file; a mistaken file is named, not
     * loaded.
     */
    private static final int MOST_BYTES = 1 << 20;

    /** Opens a file of the folder by its name, "cases/open.json" for one in a sub-folder. */
    @FunctionalInterface
    interface Opener {
        /**
         * @throws IOException when there is no such file, or it cannot be read
         */
        InputStream open(String name) throws IOException;
    }

    private final String id;
    private final String place;
    private final Opener opener;
    private final boolean tested;
    private final Map<String, byte[]> read = new TreeMap<>();

    private ExerciseFolder(String id, String place, boolean tested, Opener opener) {
        this.id = id;
        this.place = place;
        this.tested = tested;
        this.opener = opener;
    }

    static ExerciseFolder onDisk(Path folder) {
        return new ExerciseFolder(
                folder.getFileName().toString(),
                folder.toString(),
                false,
                name -> DiskFiles.open(folder.resolve(name)));
    }

    static ExerciseFolder onClassPath(String id) {
        return new ExerciseFolder(
                id,
                "built-in exercise " + id,
                true,
                name -> {
                    InputStream in =
                            Catalogue.class.getResourceAsStream(
                                    "/rasterlab/exercises/" + id + "/" + name);
                    if (in == null) throw new IOException("not on the class path");
                    return in;
                });
    }

    static ExerciseFolder kept(String id, Map<String, byte[]> files) {
        return new ExerciseFolder(
                id,
                "kept exercise " + id,
                false,
                name -> {
                    byte[] content = files.get(name);
                    if (content == null) throw new IOException("not kept");
                    return new ByteArrayInputStream(content);
                });
    }

    String id() {
        return id;
    }

    /**
     * Whether the build has drawn every input of these files, so that whoever lists all exercises
     * need not draw them again.
     */
    boolean tested() {
        return tested;
    }

    /** The name of a file of this folder in messages. */
    String place(String file) {
        return place + "/" + file;
    }

    String text(String file) {
        byte[] bytes = content(file);
        read.put(file, bytes);
        try {
            return StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
        } catch (CharacterCodingException e) {
            throw new CatalogueException(Phrase.of("folder.utf", place(file)), e);
        }
    }

    /** The bytes of a file, which are not remembered. */
    byte[] content(String file) {
        if (!file.matches("[A-Za-z0-9][A-Za-z0-9._-]*(/[A-Za-z0-9][A-Za-z0-9._-]*)?"))
            throw new CatalogueException(Phrase.of("folder.name", place, file));
        return bytes(file);
    }

    /** Whether there is such a file that can be opened; what opens it tells why there is none. */
    boolean has(String file) {
        try (InputStream in = opener.open(file)) {
            return in != null;
        } catch (IOException | CatalogueException none) {
            return false;
        }
    }

    private byte[] bytes(String file) {
        try (InputStream in = opener.open(file)) {
            byte[] bytes = in.readNBytes(MOST_BYTES + 1);
            if (bytes.length > MOST_BYTES)
                throw new CatalogueException(Phrase.of("folder.long", place(file), MOST_BYTES));
            return bytes;
        } catch (IOException e) {
            throw new CatalogueException(
                    Phrase.of(
                            "folder.at",
                            place(file),
                            Phrase.of("disk.unread", String.valueOf(e.getMessage()))),
                    e);
        }
    }

    /** Name to content of all files read so far, by name. */
    Map<String, byte[]> read() {
        return read;
    }
}
