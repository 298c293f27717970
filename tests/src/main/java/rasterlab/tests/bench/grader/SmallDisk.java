package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.nio.file.Path;

/** A file system in memory that is mounted until this is closed. */
final class SmallDisk implements AutoCloseable {
    /** The size of the disk: more than the room below which a server takes nothing in. */
    private static final int MEBIBYTES = 160;

    private final Path path;
    private boolean mounted;

    /**
     * @param path of an empty folder
     */
    SmallDisk(Path path) {
        this.path = path;
    }

    Path path() {
        return path;
    }

    /**
     * Mounts it.
     *
     * @throws NotMeasured where this process may not
     */
    synchronized SmallDisk mount() throws InterruptedException, NotMeasured {
        try {
            String size = "size=" + MEBIBYTES + "m";
            SystemCommand.run("mount", "-t", "tmpfs", "-o", size, "tmpfs", path.toString());
        } catch (IOException refused) {
            throw new NotMeasured("grader.missing.mount", refused.getMessage());
        }
        mounted = true;
        return this;
    }

    @Override
    public synchronized void close() throws IOException {
        if (mounted) SystemCommand.runAtEnd("umount", path.toString());
    }
}
