package rasterlab.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.ReportLanguage;
import rasterlab.app.language.Language;
import rasterlab.app.shell.labs.FirstCase;

/** The command that opens the window with a case, up to the window. */
class OpenCommandTest {
    private static final String LINE =
            "{\"version\":1,\"topic\":\"line\",\"method\":\"bresenham\","
                    + "\"input\":{\"from\":[0,0],\"to\":[5,2]}}";

    @TempDir Path folder;

    /** The cases that were opened, and in which language each. */
    private final List<FirstCase> opened = new ArrayList<>();

    private final List<Optional<Language>> asked = new ArrayList<>();
    private Path scene;
    private Path source;

    @BeforeEach
    void files() throws Exception {
        scene = Files.writeString(folder.resolve("steep.scene.json"), LINE);
        source = Files.writeString(folder.resolve("Mine.java"), "class Mine {}");
    }

    /** The output on the error stream. */
    private String open(boolean display, int code, String... words) {
        var err = new ByteArrayOutputStream();
        var console =
                Console.of(
                        InputStream.nullInputStream(),
                        new PrintStream(OutputStream.nullOutputStream()),
                        new PrintStream(err),
                        ReportLanguage.asked(words));
        var command =
                new OpenCommand(
                        console,
                        () -> display,
                        (language, first) -> {
                            asked.add(language);
                            opened.add(first);
                        });
        var lab = new CommandLine(new LabCommand(console)).addSubcommand(command);
        Lab.configured(lab, console);
        assertEquals(code, lab.execute(words), err.toString(StandardCharsets.UTF_8));
        return err.toString(StandardCharsets.UTF_8).strip();
    }

    @Test
    void theProgramStandsBesideTheCase() {
        open(
                true,
                0,
                "open",
                scene.toString(),
                "--with",
                source.toString(),
                "--exercise",
                "line-bresenham");
        FirstCase first = opened.get(0);
        assertEquals("line", first.scene().topic());
        assertEquals("line-bresenham", first.program().orElseThrow().exercise().id());
        assertEquals("class Mine {}", first.program().orElseThrow().source());
        assertEquals(List.of(Optional.empty()), asked);
    }

    @ParameterizedTest(name = "{0} opens no Russian window")
    @CsvSource({"--lang ru open FILE", "open FILE --lang=ru"})
    void theWindowSpeaksTheLanguageThatIsAskedFor(String words) {
        open(true, 0, words.replace("FILE", scene.toString()).split(" "));
        assertEquals(List.of(Optional.of(Language.RUSSIAN)), asked);
        assertEquals(Optional.empty(), opened.get(0).program());
    }

    @Test
    void theOnlyExerciseOfATopicNeedNotBeNamed() throws Exception {
        String circle =
                LINE.replace("\"line\"", "\"circle\"")
                        .replaceAll("\\{\"from.*}}", "{\"center\":[0,0],\"radius\":3}}");
        open(
                true,
                0,
                "open",
                Files.writeString(scene, circle).toString(),
                "--with",
                source.toString());
        assertEquals("circle", opened.get(0).program().orElseThrow().exercise().topic());
    }

    @Test
    void withoutADisplayItNamesTheCommandThatNeedsNone() {
        String file = scene.toString();
        assertEquals(
                "./lab open: there is no display; `./lab run --scene "
                        + file
                        + "` prints what is right there",
                open(false, 2, "open", file));
        assertEquals(
                "./lab open: экрана нет; что там верно, печатает `./lab run --scene " + file + "`",
                open(false, 2, "open", file, "--lang", "ru"));
        assertEquals(List.of(), opened);
    }

    @ParameterizedTest(name = "{0}: {1} is asked for though the interface tells")
    @CsvSource({
        "class Mine implements WindowedLineRasterizer {}, window-segment",
        "class Mine implements LineRasterizer {}, line-bresenham",
        "class Mine implements /* no WindowedLineRasterizer */ LineRasterizer {}, line-bresenham"
    })
    void theInterfaceTellsWhichExerciseIsMeant(String text, String exercise) throws Exception {
        Files.writeString(source, text);
        open(true, 0, "open", scene.toString(), "--with", source.toString());
        assertEquals(exercise, opened.get(0).program().orElseThrow().exercise().id());
    }

    @ParameterizedTest(name = "{0} is not refused")
    @CsvSource(
            delimiter = '|',
            value = {
                "FILE --exercise line-bresenham|--exercise and --exercises go with --with SOURCE"
                        + "|параметры --exercise и --exercises указывают вместе с --with SOURCE",
                "FILE --with SOURCE --exercise circle|exercise 'circle' asks for no program on topic"
                        + " 'line'; there are line-bresenham|задание «circle» не требует программы по"
                        + " теме «line»; есть: line-bresenham",
                "FILE --with SOURCE|several exercises are on topic 'line'; name one with --exercise:"
                        + " line-bresenham|по теме «line» несколько заданий; укажите одно параметром"
                        + " --exercise: line-bresenham"
            })
    void whatDoesNotFitIsRefusedInBothLanguages(String words, String english, String russian) {
        String[] given =
                ("open " + words)
                        .replace("FILE", scene.toString())
                        .replace("SOURCE", source.toString())
                        .split(" ");
        assertTrue(open(true, 2, given).startsWith("./lab open: " + english));
        String[] inRussian =
                List.of(given, new String[] {"--lang", "ru"}).stream()
                        .flatMap(Arrays::stream)
                        .toArray(String[]::new);
        assertTrue(open(true, 2, inRussian).startsWith("./lab open: " + russian));
        assertEquals(List.of(), opened);
    }

    @ParameterizedTest(name = "a scene with {0} is opened")
    @CsvSource({"bresenham, brasenham, method 'brasenham'", "from, form, 'form'"})
    void aSceneThatNoLabReadsIsRefused(String word, String other, String said) throws Exception {
        Files.writeString(scene, LINE.replace(word, other));
        String complaint = open(true, 2, "open", scene.toString());
        assertTrue(complaint.contains(scene + ": ") && complaint.contains(said), complaint);
        assertEquals(List.of(), opened);
    }
}
