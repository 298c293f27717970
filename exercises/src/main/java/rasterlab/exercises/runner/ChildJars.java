package rasterlab.exercises.runner;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import rasterlab.contract.LineRasterizer;
import rasterlab.exercises.runner.child.CompileMain;
import rasterlab.exercises.runner.child.RunMain;

/**
 * The two jars that children get, in a temporary folder of our own: the harness and the contract.
 */
final class ChildJars implements AutoCloseable {
    private final Path folder;

    private ChildJars(Path folder) {
        this.folder = folder;
    }

    static ChildJars assemble() {
        try {
            ChildJars jars = new ChildJars(Files.createTempDirectory("rasterlab-children-"));
            write(jars.contract(), ClassFiles.closure(LineRasterizer.class, "rasterlab/contract/"));
            Map<String, byte[]> harness = new TreeMap<>();
            String own = RunMain.class.getPackageName().replace('.', '/') + '/';
            harness.putAll(ClassFiles.closure(RunMain.class, own));
            harness.putAll(ClassFiles.closure(CompileMain.class, own));
            write(jars.harness(), harness);
            return jars;
        } catch (IOException e) {
            throw new UncheckedIOException("cannot prepare the children's jars", e);
        }
    }

    private static void write(Path jar, Map<String, byte[]> classes) throws IOException {
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(jar))) {
            for (Map.Entry<String, byte[]> one : classes.entrySet()) {
                zip.putNextEntry(new ZipEntry(one.getKey()));
                zip.write(one.getValue());
            }
        }
    }

    /** What a student's source may see. */
    Path contract() {
        return folder.resolve("contract.jar");
    }

    Path harness() {
        return folder.resolve("harness.jar");
    }

    /** An empty place to start a child in would be this folder: it holds the two jars only. */
    Path folder() {
        return folder;
    }

    @Override
    public void close() {
        try {
            Files.deleteIfExists(contract());
            Files.deleteIfExists(harness());
            Files.deleteIfExists(folder);
        } catch (IOException e) {
            throw new UncheckedIOException("cannot remove " + folder, e);
        }
    }
}
