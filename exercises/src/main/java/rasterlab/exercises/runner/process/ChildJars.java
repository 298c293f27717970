package rasterlab.exercises.runner.process;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import rasterlab.exercises.child.CompileMain;
import rasterlab.exercises.child.RunMain;
import rasterlab.exercises.child.SinkSheets;
import rasterlab.exercises.topic.TopicGradings;

/**
 * The two jars that children get, in a temporary folder of our own: the harness and the contract;
 * and beside them the filter of their system calls, empty where there is none for this machine.
 * Where somebody cleans temporary folders while the judge lives, they are made anew.
 */
public final class ChildJars implements AutoCloseable {
    private static final String CONTRACT = "contract.jar";
    private static final String CONTRACTS = "rasterlab/contract/";
    private static final String HARNESS = "harness.jar";
    private static final String FILTER = "system-calls.bpf";
    private static final List<String> FILES = List.of(CONTRACT, HARNESS, FILTER);

    private final Path parent;
    private ChildFolder folder;

    private ChildJars(Path parent) throws IOException {
        this.parent = parent;
        ChildFolder.removeLeftovers(parent, FILES);
        folder = filled();
    }

    public static ChildJars assemble() {
        return assemble(Path.of(System.getProperty("java.io.tmpdir")));
    }

    /**
     * @param parent where the folder is made
     */
    static ChildJars assemble(Path parent) {
        try {
            return new ChildJars(parent);
        } catch (IOException e) {
            throw new UncheckedIOException("cannot prepare the children's jars", e);
        }
    }

    private ChildFolder filled() throws IOException {
        ChildFolder made = ChildFolder.create(parent, FILES);
        try {
            fill(made.path());
            return made;
        } catch (IOException e) {
            made.close();
            throw e;
        }
    }

    private static void fill(Path folder) throws IOException {
        Map<String, byte[]> contracts = new TreeMap<>();
        for (Class<?> contract : TopicGradings.contracts())
            contracts.putAll(ClassFiles.closure(contract, CONTRACTS));
        for (Class<?> kind : SinkSheets.kinds())
            contracts.putAll(ClassFiles.closure(kind, CONTRACTS));
        write(folder.resolve(CONTRACT), contracts);
        Map<String, byte[]> harness = new TreeMap<>();
        String own = RunMain.class.getPackageName().replace('.', '/') + '/';
        harness.putAll(ClassFiles.closure(RunMain.class, own));
        harness.putAll(ClassFiles.closure(CompileMain.class, own));
        write(folder.resolve(HARNESS), harness);
        Files.write(folder.resolve(FILTER), SystemCallFilter.program().orElse(new byte[0]));
    }

    private static void write(Path jar, Map<String, byte[]> classes) throws IOException {
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(jar))) {
            for (Map.Entry<String, byte[]> one : classes.entrySet()) {
                ZipEntry entry = new ZipEntry(one.getKey());
                // the same classes make the same jar, by which images of Java are known
                entry.setTimeLocal(LocalDateTime.of(1980, 1, 1, 0, 0));
                zip.putNextEntry(entry);
                zip.write(one.getValue());
            }
        }
    }

    /** The classes that a student's source may see. */
    public Path contract() {
        return folder().resolve(CONTRACT);
    }

    public Path harness() {
        return folder().resolve(HARNESS);
    }

    /** The system calls that a child may make, as the kernel reads them. */
    public Path filter() {
        return folder().resolve(FILTER);
    }

    /**
     * Holds the two jars, the filter and nothing else to read; another one after the first was
     * taken away.
     */
    public synchronized Path folder() {
        try {
            if (!folder.intact()) {
                folder.close();
                folder = filled();
            }
            return folder.path();
        } catch (IOException e) {
            throw new UncheckedIOException("cannot prepare the children's jars again", e);
        }
    }

    @Override
    public synchronized void close() {
        try {
            folder.close();
        } catch (IOException e) {
            throw new UncheckedIOException("cannot remove " + folder.path(), e);
        }
    }
}
