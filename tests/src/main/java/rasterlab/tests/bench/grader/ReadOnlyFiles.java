package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A data folder that nothing can be written to. Linux makes no disk read-only on which a file is
 * open for writing, as a server's database always is, but by an error of the disk, which no remount
 * ends. So the folder and its files are made immutable: what has a file open is refused each write,
 * and who opens one gets it for reading only, as on a disk that became read-only.
 */
final class ReadOnlyFiles implements ServerFault, AutoCloseable {
    private final Path folder;
    private boolean begun;

    /**
     * @param folder in which the data folder will be
     */
    ReadOnlyFiles(Path folder) {
        this.folder = folder;
    }

    /**
     * Tries it on a file.
     *
     * @throws NotMeasured where this process may make nothing immutable
     */
    ReadOnlyFiles tried() throws IOException, InterruptedException, NotMeasured {
        Path trial = Files.createTempFile(folder, "immutable", "");
        try {
            SystemCommand.run("chattr", "+i", trial.toString());
            SystemCommand.run("chattr", "-i", trial.toString());
        } catch (IOException refused) {
            throw new NotMeasured("grader.missing.chattr", refused.getMessage());
        }
        Files.delete(trial);
        return this;
    }

    @Override
    public Path data() {
        return folder.resolve("course");
    }

    @Override
    public synchronized void begin(BenchServer server) throws IOException, InterruptedException {
        begun = true;
        SystemCommand.run("chattr", "-R", "+i", data().toString());
    }

    @Override
    public synchronized void end() throws IOException {
        SystemCommand.runAtEnd("chattr", "-R", "-i", data().toString());
        begun = false;
    }

    /** Makes it writable where it was left read-only. */
    @Override
    public synchronized void close() throws IOException {
        if (begun) end();
    }
}
