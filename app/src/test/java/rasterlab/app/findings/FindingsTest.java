package rasterlab.app.findings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.language.Language;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.transform.matrix.MatrixTopic;
import rasterlab.engine.transform.rotate.RotateTopic;
import rasterlab.engine.transform.view.ViewTopic;

@Tag("slow")
class FindingsTest {
    @TempDir Path folder;

    private final List<String> said = new ArrayList<>();

    private Findings findings(boolean stopped, Language language) {
        return findings(8, stopped, language);
    }

    private Findings findings(int rounds, boolean stopped, Language language) {
        return findings(rounds, () -> stopped, language);
    }

    private Findings findings(int rounds, BooleanSupplier stopped, Language language) {
        var settings =
                new StudySettings(
                        Duration.ZERO,
                        Duration.ofNanos(1),
                        rounds,
                        StudySettings.quick().wallLimit());
        return new Findings(folder, settings, " --quick", language, said::add, stopped);
    }

    /** The page without what keeps the words of its commands whole. */
    private String page(String name) throws Exception {
        return Files.readString(folder.resolve(name)).replaceAll("</?span>", "");
    }

    @Test
    void everyTopicGetsItsPageWithChartsNumbersAndCommands() throws Exception {
        assertTrue(
                findings(false, Language.ENGLISH)
                        .write(List.of(new MatrixTopic(), new ViewTopic())));
        assertEquals(List.of("measuring matrix", "measuring view"), said);
        String view = page("view.html");
        for (String wanted :
                List.of(
                        "./lab study view --quick --seed 1 --chart front --out front.svg",
                        "./lab hazards view",
                        "./lab study view --quick --seed 1 --chart error-by-input --out",
                        "charts/view-error-by-input.svg",
                        "./lab study view --quick --seed 1 --chart sizes --out sizes.svg",
                        "charts/view-sizes-dark.svg",
                        "charts/view-cost-growth-dark.svg",
                        "data/view.json")) assertTrue(view.contains(wanted), wanted);
        Matcher link =
                Pattern.compile("(?:src|srcset|href)=\"((?:charts|data)/[^\"]+)\"").matcher(view);
        var linked = new TreeSet<String>();
        while (link.find()) linked.add(link.group(1));
        for (String file : linked) assertTrue(Files.size(folder.resolve(file)) > 0, file);
        assertEquals(14, linked.size(), "six charts in two looks, two files of numbers: " + linked);
        assertTrue(page("charts/view-error-by-input.svg").contains(">Best: "), "not another chart");
        assertTrue(page("index.html").contains("<a href=\"matrix.html\">"));
        assertTrue(page("course.html").contains("charts/matrix-front.svg"));
        assertTrue(view.contains("@media print"));
    }

    @Test
    @DisplayName("verdicts stand without colour, sign or a way to their picture and command")
    void verdictsLookAndLeadAsOnThePageOfHazards() throws Exception {
        assertTrue(findings(false, Language.ENGLISH).write(List.of(new RotateTopic())));
        String rotate = page("rotate.html");
        String hazards = page("hazards/rotate.html");
        Matcher cell =
                Pattern.compile(
                                "<td class=\"degraded\"><a href=\"hazards/rotate.html#([^\"]+)\""
                                        + " title=\"\\./lab run rotate ([^\"]+)\">≈\u00a0acceptable</a>")
                        .matcher(rotate);
        assertTrue(cell.find(), rotate);
        assertTrue(hazards.contains("<section id=\"" + cell.group(1) + "\">"), cell.group(1));
        assertTrue(hazards.contains("<pre>./lab run rotate " + cell.group(2) + "</pre>"), hazards);
        assertTrue(hazards.contains("<a href=\"#" + cell.group(1) + "\""), "on its own page");
        assertTrue(rotate.contains(".degraded{border-left-color:"), "colour");
        assertTrue(
                rotate.contains("<p>≈\u00a0acceptable: The answer is not exact, but"), "the rule");
    }

    @Test
    void whatWasNotMeasuredWhenItWasStoppedIsSaid() throws Exception {
        assertFalse(findings(true, Language.RUSSIAN).write(List.of(new MatrixTopic())));
        assertEquals(List.of(), said, "a topic is said to be measured after the stop");
        assertTrue(page("index.html").contains("Не измерено"));
        assertFalse(Files.exists(folder.resolve("matrix.html")));
    }

    @Test
    @DisplayName("all hazards are tried though the stop came before")
    void stopAmongTheHazardsKeepsTheNumbersAndTriesNoMore() throws Exception {
        Path numbers = folder.resolve("data/matrix.json");
        var asked = new AtomicInteger();
        BooleanSupplier third = () -> Files.exists(numbers) && asked.incrementAndGet() == 3;
        assertFalse(findings(8, third, Language.ENGLISH).write(List.of(new MatrixTopic())));
        assertEquals(3, asked.get());
        assertTrue(Files.exists(folder.resolve("charts/matrix-front.svg")));
        assertFalse(Files.exists(folder.resolve("hazards/matrix.html")));
        assertTrue(page("index.html").contains("stopped before its end"));
    }

    @Test
    @DisplayName("a page of a run with other settings or in another language is linked as this one")
    void contentsLinkAnEarlierPageOnlyWithTheSameSettingsAndSayIt() throws Exception {
        List<MatrixTopic> matrix = List.of(new MatrixTopic());
        assertTrue(findings(8, false, Language.ENGLISH).write(matrix));
        assertFalse(page("index.html").contains("earlier run"), "this run wrote it");
        findings(8, true, Language.ENGLISH).write(matrix);
        assertTrue(page("index.html").contains("<a href=\"matrix.html\">"));
        assertTrue(
                page("index.html").contains("of an earlier run with the same settings, begun 20"));
        assertTrue(page("course.html").contains("charts/matrix-front.svg"));
        assertTrue(page("course.html").contains("in an earlier run"));
        findings(9, true, Language.ENGLISH).write(matrix);
        assertFalse(page("index.html").contains("matrix.html"), "other settings");
        assertTrue(page("index.html").contains("it is not linked"));
        assertFalse(page("course.html").contains("matrix-front"));
        findings(8, true, Language.RUSSIAN).write(matrix);
        assertFalse(page("index.html").contains("matrix.html"), "another language");
    }

    @Test
    @DisplayName("a page repeats its charts in another language, or breaks a line behind a number")
    void russianPageRepeatsItselfInRussianAndKeepsNumbersWithWords() throws Exception {
        findings(false, Language.RUSSIAN).write(List.of(new ViewTopic()));
        String view = page("view.html");
        assertTrue(view.contains("./lab --lang ru study view --quick --seed 1 --chart front"));
        assertTrue(view.contains("./lab --lang ru hazards view"));
        assertTrue(view.contains("title=\"./lab --lang ru run view "), "in the cells");
        for (String text : List.of(view, page("hazards/view.html")))
            assertFalse(Pattern.compile("\\./lab (?!--lang ru )").matcher(text).find());
        assertTrue(view.contains("<h1>Вид по"), "a title begins with a capital");
        assertFalse(Pattern.compile("<p>[^<]*\\d \\p{L}").matcher(view).find());
    }
}
