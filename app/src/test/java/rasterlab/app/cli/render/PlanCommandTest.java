package rasterlab.app.cli.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Ran;

class PlanCommandTest {
    @TempDir Path folder;

    @Test
    void billNamesEachDecisionWithItsReasonAndBothCosts() throws Exception {
        Path out = folder.resolve("least.png");
        Ran ran = plan("cube", "--levels", "4", "--json", "--prove", "--out", out.toString());
        ran.assertDone();
        JsonNode bill = new ObjectMapper().readTree(ran.out());
        assertTrue(bill.path("decisions").size() >= 2, ran.out());
        for (JsonNode decision : bill.path("decisions"))
            assertFalse(decision.path("because").asText().isEmpty(), ran.out());
        assertTrue(bill.path("measured").path("within").asBoolean(), ran.out());
        assertTrue(bill.path("predicted").path("fullMilliseconds").asDouble() > 0, ran.out());
        assertTrue(bill.path("measured").path("fullProcessorMilliseconds").asDouble() > 0);
        assertTrue(bill.path("combinations").size() > 0, ran.out());
        JsonNode path = bill.path("path");
        assertEquals(100, path.path("pictures").asInt(), ran.out());
        assertTrue(path.path("plans").asInt() < 100, ran.out());
        assertTrue(path.path("firstMilliseconds").asDouble() > 0, ran.out());
        assertTrue(path.path("perPictureMilliseconds").asDouble() > 0, ran.out());
        assertTrue(Files.size(out) > 0);
    }

    @Test
    void billIsWrittenInRussianToo() {
        Ran ran = plan("torus", "--lang", "ru");
        ran.assertDone();
        assertTrue(ran.out().contains("видимость: "), ran.out());
        assertFalse(ran.out().contains("reason."), ran.out());
        assertFalse(ran.out().matches("(?s).*(depths|faces|light) .*"), ran.out());
    }

    @Test
    @DisplayName("a picture with a tolerance is another than the plan's, or does not say why")
    void toleranceDrawsThePlannedPicture() throws Exception {
        Path planned = folder.resolve("planned.png");
        plan("torus", "--tolerance=1", "--levels=6", "--out=" + planned).assertDone();
        Path drawn = folder.resolve("drawn.png");
        Ran ran =
                tolerant("torus", "--tolerance=1", "--levels=6", "--size=80x60", "--out=" + drawn);
        ran.assertDone();
        assertArrayEquals(Files.readAllBytes(planned), Files.readAllBytes(drawn));
        JsonNode report = new ObjectMapper().readTree(ran.out());
        assertEquals(6, report.path("plan").path("tolerance").path("levels").asDouble());
        assertTrue(report.path("plan").path("levels").asDouble() <= 6, ran.out());
        JsonNode decisions = report.path("plan").path("decisions");
        assertTrue(decisions.size() >= 2, ran.out());
        for (JsonNode decision : decisions)
            assertFalse(decision.path("because").asText().isEmpty(), ran.out());
    }

    @Test
    @DisplayName("what the plan decided is said to be asked for, or a term that it drops is listed")
    void reportSaysThatThePlanDecided() throws Exception {
        Path drawn = folder.resolve("vase.png");
        Ran ran =
                tolerant("vase", "--tolerance=1", "--levels=8", "--size=320x240", "--out=" + drawn);
        ran.assertDone();
        JsonNode report = new ObjectMapper().readTree(ran.out());
        for (String choice : new String[] {"visibilityBecause", "shadingBecause"})
            assertTrue(report.path(choice).asText().startsWith("plan: "), ran.out());
        assertEquals("[\"ambient\",\"diffuse\",\"emission\"]", report.path("terms").toString());
    }

    @Test
    @DisplayName("the cheapest combination is the plan, and yet cheaper than it")
    void proofKnowsThePlanItself() {
        Ran english =
                Ran.lab("plan", "vase", "--tolerance=1", "--levels=8", "--size=320x240", "--prove");
        english.assertDone();
        assertTrue(english.out().contains("light: specular left out\n"), english.out());
        boolean itself = english.out().contains("is the plan itself");
        assertFalse(itself && english.out().contains("times as much"), english.out());
        Ran russian = plan("vase", "--tolerance", "0.5", "--levels", "8", "--lang", "ru");
        assertTrue(russian.out().contains("0,5\u00a0пикс."), russian.out());
        assertTrue(russian.out().contains("затраты: неотрицательный метод"), russian.out());
        assertFalse(russian.out().contains("squares"), russian.out());
    }

    @Test
    @DisplayName("the full pipeline is 0.942 of itself")
    void planThatLeavesNothingOutIsTheSame() {
        Ran full = plan("textured-quad", "--tolerance", "0.001", "--levels", "0");
        full.assertDone();
        assertFalse(leavesOut(full), full.out());
        assertTrue(
                full.out().contains("the plan is the full pipeline, so the same; 1"), full.out());
        assertFalse(full.out().contains(" of it"), full.out());
        Ran less = plan("sphere", "--tolerance", "0.001", "--levels", "0");
        less.assertDone();
        assertTrue(leavesOut(less), less.out());
        assertFalse(less.out().contains("the same; 1"), less.out());
        assertTrue(less.out().matches("(?s).*processor [^\\n]* instead of [^\\n]* of it\\n.*"));
    }

    private static boolean leavesOut(Ran ran) {
        return ran.out().matches("(?s).* instead of \\p{Alpha}.*")
                || ran.out().contains(" left out\n");
    }

    @Test
    @DisplayName("shading is chosen by whether there is a highlight, and not by the levels")
    void levelsAloneChooseTheShading() throws Exception {
        String out = "--out=" + folder.resolve("shaded.png");
        for (String[] asked :
                new String[][] {
                    {"vase", "8", "flat", "one colour a face is at most "},
                    {"vase", "3", "gouraud", "light mixed from corners is at most "},
                    {"torus", "8", "phong", "light mixed from corners may be more than "}
                }) {
            Ran ran = tolerant(asked[0], "--levels=" + asked[1], "--size=80x60", out);
            ran.assertDone();
            JsonNode report = new ObjectMapper().readTree(ran.out());
            assertEquals(asked[2], report.path("shading").asText(), ran.out());
            String reason = report.path("shadingBecause").asText();
            assertTrue(reason.startsWith(asked[3]), reason);
            assertTrue(reason.contains(asked[1] + ".0 levels off"), reason);
        }
    }

    private static Ran tolerant(String... options) {
        return Ran.lab(
                Stream.concat(Stream.of("render"), Stream.of(options)).toArray(String[]::new));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("tolerantMistakes")
    void oneLineSaysWhyNoPictureIsPlanned(String part, String... options) {
        Path out = folder.resolve("b.png");
        String[] all =
                Stream.concat(Stream.of("cube", "--out=" + out), Stream.of(options))
                        .toArray(String[]::new);
        Ran ran = tolerant(all);
        assertEquals(2, ran.exitCode(), ran.err());
        assertEquals(1, ran.err().lines().count(), ran.err());
        assertTrue(ran.err().contains(part), ran.err());
        assertFalse(Files.exists(out));
    }

    static Stream<Arguments> tolerantMistakes() {
        return Stream.of(
                bad(
                        "levels of a shading that is asked for",
                        "--levels needs --tolerance, or faces and --shading auto",
                        "--levels=3",
                        "--shading=gouraud"),
                bad(
                        "levels where surfaces are drawn",
                        "--levels needs --tolerance, or faces and --shading auto",
                        "--levels=3",
                        "--visibility=raycast-surface"),
                bad("levels below 0", "--levels must be from 0 to 255, got -1", "--levels=-1"),
                bad("levels are no number", "--levels must be from 0 to 255", "--levels=NaN"),
                bad(
                        "levels for two eyes",
                        "--levels are for one eye",
                        "--levels=3",
                        "--stereo=anaglyph"),
                bad("tolerance is 0", allowed("0"), "--tolerance=0"),
                bad("tolerance is no number", allowed("NaN"), "--tolerance=NaN"),
                bad(
                        "levels are many",
                        "levels must be from 0 to 255",
                        "--tolerance=1",
                        "--levels=256"),
                bad(
                        "visibility is chosen",
                        "chooses the visibility",
                        "--tolerance=1",
                        "--visibility=z16"),
                bad("reference", "chooses the visibility", "--tolerance=1", "--reference"),
                bad("edges", "needs faces", "--tolerance=1", "--shading=wire"),
                bad("two eyes", "for one eye", "--tolerance=1", "--stereo=anaglyph"));
    }

    @Test
    void reportOfAPictureCountsItsWork() throws Exception {
        Path out = folder.resolve("a.png");
        Ran ran = Ran.lab("render", "torus", "--size", "80x60", "--out", out.toString());
        ran.assertDone();
        JsonNode report = new ObjectMapper().readTree(ran.out());
        assertEquals(80 * 60, report.path("counted").path("pixels").asInt());
        assertTrue(report.path("counted").path("fragments").asInt() > 500, ran.out());
        assertEquals(1, sum(report.path("predicted").path("shares")), 0.01);
    }

    @Test
    @DisplayName("a stage is counted and not predicted, or what is predicted is the count again")
    void predictionOfEachStageStandsBesideItsCount() throws Exception {
        String out = "--out=" + folder.resolve("a.png");
        for (String[] asked : new String[][] {{"vase"}, {"torus", "--tolerance=1", "--levels=6"}}) {
            Ran ran =
                    tolerant(
                            Stream.concat(Stream.of(asked), Stream.of("--size=80x60", out))
                                    .toArray(String[]::new));
            ran.assertDone();
            JsonNode report = new ObjectMapper().readTree(ran.out());
            JsonNode counted = report.path("counted");
            JsonNode planner = report.path("planner");
            assertEquals(names(counted), names(planner.path("work")), ran.out());
            long fragments = counted.path("fragments").asLong();
            long predicted = planner.path("work").path("fragments").asLong();
            assertNotEquals(fragments, predicted, "an estimate that no pixel is off: " + ran.out());
            assertEquals(fragments, predicted, 0.25 * fragments, ran.out());
            for (JsonNode told : List.of(report.path("predicted"), planner)) {
                assertEquals(1, sum(told.path("shares")), 0.01, ran.out());
                double all = told.path("processorMilliseconds").asDouble();
                assertEquals(all, sum(told.path("milliseconds")), 0.002, ran.out());
            }
            if (asked.length > 1)
                assertEquals(planner.path("work"), report.path("plan").path("work"), ran.out());
        }
    }

    private static List<String> names(JsonNode object) {
        List<String> names = new ArrayList<>();
        object.fieldNames().forEachRemaining(names::add);
        return names;
    }

    private static double sum(JsonNode numbers) {
        double sum = 0;
        for (JsonNode number : numbers) sum += number.asDouble();
        return sum;
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refusesWithOneLine(String line, String... arguments) {
        Ran ran = plan(arguments);
        assertEquals(2, ran.exitCode(), ran.err());
        assertEquals("", ran.out());
        assertTrue(ran.err().contains(line), ran.err());
        assertEquals(1, ran.err().lines().count(), ran.err());
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                bad("unknown scene", "no scene 'nosuch'", "nosuch"),
                bad("no tolerance at all", allowed("0"), "cube", "--tolerance", "0"),
                bad("negative tolerance", allowed("-1"), "cube", "--tolerance", "-1"),
                bad("tolerance is no number", allowed("NaN"), "cube", "--tolerance", "NaN"),
                bad("tolerance is endless", allowed("Infinity"), "cube", "--tolerance=Infinity"),
                bad(
                        "tolerance is a word",
                        "'--tolerance': 'fine' is not a number; expected one above 0 and at most 64",
                        "cube",
                        "--tolerance=fine"),
                bad(
                        "levels are a word",
                        "'--levels': 'few' is not a number; expected one from 0 to 255",
                        "cube",
                        "--levels=few"),
                bad(
                        "share is a word",
                        "'--error': 'some' is not a number; expected one from 0 to 1",
                        "cube",
                        "--error=some"),
                bad(
                        "negative levels",
                        "--levels must be from 0 to 255, got -1",
                        "cube",
                        "--levels",
                        "-1"),
                bad(
                        "share above all",
                        "--error must be from 0 to 1, got 1.5",
                        "cube",
                        "--error",
                        "1.5"),
                bad("picture of another kind", "allowed is .png", "cube", "--out", "a.gif"),
                bad("unwritable place", "no folder /nosuch", "cube", "--out", "/nosuch/a.png"));
    }

    private static String allowed(String typed) {
        return "--tolerance must be above 0 and at most 64 pixels, got " + typed;
    }

    private static Arguments bad(String name, String line, String... arguments) {
        return argumentSet(name, line, arguments);
    }

    private static Ran plan(String... arguments) {
        String[] usual = {"plan", "--size", "80x60"};
        return Ran.lab(Stream.of(usual, arguments).flatMap(Stream::of).toArray(String[]::new));
    }
}
