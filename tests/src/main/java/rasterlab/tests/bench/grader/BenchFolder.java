package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.sql.SQLException;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/** A new folder that is removed with all that is in it. */
record BenchFolder(Path path) implements AutoCloseable {
    private static final String LOG = "server.log";

    static BenchFolder make() throws IOException {
        return new BenchFolder(Files.createTempDirectory("rasterlab-bench-server"));
    }

    /** The file for what a server or a worker says on its standard error. */
    Path errors(String name) {
        return path.resolve(name + ".errors");
    }

    /**
     * Measures servers whose data is in the folder.
     *
     * @param <X> by which it says that it cannot
     */
    interface FolderWork<X extends Exception> {
        void run() throws IOException, InterruptedException, SQLException, X;
    }

    /**
     * Does that work.
     *
     * @throws LoggedFailure where it fails, with copies of the logs, which stay; what fails because
     *     this process is told to end leaves none
     */
    <X extends Exception> void keepingLogs(FolderWork<X> work)
            throws IOException, InterruptedException, SQLException, X {
        try {
            work.run();
        } catch (IOException | SQLException failed) {
            if (MeasuredLines.isProcessEnding()) throw failed;
            throw new LoggedFailure(failed, copyLogs());
        }
    }

    /** Copies what servers and workers said into a new folder, which is returned. */
    Path copyLogs() throws IOException {
        Path copies = Files.createTempDirectory("rasterlab-bench-logs");
        Files.walkFileTree(
                path,
                new SimpleFileVisitor<>() {
                    @Override
                    public FileVisitResult visitFile(Path file, BasicFileAttributes is)
                            throws IOException {
                        String name = file.getFileName().toString();
                        if (name.equals(LOG) || name.endsWith(".errors"))
                            Files.copy(file, copies.resolve(flat(file)));
                        return FileVisitResult.CONTINUE;
                    }

                    /** Servers that still run remove files. */
                    @Override
                    public FileVisitResult visitFileFailed(Path file, IOException gone) {
                        return FileVisitResult.CONTINUE;
                    }
                });
        return copies;
    }

    private String flat(Path file) {
        return path.relativize(file).toString().replaceAll("[/\\\\]", "-");
    }

    @Override
    public void close() throws IOException {
        List<Path> all;
        try (Stream<Path> found = Files.walk(path)) {
            all = found.sorted(Comparator.reverseOrder()).toList();
        }
        for (Path one : all) Files.deleteIfExists(one);
    }
}
