package rasterlab.exercises.runner.process;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.UserPrincipal;
import java.util.List;

/**
 * A temporary folder of one judge. A locked file in it tells other judges that its owner lives: the
 * system gives the lock back when a process ends, however it ends.
 */
final class ChildFolder implements AutoCloseable {
    private static final String PREFIX = "rasterlab-children-";
    private static final String LOCK = "lock";
    private static final String UNNAMED = "new-lock";

    /** Opening and closing a lock file of this very process would give up the lock on it. */
    private static final String OWN_PREFIX = PREFIX + ProcessHandle.current().pid() + "-";

    private final Path path;
    private final UserPrincipal owner;
    private final List<String> files;
    private final FileChannel lock;

    private ChildFolder(Path path, List<String> files) throws IOException {
        this.path = path;
        this.owner = Files.getOwner(path);
        this.files = files;
        // it is locked before it has its name: another judge would take an unlocked one for left
        Path unnamed = path.resolve(UNNAMED);
        this.lock =
                FileChannel.open(unnamed, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
        if (lock.tryLock() == null) throw new IOException(path + " is locked by another process");
        Files.move(unnamed, path.resolve(LOCK), StandardCopyOption.ATOMIC_MOVE);
    }

    /**
     * Makes a new folder that nobody else may enter.
     *
     * @param files what will be put into it
     */
    static ChildFolder create(Path parent, List<String> files) throws IOException {
        return new ChildFolder(Files.createTempDirectory(parent, OWN_PREFIX), files);
    }

    /** Removes the folders of judges that ended without doing so. */
    static void removeLeftovers(Path parent, List<String> files) throws IOException {
        try (DirectoryStream<Path> folders = Files.newDirectoryStream(parent, PREFIX + "*")) {
            for (Path folder : folders)
                if (!folder.getFileName().toString().startsWith(OWN_PREFIX) && abandoned(folder))
                    remove(folder, files);
        }
    }

    /** A folder without a lock file may be one that is just being made: it stays. */
    private static boolean abandoned(Path folder) {
        if (!Files.isWritable(folder.resolve(LOCK))) return false;
        try (FileChannel channel = openLock(folder);
                FileLock taken = channel.tryLock()) {
            return taken != null;
        } catch (IOException goneMeanwhile) {
            return false;
        }
    }

    private static FileChannel openLock(Path folder) throws IOException {
        return FileChannel.open(
                folder.resolve(LOCK), StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS);
    }

    /** Removes what a judge puts there; a folder that holds more than that stays. */
    private static void remove(Path folder, List<String> files) {
        try {
            for (String file : files) Files.deleteIfExists(folder.resolve(file));
            Files.deleteIfExists(folder.resolve(LOCK));
            Files.deleteIfExists(folder);
        } catch (IOException e) {
            System.getLogger(ChildFolder.class.getName())
                    .log(System.Logger.Level.WARNING, "cannot remove {0}: {1}", folder, e);
        }
    }

    Path path() {
        return path;
    }

    /** Whether all is there and ours: whoever cleans the temporary folder may have taken some. */
    boolean intact() throws IOException {
        return Files.isDirectory(path, LinkOption.NOFOLLOW_LINKS)
                && Files.getOwner(path, LinkOption.NOFOLLOW_LINKS).equals(owner)
                && Files.exists(path.resolve(LOCK))
                && files.stream().allMatch(file -> Files.exists(path.resolve(file)));
    }

    @Override
    public void close() throws IOException {
        lock.close();
        remove(path, files);
    }
}
