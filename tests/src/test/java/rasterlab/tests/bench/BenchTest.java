package rasterlab.tests.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.ReportLanguage;
import rasterlab.app.language.Language;
import rasterlab.tests.bench.language.BenchWords;

class BenchTest {
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    @Test
    void anUnknownGroupIsAnsweredWithThoseThereAre() {
        assertEquals(2, run("nosuch"));
        assertEquals(
                "./lab bench: unknown group 'nosuch'; allowed are grader, pipeline, plan, raster,"
                        + " search, study, window"
                        + " (see `./lab bench --help`)",
                errorText());
    }

    @Test
    void anUnknownWorkIsAnsweredWithThoseThereAre() {
        assertEquals(2, run("raster", "--only", "nosuch"));
        assertTrue(
                errorText().startsWith("./lab bench: no goal has 'nosuch' in its work; "),
                errorText());
        for (Goal goal : RasterGoals.all())
            assertTrue(errorText().contains(goal.work()), errorText());
        assertTrue(errorText().matches("[^\\[\\]]*"), errorText());
    }

    @Test
    void anUnknownMethodToSearchForIsAnsweredWithTheTopicsAndOneOfATopicWithItsMethods() {
        assertEquals(2, run("search", "--only", "nosuch"));
        assertTrue(errorText().contains("topics are line; circle; "), errorText());
        assertTrue(errorText().length() < 1000, errorText().length() + " characters");
        err.reset();
        assertEquals(2, run("search", "--only", "circle nosuch"));
        assertTrue(errorText().contains("circle midpoint"), errorText());
        assertFalse(errorText().contains("line"), errorText());
    }

    @Test
    void anUnknownWorkOfThePipelineIsAnsweredToo() {
        assertEquals(2, run("pipeline", "--only", "nosuch"));
        assertTrue(
                errorText().startsWith("./lab bench: no goal has 'nosuch' in its work; "),
                errorText());
        assertTrue(errorText().contains("; threads; clear; "), errorText());
    }

    @Test
    void anUnknownPartOfTheGraderIsAnsweredWithThoseThereAre() {
        assertEquals(2, run("grader", "--only", "disk,nosuch"));
        assertEquals(
                "./lab bench: the grader has no part 'nosuch'; there are single, class, bombs,"
                        + " sockets, burst, disk, readonly, locked, database, clock, files, kills"
                        + " (see `./lab bench --help`)",
                errorText());
    }

    @ParameterizedTest(name = "--only ''{0}'' runs every part of the grader")
    @ValueSource(strings = {"", " "})
    void aListWithoutANameIsRefused(String list) {
        assertEquals(2, run("grader", "--only", list));
        assertTrue(
                errorText()
                        .startsWith(
                                "./lab bench: the grader has no part ''; there are single, class,"),
                errorText());
    }

    @Test
    void whatDoesNotGoTogetherIsTold() {
        assertEquals(2, run("window", "--only", "line"));
        assertEquals(2, run("raster", "--minutes", "3"));
        assertEquals(2, run("window", "--minutes", "-1"));
        assertEquals(2, run("raster", "--seed", "3"));
        assertEquals(
                List.of(
                        "--only goes with the groups raster, pipeline, search and grader, not with"
                                + " plan, study and window",
                        "--minutes goes with the group window, not with raster",
                        "--minutes must be at least 0, got -1",
                        "--seed goes with the group grader, not with raster"),
                errorText()
                        .lines()
                        .map(line -> line.replaceAll("^./lab bench: | \\(see.*", ""))
                        .toList());
    }

    @ParameterizedTest(name = "./lab bench {0} is answered in English")
    @ValueSource(
            strings = {
                "--lang ru",
                "rasta --lang=ru",
                "raster --only nosuch --lang ru",
                "grader --only nosuch --lang ru",
                "raster --minutes 3 --lang ru",
                "raster --seed 3 --lang ru",
                "window --minutes x --lang ru",
                "raster --lnag --lang ru",
                "raster more --lang ru",
                "raster more again --lang ru",
                "raster --minute 3 --lang ru"
            })
    void tellsInRussian(String call) {
        assertEquals(2, run(call.split(" ")));
        assertTrue(
                errorText().matches("./lab bench: .*[а-яё]{3}.* \\(см\\. `./lab bench --help`\\)"),
                errorText());
        String told = errorText().replaceAll("`[^`]*`|; есть .*|^./lab bench", "");
        assertTrue(told.matches("(?s)(?!.*\\b[a-z]{2,} [a-z]{2,}).*"), told);
        assertTrue(!told.contains("'"), told);
    }

    @Test
    @DisplayName("help and the head of the table stay English")
    void helpAndHeadsAreRussianToo() {
        var words = new BenchWords(Language.RUSSIAN);
        String help = Bench.commandLine(console(ReportLanguage.RU)).getUsageMessage();
        assertTrue(help.startsWith("Вызов: ./lab bench"), help);
        String told = help.replace("raster, pipeline", "").replace("./lab bench", "");
        assertTrue(told.matches("(?s)(?!.*\\b[a-z]{2,} [a-z]{2,}).*"), help);
        assertTrue(words.head("head.raster").contains("отношение"));
    }

    @Test
    void helpIsPrintedInUtf8() {
        assertEquals(0, run("--help", "--lang", "ru"));
        assertTrue(errorText().startsWith("Вызов: ./lab bench"), errorText());
    }

    private int run(String... arguments) {
        return Bench.commandLine(console(ReportLanguage.asked(arguments))).execute(arguments);
    }

    /** A console over streams that know only ASCII, as where the system's locale is C. */
    private Console console(ReportLanguage language) {
        var ascii = new PrintStream(err, true, StandardCharsets.US_ASCII);
        return Console.of(InputStream.nullInputStream(), ascii, ascii, language);
    }

    private String errorText() {
        return err.toString(StandardCharsets.UTF_8).strip();
    }
}
