package rasterlab.app.model;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import rasterlab.app.outcome.Complaint;

/** The folder of a file, out of which no name in it leads. */
final class OwnFolder {
    private final String place;
    private final Path folder;

    /**
     * @param file exists
     */
    OwnFolder(Path file) throws IOException {
        this(file, file.toString());
    }

    /**
     * @param place what complaints begin with
     */
    OwnFolder(Path file, String place) throws IOException {
        this.place = place;
        folder = file.toAbsolutePath().getParent().toRealPath();
    }

    /**
     * The file that a name stands for, links followed; empty where there is none.
     *
     * @throws Complaint if the name leads out of the folder, or to something that is no file
     */
    Optional<Path> find(String name) throws IOException {
        Path asked;
        try {
            asked = folder.resolve(name.replace('\\', '/')).normalize();
        } catch (InvalidPathException e) {
            throw Complaint.badInput(place + ": '" + name + "' cannot be a file's name");
        }
        if (!asked.startsWith(folder)) throw outside(name);
        if (!Files.exists(asked)) return Optional.empty();
        Path real = asked.toRealPath();
        if (!real.startsWith(folder)) throw outside(name);
        if (!Files.isRegularFile(real))
            throw Complaint.badInput(place + ": '" + name + "' is no file");
        return Optional.of(real);
    }

    private Complaint outside(String name) {
        return Complaint.badInput(
                place + ": '" + name + "' leads out of the file's folder, which is not allowed");
    }
}
