package rasterlab.tests.frontdoor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.tests.ChildProcess;
import rasterlab.tests.Repository;

/**
 * All tests that need the fresh copy stand in one class: another process would build one of its
 * own.
 */
@Tag("slow")
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "a POSIX shell runs the script under test")
@ExtendWith(FreshCopy.Provider.class)
class FrontDoorTest {
    private static final Duration SOON = Duration.ofMinutes(5);

    private static final String TOUR = "./lab tour --quick --out tour";

    /** Times of studies take most of a tour; those are waited for with {@code rasterlab.full}. */
    private static final String TRIED_TOUR =
            Boolean.getBoolean("rasterlab.full") ? TOUR : TOUR + " --untimed";

    /**
     * The commands that open a window, are this very test run, or serve until stopped; and the
     * tour.
     */
    private static final Set<String> TRIED_ELSEWHERE =
            Set.of("./lab", "./mvnw verify", "./lab grader serve --data course", TOUR);

    @Test
    void firstCallBuildsAndSaysSo(FreshCopy copy) {
        var first = copy.firstRun();
        assertEquals(0, first.exit(), first.err());
        assertTrue(first.err().startsWith("lab: building Rasterlab"), first.err());
        assertTrue(first.err().contains("engine ("), "no progress in: " + first.err());
        assertTrue(Files.exists(copy.folder().resolve("target/lab/build.log")));
        assertTrue(first.out().contains("bresenham"), first.out());
    }

    @Test
    void laterCallsBuildNothing(FreshCopy copy) {
        var later = copy.lab(copy.folder(), SOON, "methods");
        assertEquals("", later.err());
        assertEquals(copy.firstRun().out(), later.out());
    }

    @Test
    void worksFromAnyFolderThroughALink(FreshCopy copy, @TempDir Path elsewhere)
            throws IOException {
        var link =
                Files.createSymbolicLink(elsewhere.resolve("my lab"), copy.folder().resolve("lab"));
        var run =
                ChildProcess.run(
                        elsewhere, FreshCopy.withJava(), SOON, List.of(link.toString(), "methods"));
        assertEquals(0, run.exit(), run.err());
        assertEquals(copy.firstRun().out(), run.out());
    }

    @Test
    void argumentsKeepTheirSpacesAndQuotes(FreshCopy copy) {
        var run = copy.lab(copy.folder(), SOON, "methods", "no such \"topic\" *");
        assertEquals(2, run.exit());
        assertTrue(run.err().contains("no such \"topic\" *"), run.err());
    }

    @Test
    @Timeout(value = 20, unit = TimeUnit.MINUTES)
    void everyCommandWorks(FreshCopy copy) {
        var commands = Readme.commands();
        assertTrue(commands.containsAll(TRIED_ELSEWHERE), "README lacks one of " + TRIED_ELSEWHERE);
        for (var command : commands) if (!TRIED_ELSEWHERE.contains(command)) succeed(copy, command);
    }

    /** Maven and the benchmarks would build once more; ContributingTest looks at those lines. */
    @Test
    @Timeout(value = 20, unit = TimeUnit.MINUTES)
    void everyCommandForContributorsWorks(FreshCopy copy) {
        var text = Repository.text(Repository.root().resolve("CONTRIBUTING.md"));
        var commands =
                Readme.commands(text).stream()
                        .filter(command -> command.startsWith("./lab"))
                        .filter(command -> !command.startsWith("./lab bench"))
                        .toList();
        assertFalse(commands.isEmpty(), "no command of CONTRIBUTING.md was found");
        for (var command : commands) succeed(copy, command);
    }

    @Test
    @Timeout(value = 20, unit = TimeUnit.MINUTES)
    void quickTourShowsEachLabInOneLanguageAndTheme(FreshCopy copy) throws IOException {
        succeed(copy, TRIED_TOUR);
        var tour = copy.folder().resolve("tour");
        try (var pictures = Files.list(tour.resolve("pictures"))) {
            var looks =
                    pictures.map(each -> each.getFileName().toString())
                            .filter(name -> name.startsWith("lab-line-"))
                            .toList();
            assertEquals(List.of("lab-line-en-light.png"), looks);
        }
        assertFalse(Files.readString(tour.resolve("index.html")).contains("class=\"failure\""));
    }

    private static void succeed(FreshCopy copy, String command) {
        var run =
                ChildProcess.run(
                        copy.folder(),
                        withTheFirstCompilerOnly(),
                        Duration.ofMinutes(15),
                        List.of("sh", "-c", command));
        assertEquals(0, run.exit(), command + "\n" + run.out() + run.err());
    }

    /** A command runs for seconds, in which the second compiler would only cost time. */
    private static Map<String, String> withTheFirstCompilerOnly() {
        var environment = new HashMap<>(FreshCopy.withJava());
        environment.put("JAVA_TOOL_OPTIONS", "-XX:TieredStopAtLevel=1");
        return environment;
    }

    @Test
    void commandsOfTheReadmeAreListedByHelp(FreshCopy copy) {
        var help = copy.lab(copy.folder(), SOON, "help").out();
        for (var command : Readme.commands()) {
            var words = command.split("\\s+");
            var at = List.of(words).indexOf("./lab");
            if (at >= 0 && words.length > at + 1)
                assertTrue(help.contains(words[at + 1]), "help does not list " + words[at + 1]);
        }
    }
}
