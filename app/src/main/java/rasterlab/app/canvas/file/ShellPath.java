package rasterlab.app.canvas.file;

import java.nio.file.Path;

/** Paths in commands that labs copy. */
public final class ShellPath {
    private ShellPath() {}

    /** The path as a POSIX shell takes it. */
    public static String quoted(Path file) {
        String path = file.toString();
        return path.matches("[\\w./-]+") ? path : "'" + path.replace("'", "'\\''") + "'";
    }
}
