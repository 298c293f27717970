package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/** A disk that a file fills to the last byte. */
final class FullDisk implements ServerFault {
    private static final int BLOCK = 1 << 12;

    private final Path data;
    private final Path filler;

    FullDisk(SmallDisk disk) {
        data = disk.path().resolve("course");
        filler = disk.path().resolve("filler");
    }

    @Override
    public Path data() {
        return data;
    }

    @Override
    public void begin(BenchServer server) throws IOException {
        try (OutputStream out = Files.newOutputStream(filler)) {
            fill(out);
        }
    }

    private void fill(OutputStream out) throws IOException {
        byte[] block = new byte[BLOCK];
        try {
            while (true) out.write(block);
        } catch (IOException full) {
            if (Files.getFileStore(filler).getUsableSpace() >= BLOCK) throw full;
        }
    }

    @Override
    public void end() throws IOException {
        Files.delete(filler);
    }
}
