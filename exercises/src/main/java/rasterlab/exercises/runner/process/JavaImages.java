package rasterlab.exercises.runner.process;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import rasterlab.exercises.child.Frames;
import rasterlab.exercises.child.Wire;

/**
 * Keeps images of Java that have only the modules that children need, in a folder: jlink makes one
 * at the first start, and a program that is tried on it tells which classes to keep ready for a
 * quick start. Images of another Java, or for other classes of children, are made anew; those that
 * nobody needs any more are removed then.
 *
 * <p>Several processes may use one folder: one makes an image, the others wait for it. Making one
 * gives way to all else that the machine has to do, such as what is graded meanwhile.
 */
public final class JavaImages {
    private static final String PREFIX = "java-";
    private static final String UNFINISHED = "making-";

    /** A time far longer than jlink needs for all modules of Java on a slow machine. */
    private static final Duration PATIENCE = Duration.ofMinutes(3);

    private static final int MOST_SAID = 1 << 16;
    private static final Object MAKING = new Object();

    private final Path folder;
    private final Launcher launcher;
    private final String build;

    /**
     * @param folder made if missing
     * @param jars whose classes are run on the images
     */
    public JavaImages(Path folder, Launcher launcher, ChildJars jars) {
        this.folder = folder.toAbsolutePath();
        this.launcher = launcher;
        this.build = build(jars);
    }

    /** Whether the running Java has what images are made with. */
    public static boolean canMake() {
        return Files.isExecutable(jlink());
    }

    private static Path jlink() {
        return Programs.ofJava("jlink");
    }

    /** Changes with the running Java and with the classes of children. */
    private static String build(ChildJars jars) {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            for (String name : List.of("java.vm.name", "java.vm.version", "os.arch"))
                digest.update(System.getProperty(name).getBytes(StandardCharsets.UTF_8));
            digest.update(Programs.javaHome().toString().getBytes(StandardCharsets.UTF_8));
            for (Path jar : List.of(jars.harness(), jars.contract()))
                digest.update(Files.readAllBytes(jar));
            return HexFormat.of().formatHex(digest.digest(), 0, 8);
        } catch (NoSuchAlgorithmException | IOException e) {
            throw new IllegalStateException("cannot name the images of Java", e);
        }
    }

    /**
     * Whether an image is there already.
     *
     * @param name of the kind of children
     */
    public boolean has(String name, List<String> modules) {
        return Files.isDirectory(place(name, modules));
    }

    private Path place(String name, List<String> modules) {
        String whole = name + "-" + Integer.toHexString(modules.hashCode());
        return folder.resolve(PREFIX + build).resolve(whole);
    }

    /**
     * The home folder of an image, which is made where it is missing.
     *
     * @param name of the kind of children
     * @param modules that it has, with those that they need
     * @param trial arguments for java by which a child answers a ping
     * @throws IOException when it cannot be made; nothing is left behind then
     */
    public Path home(String name, List<String> modules, List<String> trial) throws IOException {
        Path home = place(name, modules);
        if (Files.isDirectory(home)) return home;
        synchronized (MAKING) {
            Files.createDirectories(folder);
            try (FileChannel lock =
                    FileChannel.open(
                            folder.resolve("lock"),
                            StandardOpenOption.CREATE,
                            StandardOpenOption.WRITE)) {
                lock.lock();
                if (!Files.isDirectory(home)) make(home, modules, trial);
            }
        }
        return home;
    }

    /** Removes the images of this build, so that they are made anew. */
    public void remove() {
        try {
            remove(folder.resolve(PREFIX + build));
        } catch (IOException e) {
            System.getLogger(JavaImages.class.getName())
                    .log(System.Logger.Level.WARNING, "cannot remove images in {0}", folder);
        }
    }

    private void make(Path home, List<String> modules, List<String> trial) throws IOException {
        removeOthers();
        Path unfinished = Files.createTempDirectory(folder, UNFINISHED);
        try {
            Path image = unfinished.resolve("image");
            run(
                    jlink().toString(),
                    "--add-modules",
                    String.join(",", modules),
                    "--no-header-files",
                    "--no-man-pages",
                    "--output",
                    image.toString());
            keepClassesReady(image, unfinished, trial);
            Files.createDirectories(home.getParent());
            Files.move(image, home, StandardCopyOption.ATOMIC_MOVE);
        } finally {
            remove(unfinished);
        }
    }

    /** Removes what an interrupted making left, and images of other builds. */
    private void removeOthers() throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            for (Path one : all.toList()) {
                String name = one.getFileName().toString();
                boolean other = name.startsWith(PREFIX) && !name.equals(PREFIX + build);
                if (other || name.startsWith(UNFINISHED)) remove(one);
            }
        }
    }

    /**
     * Makes the archive of classes that the image maps into memory as it starts, instead of reading
     * and checking them: Java's own choice and those of Java's that the trial loads.
     */
    private void keepClassesReady(Path image, Path unfinished, List<String> trial)
            throws IOException {
        Path loaded = unfinished.resolve("loaded");
        List<String> command = new ArrayList<>();
        command.add(Programs.in(image, "java").toString());
        command.add("-XX:DumpLoadedClassList=" + loaded);
        command.addAll(trial);
        ping(command);
        List<String> classes = new ArrayList<>(Files.readAllLines(image.resolve("lib/classlist")));
        Files.readAllLines(loaded).stream()
                .filter(line -> !line.contains("rasterlab/") && !line.contains("source:"))
                .forEach(classes::add);
        Path list = Files.write(unfinished.resolve("classes"), classes);
        run(
                Programs.in(image, "java").toString(),
                "-Xshare:dump",
                "-XX:+UseSerialGC",
                "-Xlog:disable",
                "-XX:SharedClassListFile=" + list);
    }

    /** Lets a child answer once and end by itself, as its input does. */
    private void ping(List<String> command) throws IOException {
        Process child = started(command);
        OutputStream out = child.getOutputStream();
        try (InputStream in = child.getInputStream()) {
            Frames.write(out, new Request(Wire.PING, payload -> {}).frame(0));
            CompletableFuture.supplyAsync(() -> answer(in))
                    .orTimeout(PATIENCE.toNanos(), TimeUnit.NANOSECONDS)
                    .join();
            out.close();
            await(child, command);
        } catch (CompletionException noAnswer) {
            throw new IOException(command.get(0) + " does not answer", noAnswer.getCause());
        } finally {
            child.destroyForcibly();
        }
    }

    private static byte[] answer(InputStream in) {
        try {
            return Frames.read(in, Wire.MOST_FRAME_BYTES);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void run(String... command) throws IOException {
        Process process = started(List.of(command));
        try {
            await(process, List.of(command));
            if (process.exitValue() == 0) return;
            String said = said(process.getInputStream()) + said(process.getErrorStream());
            String name = Path.of(command[0]).getFileName().toString();
            throw new IOException(name + ": " + said.lines().findFirst().orElse("no word"));
        } finally {
            process.destroyForcibly();
        }
    }

    private static String said(InputStream in) throws IOException {
        return new String(in.readNBytes(MOST_SAID), StandardCharsets.UTF_8).strip();
    }

    private static void await(Process process, List<String> command) throws IOException {
        try {
            if (!process.waitFor(PATIENCE.toNanos(), TimeUnit.NANOSECONDS))
                throw new IOException(command.get(0) + " does not end");
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted while an image of Java was made", e);
        }
    }

    private Process started(List<String> command) throws IOException {
        List<String> whole = new ArrayList<>(Programs.afterOthers());
        whole.addAll(command);
        try {
            return launcher.start(whole);
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    private static void remove(Path top) throws IOException {
        if (!Files.exists(top)) return;
        Files.walkFileTree(
                top,
                new SimpleFileVisitor<>() {
                    @Override
                    public FileVisitResult visitFile(Path file, BasicFileAttributes attributes)
                            throws IOException {
                        Files.delete(file);
                        return FileVisitResult.CONTINUE;
                    }

                    @Override
                    public FileVisitResult postVisitDirectory(Path left, IOException failure)
                            throws IOException {
                        if (failure != null) throw failure;
                        Files.delete(left);
                        return FileVisitResult.CONTINUE;
                    }
                });
    }
}
