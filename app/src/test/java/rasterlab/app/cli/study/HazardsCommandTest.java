package rasterlab.app.cli.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.cli.Ran;
import rasterlab.app.cli.console.ReportLanguage;
import rasterlab.app.found.FoundHazards;
import rasterlab.app.study.HazardMatrix;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial.VerdictCell;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;

@Tag("slow")
class HazardsCommandTest {
    @Test
    void everyVerdictIsTheRecordedOne() {
        Ran ran = Ran.lab("hazards", "line");
        assertFalse(ran.out().contains("!"), ran.out());
        assertTrue(ran.out().contains("last-column"), ran.out());
        ran.assertDone();
    }

    @Test
    void anotherVerdictIsMarkedAndNamed() {
        HazardMatrix matrix = withDetail("pixel (1, 2) is missing");
        assertFalse(matrix.asRecorded());
        List<String> lines = printed(matrix, ReportLanguage.EN);
        assertEquals("steep  wrong !", lines.get(1));
        assertEquals(
                "! dda on steep: wrong, recorded is exact; pixel (1, 2) is missing", lines.get(2));
        List<String> russian = printed(matrix, ReportLanguage.RU);
        assertEquals("steep  неверно !", russian.get(1));
        assertEquals(
                "! dda на steep: неверно, записано точно; пиксель (1, 2) пропущен", russian.get(2));
    }

    @ParameterizedTest(name = "a script reads another English than Java's: {0}")
    @ValueSource(
            strings = {
                "pixel (-1, 2) is missing",
                "at 1e-7: -0.5 instead of 2",
                "no visibility 'x'; there are z16, bsp",
            })
    void englishStaysAsTheEngineWritesIt(String detail) {
        List<String> lines = printed(withDetail(detail), ReportLanguage.EN);
        assertEquals("! dda on steep: wrong, recorded is exact; " + detail, lines.get(2));
    }

    @ParameterizedTest(name = "a number is written otherwise than in the other Russian tables: {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "pixel (-1, 2) is missing | пиксель (-1, 2) пропущен",
                "at 1e-7: -0.5 instead of 2.0 | при x = 1e-7: -0.5 вместо 2",
            })
    void russianHasTheNumbersOfTheOtherTables(String detail, String said) {
        List<String> lines = printed(withDetail(detail), ReportLanguage.RU);
        assertEquals("! dda на steep: неверно, записано точно; " + said, lines.get(2));
    }

    @Test
    void searchWritesAnInputThatRunTakes(@TempDir Path folder) {
        Path file = folder.resolve("found.scene.json");
        Ran found =
                Ran.lab("hazards", "line", "--search=naive-textbook", "--out=" + file, "--seed=3");
        found.assertDone();
        assertTrue(found.out().startsWith("line naive-textbook: wrong: "), found.out());
        assertTrue(found.err().contains("made simpler"), found.err());
        Ran.lab("run", "--scene", file.toString()).assertDone();
    }

    @Test
    void pageHasEveryVerdictWithTheCommandThatRepeatsIt(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("new").resolve("rotate.html");
        Ran.lab("hazards", "rotate", "--html", file.toString(), "--lang", "ru").assertDone();
        String page = Files.readString(file);
        assertTrue(page.contains("<html lang=\"ru\">"), "its language");
        for (Hazard<?> hazard : Topics.named("rotate").hazards())
            for (Method<?> method : Topics.named("rotate").methods()) {
                String typed =
                        "./lab --lang ru run rotate %s --hazard %s"
                                .formatted(method.name(), hazard.name());
                assertTrue(page.contains(typed), typed);
            }
        assertTrue(page.contains("<img alt="), "a picture of what is wrong");
    }

    @Test
    void searchThatFindsNothingSaysHowManyInputsItTried() {
        Ran none = Ran.lab("hazards", "line", "--search", "bresenham", "--seconds", "1");
        none.assertDone();
        assertTrue(
                none.out()
                        .matches("line bresenham: nothing found in 1 s among [1-9].* inputs .*\\R"),
                none.out());
    }

    @Test
    void searchRefusesWhatItCannotDo() {
        Ran.lab("hazards", "--search", "dda")
                .assertComplains(2, "./lab hazards: --search METHOD needs TOPIC");
        Ran.lab("hazards", "line", "--search", "dda", "--seconds", "0")
                .assertComplains(2, "./lab hazards: --seconds must be from 1 to 3600, got 0");
        Ran.lab("hazards", "line", "--out", "x.scene.json")
                .assertComplains(2, "./lab hazards: --out goes with --search METHOD");
        Ran.lab("hazards", "line", "--keep")
                .assertComplains(2, "./lab hazards: --keep goes with --search METHOD");
        Ran unknown = Ran.lab("hazards", "line", "--search", "ddaa");
        assertEquals(2, unknown.exitCode());
        assertTrue(unknown.err().startsWith("./lab hazards: no line method 'ddaa'"), unknown.err());
    }

    @Test
    void keptFindLiesBesideTheSettings(@TempDir Path settings) {
        System.setProperty("rasterlab.settings", settings.resolve("window").toString());
        try {
            Ran.lab("hazards", "line", "--search", "naive-textbook", "--seed", "5", "--keep")
                    .assertDone();
        } finally {
            System.clearProperty("rasterlab.settings");
        }
        assertEquals(1, FoundHazards.in(settings).of("line").size());
    }

    private static HazardMatrix withDetail(String detail) {
        var verdict = new Verdict(Verdict.Kind.WRONG, Deviation.NONE, detail);
        var cell = new VerdictCell("steep", "dda", verdict, Verdict.Kind.EXACT);
        return new HazardMatrix("line", List.of("dda"), List.of("steep"), List.of(cell));
    }

    private static List<String> printed(HazardMatrix matrix, ReportLanguage language) {
        var out = new ByteArrayOutputStream();
        HazardText.print(
                matrix, new PrintStream(out, true, StandardCharsets.UTF_8), language.texts());
        return out.toString(StandardCharsets.UTF_8).lines().toList();
    }
}
