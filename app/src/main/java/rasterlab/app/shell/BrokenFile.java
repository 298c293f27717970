package rasterlab.app.shell;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;

/** A file of the user's that cannot be used and that the next writing would replace. */
final class BrokenFile {
    private BrokenFile() {}

    /**
     * Sets the file aside beside its place, over one that was set aside before.
     *
     * @return where it is now
     * @throws IOException if it is still in its place, as what is no plain file
     */
    static Path setAside(Path file) throws IOException {
        if (!Files.isRegularFile(file)) throw new IOException("it is no file");
        Path aside = file.resolveSibling(file.getFileName() + ".broken");
        return Files.move(file, aside, StandardCopyOption.ATOMIC_MOVE);
    }
}
