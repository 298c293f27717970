package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.source.tree.MethodTree;
import com.sun.source.tree.ReturnTree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreeScanner;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import rasterlab.tests.Repository;

class SourceRulesTest {
    private static final int LARGEST_FILE = 400;
    private static final int MEDIAN_FILE = 120;
    private static final int LARGEST_FUNCTION = 60;
    private static final int USUAL_FUNCTION = 25;

    /** A string on one line: hostile sources that tests try are written in such strings. */
    private static final Pattern QUOTED = Pattern.compile("\"(?:[^\"\\\\\\n]|\\\\.)*\"");

    private static final Pattern UNFINISHED =
            Pattern.compile(
                    "\\b(TO"
                            + "DO|FIX"
                            + "ME|XX"
                            + "X)\\b|@Dis"
                            + "abled\\b|Thread\\.sle"
                            + "ep\\(");

    @Test
    void noFileIsLargerThanAllowed() {
        var tooLarge =
                Repository.sources(".java", ".kt").stream()
                        .filter(file -> lines(file) > LARGEST_FILE)
                        .map(file -> name(file) + " has " + lines(file) + " lines")
                        .toList();
        assertEquals(
                List.of(), tooLarge, "split each file of more than " + LARGEST_FILE + " lines");
    }

    @Test
    void halfOfTheFilesAreShort() {
        var sizes =
                Repository.sources(".java", ".kt").stream()
                        .mapToInt(this::lines)
                        .sorted()
                        .toArray();
        assertTrue(
                sizes[sizes.length / 2] <= MEDIAN_FILE,
                "the median file has %d lines, at most %d are allowed: write smaller files"
                        .formatted(sizes[sizes.length / 2], MEDIAN_FILE));
    }

    @Test
    void functionsInJavaAreShort() throws IOException {
        assertShort(functions());
    }

    @Test
    void functionsInKotlinAreShort() {
        assertShort(
                Repository.sources(".kt").stream()
                        .flatMap(file -> KotlinFunctions.of(file).stream())
                        .toList());
    }

    @Test
    void whatAVerdictTellsIsSaidByVerdictDetail() {
        var elsewhere = Pattern.compile("Complaints\\.said\\w*\\([^;]*?detail\\(\\)");
        var wrong =
                Repository.sources(".java").stream()
                        .filter(file -> elsewhere.matcher(Repository.text(file)).find())
                        .map(this::name)
                        .toList();
        assertEquals(List.of(), wrong, "translate a verdict's detail by VerdictDetail only");
    }

    private static void assertShort(List<SourceFunction> functions) {
        assertFalse(functions.isEmpty(), "no function was found to measure");
        var tooLong =
                functions.stream()
                        .filter(function -> function.lines() > LARGEST_FUNCTION)
                        .map(function -> function.place() + " has " + function.lines() + " lines")
                        .toList();
        assertEquals(
                List.of(),
                tooLong,
                "split each function of more than " + LARGEST_FUNCTION + " lines");
        var sorted = functions.stream().mapToInt(SourceFunction::lines).sorted().toArray();
        var usual = sorted[sorted.length * 9 / 10];
        assertTrue(
                usual <= USUAL_FUNCTION,
                "nine of ten functions have up to %d lines, at most %d are allowed: write shorter ones"
                        .formatted(usual, USUAL_FUNCTION));
    }

    @Test
    void nothingIsLeftUnfinished() {
        var found = new ArrayList<String>();
        for (var file : Repository.sources(".java", ".kt", ".properties", ".js", ".css")) {
            var match =
                    UNFINISHED.matcher(QUOTED.matcher(Repository.text(file)).replaceAll("\"\""));
            while (match.find()) found.add(name(file) + ": " + match.group());
        }
        assertEquals(List.of(), found, "finish these; a test waits for an event, not for a time");
    }

    /** A package without a word about itself is a room without a name on the door. */
    @Test
    void everyJavaPackageIntroducesItself() {
        var silent =
                Repository.sources(".java").stream()
                        .filter(file -> !file.toString().contains("/resources/"))
                        .filter(file -> name(file).contains("/src/main/"))
                        .map(Path::getParent)
                        .distinct()
                        .filter(folder -> !Files.exists(folder.resolve("package-info.java")))
                        .map(this::name)
                        .toList();
        assertEquals(List.of(), silent, "give each of these packages a package-info.java");
    }

    /** The word stands in Kotlin before the package's name, in the file to read first. */
    @Test
    void everyKotlinPackageIntroducesItself() {
        var files =
                Repository.sources(".kt").stream()
                        .filter(file -> name(file).contains("/src/main/"))
                        .collect(Collectors.partitioningBy(SourceRulesTest::introduces));
        var introduced = files.get(true).stream().map(Path::getParent).toList();
        var silent =
                files.get(false).stream()
                        .map(Path::getParent)
                        .distinct()
                        .filter(folder -> !introduced.contains(folder))
                        .map(this::name)
                        .toList();
        assertEquals(
                List.of(),
                silent,
                "begin a file of each of these packages with a comment on the package");
        assertFalse(introduced.isEmpty(), "no Kotlin was found to look at");
    }

    private static boolean introduces(Path file) {
        var text = Repository.text(file);
        return text.startsWith("//") || text.startsWith("/*");
    }

    @Test
    void noFolderIsNamedAfterNothing() throws IOException {
        var vague = List.of("util", "utils", "common", "impl", "manager", "helpers", "misc");
        try (var files = Files.walk(Repository.root())) {
            var found =
                    files.filter(Files::isDirectory)
                            .filter(folder -> folder.toString().contains("/src/"))
                            .filter(folder -> vague.contains(folder.getFileName().toString()))
                            .map(this::name)
                            .toList();
            assertEquals(List.of(), found, "name these folders after what is in them");
        }
    }

    private List<SourceFunction> functions() throws IOException {
        var compiler = ToolProvider.getSystemJavaCompiler();
        var found = new ArrayList<SourceFunction>();
        try (var manager = compiler.getStandardFileManager(null, null, null)) {
            var sources = manager.getJavaFileObjectsFromPaths(Repository.sources(".java"));
            var task = (JavacTask) compiler.getTask(null, manager, d -> {}, null, null, sources);
            var positions = Trees.instance(task).getSourcePositions();
            for (var unit : task.parse()) {
                var map = unit.getLineMap();
                unit.accept(
                        new TreeScanner<Void, Void>() {
                            @Override
                            public Void visitMethod(MethodTree method, Void nothing) {
                                var start = positions.getStartPosition(unit, method);
                                var end = positions.getEndPosition(unit, method);
                                if (method.getBody() != null && start >= 0 && !isTable(method))
                                    found.add(
                                            new SourceFunction(
                                                    name(Path.of(unit.getSourceFile().getName()))
                                                            + ":"
                                                            + map.getLineNumber(start)
                                                            + " "
                                                            + method.getName(),
                                                    (int)
                                                            (map.getLineNumber(end)
                                                                    - map.getLineNumber(start)
                                                                    + 1)));
                                return super.visitMethod(method, nothing);
                            }
                        },
                        null);
            }
        }
        return found;
    }

    /** The cases of a parameterised test are data: names for parts of them, then the list. */
    private static boolean isTable(MethodTree method) {
        var statements = method.getBody().getStatements();
        return method.getReturnType() != null
                && method.getReturnType().toString().startsWith("Stream<")
                && statements.stream()
                        .allMatch(
                                each -> each instanceof ReturnTree || each instanceof VariableTree);
    }

    private int lines(Path file) {
        try (Stream<String> lines = Files.lines(file)) {
            return (int) lines.count();
        } catch (IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    private String name(Path file) {
        return Repository.root().relativize(file).toString();
    }
}
