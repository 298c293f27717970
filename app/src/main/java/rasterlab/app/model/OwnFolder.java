package rasterlab.app.model;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.PictureFile;
import rasterlab.app.outcome.WholeFile;
import rasterlab.engine.texture.Texture;

/** The folder of a file, out of which no name in it leads. */
final class OwnFolder {
    private final Path folder;

    /** A picture in the folder, and where it is. */
    record LocatedPicture(Path file, Texture texture) {}

    /**
     * @param file exists
     */
    OwnFolder(Path file) throws IOException {
        folder = file.toAbsolutePath().getParent().toRealPath();
    }

    /**
     * The file that a name stands for, links followed; empty where there is none.
     *
     * @throws Complaint if the name leads out of the folder
     * @throws IOException if it cannot be told what is there
     */
    Optional<Path> find(String name) throws IOException {
        Path asked;
        try {
            asked = folder.resolve(name.replace('\\', '/')).normalize();
        } catch (InvalidPathException e) {
            throw Complaint.badInput("'" + name + "' cannot be a file's name");
        }
        if (!asked.startsWith(folder)) throw outside(name);
        try {
            Path real = asked.toRealPath();
            if (!real.startsWith(folder)) throw outside(name);
            return Optional.of(real);
        } catch (NoSuchFileException e) {
            return Optional.empty();
        }
    }

    private static Complaint outside(String name) {
        return Complaint.badInput(
                "'" + name + "' leads out of the file's folder, which is not allowed");
    }

    /**
     * The picture of that name.
     *
     * @throws Complaint if there is none, or it cannot be read
     */
    LocatedPicture picture(String name) {
        try {
            Optional<Path> found = find(name);
            if (found.isPresent())
                return new LocatedPicture(found.get(), PictureFile.texture(found.get()));
        } catch (IOException e) {
            throw Complaint.badInput(
                    "texture '%s' cannot be read: %s".formatted(name, WholeFile.reason(e)));
        }
        throw Complaint.badInput("there is no texture '%s' in its folder".formatted(name));
    }
}
