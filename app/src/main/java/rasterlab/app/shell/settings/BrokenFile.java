package rasterlab.app.shell.settings;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.WholeFile;

/** A file of the user's of which all or a part cannot be used, and would be lost by writing. */
public final class BrokenFile {
    private BrokenFile() {}

    /**
     * Sets the file aside beside its place, over one that was set aside before.
     *
     * @return where it is now
     * @throws IOException if it is still in its place, as what is no plain file
     */
    public static Path setAside(Path file) throws IOException {
        if (!Files.isRegularFile(file)) throw new IOException("it is no file");
        return Files.move(file, aside(file), StandardCopyOption.ATOMIC_MOVE);
    }

    /**
     * Keeps what the file held at the same place, while the file stays in use.
     *
     * @return where it is now
     * @throws Complaint if it is not there, or not whole
     */
    public static Path keep(Path file, byte[] held) {
        Path aside = aside(file);
        WholeFile.write(aside, held);
        return aside;
    }

    private static Path aside(Path file) {
        return file.resolveSibling(file.getFileName() + ".broken");
    }
}
