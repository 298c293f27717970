package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.Sources;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.runner.process.ChildJars;
import rasterlab.exercises.runner.process.JavaImages;
import rasterlab.exercises.runner.process.Launcher;
import rasterlab.exercises.runner.process.Programs;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;

/** Children run on a Java of the modules that they need, or it is said why they do not. */
@Tag("slow")
class ImageTest {
    private static final Path IMAGES = StartedJudge.IMAGES;

    /** No process goes further down. */
    private static final int LAST_OF_ALL = 19;

    @TempDir private Path folder;

    @BeforeEach
    void needsJlink() {
        assumeTrue(JavaImages.canMake(), "this JDK has no jlink");
    }

    @Test
    @DisplayName("a method's Java has more than the base module")
    void aMethodHasTheBaseAlone() throws IOException {
        List<String> modules = lines(found(IMAGES).program(ChildKind.RUN), "--list-modules");
        assertEquals(1, modules.size(), modules::toString);
        assertTrue(modules.get(0).startsWith("java.base"), modules::toString);
    }

    @Test
    @DisplayName("the compiler's classes are read and checked at each start")
    void theCompilersClassesAreReady() throws IOException {
        List<String> said =
                lines(
                        found(IMAGES).program(ChildKind.COMPILE),
                        "-Xshare:on",
                        "-Xlog:class+load",
                        "-m",
                        "jdk.compiler/com.sun.tools.javac.Main",
                        "-version");
        String compiler = "com.sun.tools.javac.util.Context source: shared objects file";
        assertTrue(
                said.stream().anyMatch(line -> line.contains(compiler)),
                "the archive has no javac");
    }

    @Test
    @DisplayName("a student's method runs on the whole JDK, or on no Java at all")
    void gradesOnTheImage() throws Exception {
        try (Judge judge = Judge.start(JudgeSettings.once().withImages(IMAGES))) {
            assertFalse(lacks(judge, "missing.image-off", "missing.image-fails"), judge::toString);
            assertEquals(GradingVerdict.OK, verdict(judge));
        }
    }

    @Test
    @DisplayName("an image is made anew at each start")
    void isKept() throws IOException {
        Path home = found(IMAGES).home(ChildKind.RUN);
        Object made = Files.getAttribute(home, "creationTime");
        assertEquals(made, Files.getAttribute(found(IMAGES).home(ChildKind.RUN), "creationTime"));
        assertEquals(List.of(), left("making-"));
    }

    @Test
    @DisplayName("what is left of an interrupted making, or of another build, stays for ever")
    void removesWhatIsLeft() throws IOException {
        Path images = Files.createDirectory(folder.resolve("images"));
        for (String name : List.of("making-1", "java-0123456789abcdef"))
            Files.writeString(Files.createDirectories(images.resolve(name)).resolve("a"), "x");
        Path mine = Files.createFile(images.resolve("thesis.tex"));
        try (ChildJars jars = ChildJars.assemble();
                Launcher launcher = new Launcher(jars)) {
            JavaImages made = new JavaImages(images, launcher, jars);
            List<String> trial =
                    ChildKind.RUN.arguments(
                            jars.harness().toString(), jars.contract().toString(), false);
            Path home = made.home("run", List.of("java.base"), trial);
            try (Stream<Path> all = Files.list(images)) {
                List<Path> expected =
                        Stream.of(home.getParent(), images.resolve("lock"), mine).sorted().toList();
                assertEquals(expected, all.sorted().toList());
            }
            made.remove();
            assertFalse(Files.exists(home));
        }
    }

    @Test
    @DisplayName("where no image can be made, nothing is graded, or it is not said")
    void goesOnWithoutAnImage() throws Exception {
        Path file = Files.createFile(folder.resolve("file"));
        try (Judge judge = Judge.start(JudgeSettings.once().withImages(file.resolve("images")))) {
            assertTrue(lacks(judge, "missing.image-fails"), judge.isolation()::toString);
            assertFalse(judge.isolation().exam());
            String said = judge.isolation().describe("en");
            assertTrue(said.contains("run on the whole JDK, as the image"), said);
            assertEquals(GradingVerdict.OK, verdict(judge));
        }
    }

    @Test
    @DisplayName("nothing is graded as long as images are made, or their Java is never taken")
    void gradesMeanwhileOnTheJdk() throws Exception {
        JudgeSettings settings = JudgeSettings.defaults().withImages(folder.resolve("images"));
        var images = new CompletableFuture<Isolation>();
        try (Judge judge = Judge.startAtOnce(settings, SpeedMemory.ofProcess(), images::complete)) {
            Isolation before = judge.isolation();
            assertFalse(before.exam());
            String said = before.describe("en");
            assertTrue(said.contains("until the image of its needed modules is made"), said);
            assertEquals(GradingVerdict.OK, verdict(judge));
            assertEquals(images.get(3, TimeUnit.MINUTES), judge.isolation());
            assertFalse(lacks(judge, "missing.image-making", "missing.image-fails"));
            assertEquals(GradingVerdict.OK, verdict(judge));
        }
        try (Judge judge = Judge.startAtOnce(settings, SpeedMemory.ofProcess(), one -> {})) {
            assertFalse(lacks(judge, "missing.image-making"), "what is there is made again");
        }
    }

    @Test
    @Timeout(value = 3, unit = TimeUnit.MINUTES)
    @DisplayName("a judge that is closed as images are made leaves half of one")
    void leavesNoHalfImage() throws Exception {
        Path images = folder.resolve("images");
        JudgeSettings settings = JudgeSettings.defaults().withImages(images);
        try (Judge judge = Judge.startAtOnce(settings, SpeedMemory.ofProcess(), one -> {})) {
            assertTrue(lacks(judge, "missing.image-making"), judge.isolation()::toString);
            while (!Files.exists(images) || left(images, "making-").isEmpty()) Thread.onSpinWait();
        }
        assertEquals(List.of(), left(images, "making-"));
    }

    @Test
    @DisplayName("making an image takes processor time from what is graded meanwhile")
    void givesWayToGrading() throws Exception {
        assumeTrue(Programs.onPath("nice").isPresent(), "nice is missing");
        assumeTrue(Files.exists(Path.of("/proc/self/stat")), "no such /proc");
        long me = ProcessHandle.current().pid();
        var seen = new TreeSet<Integer>();
        try (ChildJars jars = ChildJars.assemble();
                Launcher launcher = new Launcher(jars)) {
            var images = new JavaImages(folder.resolve("images"), launcher, jars);
            List<String> trial =
                    ChildKind.RUN.arguments(
                            jars.harness().toString(), jars.contract().toString(), false);
            var made =
                    CompletableFuture.supplyAsync(
                            () -> {
                                try {
                                    return images.home("run", List.of("java.base"), trial);
                                } catch (IOException e) {
                                    throw new UncheckedIOException(e);
                                }
                            });
            while (!made.isDone())
                ProcessHandle.current()
                        .children()
                        .filter(one -> one.info().command().orElse("").endsWith("/jlink"))
                        .flatMap(one -> niceness(one.pid()).stream())
                        .forEach(seen::add);
            assertTrue(Files.isDirectory(made.get()));
        }
        int mine = niceness(me).orElseThrow();
        assertEquals(Set.of(Math.min(mine + Programs.STEPS_DOWN, LAST_OF_ALL)), seen);
    }

    /** How much a process gives way to others; nothing where it has ended. See proc(5). */
    private static Optional<Integer> niceness(long pid) {
        try {
            String stat = Files.readString(Path.of("/proc/" + pid + "/stat"));
            String[] behindName = stat.substring(stat.lastIndexOf(')') + 2).split(" ");
            return Optional.of(Integer.valueOf(behindName[16]));
        } catch (IOException ended) {
            return Optional.empty();
        }
    }

    @Test
    @DisplayName("an image that is damaged keeps every method from running")
    void goesOnAfterDamage() throws Exception {
        assumeTrue(Programs.onPath("bwrap").isPresent(), "bubblewrap is missing");
        Path images = folder.resolve("damaged");
        copy(IMAGES.resolve(found(IMAGES).home(ChildKind.RUN).getParent().getFileName()), images);
        Files.delete(found(images).home(ChildKind.RUN).resolve("lib/modules"));
        JudgeSettings settings = JudgeSettings.once().withImages(images);
        try (Judge judge = Judge.start(settings)) {
            assertTrue(lacks(judge, "missing.image-fails"), judge.isolation()::toString);
            assertEquals(GradingVerdict.OK, verdict(judge));
        }
        assertEquals(List.of(), left(images, "java-"), "it is not made anew");
    }

    private static void copy(Path from, Path images) throws IOException {
        try (Stream<Path> all = Files.walk(from)) {
            for (Path one : all.toList()) {
                Path to = images.resolve(from.getParent().relativize(one).toString());
                if (Files.isDirectory(one)) Files.createDirectories(to);
                else Files.copy(one, to, java.nio.file.StandardCopyOption.COPY_ATTRIBUTES);
            }
        }
    }

    private static ChildJava found(Path images) {
        try (ChildJars jars = ChildJars.assemble();
                Launcher launcher = new Launcher(jars)) {
            return ChildJava.found(JudgeSettings.once().withImages(images), launcher, jars);
        }
    }

    private static GradingVerdict verdict(Judge judge) throws InterruptedException {
        var exercise = Catalogue.builtIn().named("line-bresenham");
        return judge.grade(exercise, Sources.RIGHT, CaseSelection.open(), one -> {}).verdict();
    }

    private static boolean lacks(Judge judge, String... keys) {
        return judge.isolation().missing().stream()
                .flatMap(one -> one.sentences().stream())
                .map(Message.Sentence::key)
                .anyMatch(List.of(keys)::contains);
    }

    private static List<Path> left(String start) throws IOException {
        return left(IMAGES, start);
    }

    private static List<Path> left(Path images, String start) throws IOException {
        try (Stream<Path> all = Files.list(images)) {
            return all.filter(one -> one.getFileName().toString().startsWith(start)).toList();
        }
    }

    private static List<String> lines(String... command) throws IOException {
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        process.getOutputStream().close();
        try (var out = process.getInputStream()) {
            return new String(out.readAllBytes(), StandardCharsets.UTF_8).lines().toList();
        }
    }
}
