package rasterlab.exercises.line;

import static java.util.stream.Collectors.toSet;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.Pixel;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.Exercise.ExerciseTolerance;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.PicturePart;

/** The exercise proves its own cases: faulty methods fail, right ones do not. */
class LineExerciseTest {
    private static final Exercise EXERCISE = Catalogue.builtIn().named("line-bresenham");
    private static final long[] SEEDS = {0, 1, 42, -7, Long.MAX_VALUE};

    static Stream<Method<LineRasterizer>> right() {
        return new LineTopic().methods().stream().filter(method -> !failsSomewhere(method));
    }

    static Stream<Method<LineRasterizer>> faulty() {
        return new LineTopic()
                .methods().stream().filter(Method::faulty).filter(LineExerciseTest::failsSomewhere);
    }

    /** Whether the method fails on a segment without a window, as the exercise's are. */
    private static boolean failsSomewhere(Method<LineRasterizer> method) {
        return new LineTopic()
                .hazards().stream()
                        .filter(hazard -> hazard.input().isWhole())
                        .map(hazard -> hazard.recorded().get(method.name()))
                        .anyMatch(
                                kind -> kind != Verdict.Kind.EXACT && kind != Verdict.Kind.REFUSED);
    }

    @Test
    void theFloatDdaFailsWhereFloatsEnd() {
        LineRasterizer method = new LineTopic().method("dda-float").implementation();
        for (long seed : SEEDS) {
            List<String> failed = failed(method, EXERCISE.cases(), seed);
            assertTrue(failed.contains("long-line-drifts"), () -> "seed " + seed + failed);
        }
    }

    @ParameterizedTest
    @MethodSource("right")
    void aRightMethodFailsNoCase(Method<LineRasterizer> method) {
        for (long seed : SEEDS)
            assertEquals(
                    List.of(),
                    failed(method.implementation(), EXERCISE.cases(), seed),
                    () -> method.name() + " with seed " + seed);
    }

    @ParameterizedTest
    @MethodSource("faulty")
    void aFaultyMethodFailsOpenAndHiddenAccuracyCases(Method<LineRasterizer> method) {
        for (long seed : SEEDS) {
            List<String> failed = failed(method.implementation(), accuracy(), seed);
            assertTrue(
                    failed.stream().anyMatch(name -> name.startsWith("octant-")),
                    () -> method.name() + " with seed " + seed + " fails only " + failed);
            assertTrue(
                    failed.stream().anyMatch(name -> !name.startsWith("octant-")),
                    () -> method.name() + " with seed " + seed + " fails only " + failed);
        }
    }

    private static List<Case> accuracy() {
        return EXERCISE.cases().stream().filter(one -> one.kind() == Criterion.ACCURACY).toList();
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("rasterlab.exercises.line.LineMutants#all")
    void theCaseCatchesTheMistakeItIsNamedAfter(String name, LineRasterizer method) {
        List<String> failed = failed(method, EXERCISE.cases(), 3);
        assertTrue(failed.contains(name), failed::toString);
    }

    @Test
    void everyNamedMistakeIsMadeByAMutant() {
        assertEquals(
                EXERCISE.cases().stream()
                        .filter(one -> !one.generated() || one.name().equals("long-line-drifts"))
                        .map(Case::name)
                        .collect(toSet()),
                LineMutants.all().map(mutant -> mutant.get()[0]).collect(toSet()));
    }

    @Test
    void theSeedDrawsTheHiddenSegmentsInTheirOctant() {
        for (Case one : EXERCISE.cases()) {
            if (!one.generated() || !one.name().startsWith("octant-")) continue;
            List<Segment> drawn = TriedSegments.of(EXERCISE, one, 5);
            assertEquals(drawn, TriedSegments.of(EXERCISE, one, 5));
            assertNotEquals(drawn, TriedSegments.of(EXERCISE, one, 6));
            int octant = one.name().charAt(7) - '0';
            for (Segment segment : drawn) assertInOctant(octant, segment);
        }
    }

    private static void assertInOctant(int octant, Segment segment) {
        double degrees =
                Math.toDegrees(
                        Math.atan2(segment.y1() - segment.y0(), segment.x1() - segment.x0()));
        double turned = degrees < 0 || degrees == 0 && octant == 8 ? degrees + 360 : degrees;
        assertTrue(
                turned >= 45 * (octant - 1) && turned <= 45 * octant,
                () -> segment + " at " + turned + "° is not in octant " + octant);
    }

    private static List<String> failed(LineRasterizer method, List<Case> cases, long seed) {
        return MarkedMethod.of(EXERCISE, method, CaseSelection.all(seed)).failed(cases);
    }

    @Test
    void eitherPixelOfATieIsRightUnlessTheCaseIsStrict() {
        Segment tied = new Segment(0, 0, 2, 1);
        PixelRecording upper = new PixelRecording(3);
        IntStream.of(0, 1, 2).forEach(x -> upper.plot(x, (x + 1) / 2));
        Answer answer = answer(Answer.CallEnding.RETURNED, upper);
        assertEquals(Finding.OK, call(tied, "", true).judge(answer));
        assertEquals(GradingVerdict.WRONG, call(tied, "", false).judge(answer).verdict());
        Finding finding = call(tied, ", \"strict\": true", true).judge(answer);
        assertEquals("#-.\n.+#", text(finding, CasePicture.DIFFERENCE));
        assertEquals("##.\n..#", text(finding, CasePicture.EXPECTED));
        assertEquals("#..\n.##", text(finding, CasePicture.ACTUAL));
    }

    /** A shift of the line between right ends and one along itself would take each other back. */
    @ParameterizedTest(name = "rounding towards 0 is told as a shift: {0}, {1}")
    @CsvSource({"3, 1", "3, -1", "3, 2", "-3, 1", "1, 3", "-1, -3"})
    void aLineBetweenRightEndsIsNotShifted(int x1, int y1) {
        int n = Math.max(Math.abs(x1), Math.abs(y1));
        PixelRecording truncated = new PixelRecording(n + 1);
        for (int k = 0; k <= n; k++) truncated.plot(k * x1 / n, k * y1 / n);
        Answer answer = answer(Answer.CallEnding.RETURNED, truncated);
        Finding finding = call(new Segment(0, 0, x1, y1), "", true).judge(answer);
        assertEquals(GradingVerdict.WRONG, finding.verdict());
        assertEquals(
                List.of(List.of("quotient-truncated"), List.of("coordinate-truncated")),
                finding.explanations().stream()
                        .map(causes -> causes.stream().map(Cause::code).toList())
                        .toList());
        assertFalse(finding.message().in("en").contains("shifted"), finding.message().in("en"));
    }

    private static String text(Finding finding, String kind) {
        return CasePicture.of(finding.pictures(), kind).orElseThrow().text().in("en");
    }

    /** The engine says in English what is wrong first; a form that is not known stays English. */
    @ParameterizedTest(name = "first difference stays English: {0}")
    @ValueSource(
            strings = {
                "0,0 2,0",
                "0,0 1,1 2,0",
                "0,0 1,0 2,0 3,0",
                "0,0 1,0 2,0 2,0",
                "2,0 1,0 0,0"
            })
    void theFirstDifferenceIsToldInRussian(String drawn) {
        PixelRecording pixels = new PixelRecording(9);
        for (String pixel : drawn.split(" "))
            pixels.plot(pixel.charAt(0) - '0', pixel.charAt(2) - '0');
        Segment segment = new Segment(0, 0, 2, 0);
        Answer answer = answer(Answer.CallEnding.RETURNED, pixels);
        String said = call(segment, "", false).judge(answer).message().in("ru");
        assertTrue(said.matches(".*(пиксел).*") && !said.contains("pixel"), said);
    }

    @Test
    void theSceneIsJsonInEveryCountry() {
        Locale before = Locale.getDefault();
        Locale.setDefault(Locale.forLanguageTag("ar-EG-u-nu-arab"));
        try {
            assertEquals(
                    "{\"version\":1,\"topic\":\"line\",\"method\":\"bresenham\","
                            + "\"input\":{\"from\":[12,-3],\"to\":[0,7]}}",
                    call(new Segment(12, -3, 0, 7), "", true).scene());
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void theSceneOfAWrongCaseKeepsWhatWasDrawn() {
        Segment segment = new Segment(0, 0, 1, 0);
        PixelRecording wrong = new PixelRecording(3);
        wrong.plot(0, -1);
        wrong.plot(1, 0);
        Answer answer = answer(Answer.CallEnding.RETURNED, wrong);
        String scene = call(segment, "", true).scene(Optional.of(answer));
        assertTrue(scene.endsWith(",\"drawn\":[[0,-1],[1,0]]}"), scene);
    }

    @Test
    void theSceneSaysWhereWhatWasDrawnWasCut() {
        Segment segment = new Segment(0, 0, 9, 0);
        PixelRecording wrong = new PixelRecording(1);
        wrong.plot(0, -1);
        Answer answer = answer(Answer.CallEnding.CUT, wrong);
        String scene = call(segment, "", true).scene(Optional.of(answer));
        assertTrue(scene.endsWith(",\"drawn\":[[0,-1]],\"drawnCut\":true}"), scene);
    }

    @Test
    void aPixelPlottedTwiceIsWrong() {
        Segment segment = new Segment(0, 0, 1, 0);
        PixelRecording twice = new PixelRecording(3);
        twice.plot(0, 0);
        twice.plot(1, 0);
        twice.plot(1, 0);
        Finding finding = call(segment, "", true).judge(answer(Answer.CallEnding.RETURNED, twice));
        assertEquals("pixel (1, 0) is drawn again", finding.message().toString().split(";")[0]);
    }

    @Test
    @DisplayName("three equal pictures are shown of pixels that are right but drawn again")
    void onePixelWithoutEndIsSeenToBeWrong() {
        Segment point = new Segment(4, 3, 4, 3);
        PixelRecording endless = new PixelRecording(9);
        for (int i = 0; i < 9; i++) endless.plot(4, 3);
        assertMarked(point, endless, Answer.CallEnding.CUT);
    }

    @Test
    @DisplayName("three equal pictures are shown of right pixels that come backwards")
    void pixelsThatComeBackwardsAreSeenToBeWrong() {
        PixelRecording backwards = new PixelRecording(2);
        backwards.plot(1, 0);
        backwards.plot(0, 0);
        assertMarked(new Segment(0, 0, 1, 0), backwards, Answer.CallEnding.RETURNED);
    }

    @Test
    @DisplayName("three equal pictures are shown of a long line whose end is drawn again")
    void aPixelOutsideTheFirstPartIsSeenToBeDrawnAgain() {
        PixelRecording again = new PixelRecording(100);
        for (int x = 0; x < 99; x++) again.plot(x, 0);
        again.plot(98, 0);
        assertMarked(new Segment(0, 0, 98, 0), again, Answer.CallEnding.RETURNED);
    }

    @ParameterizedTest(name = "the picture shows another place than the message names: {0}, {1}")
    @CsvSource({"-2000000000, -2000000000", "2000000000, 2000000000", "0, -1"})
    void thePictureShowsThePixelOfTheMessage(int x, int y) {
        Segment segment = new Segment(0, 0, 500, 0);
        PixelRecording drawn = new PixelRecording(501);
        for (int i = 0; i <= 500; i++) drawn.plot(i == 300 ? x : i, i == 300 ? y : 0);
        Answer answer = answer(Answer.CallEnding.RETURNED, drawn);
        Finding finding = call(segment, "", true).judge(answer);
        assertTrue(finding.message().toString().startsWith("pixel (300, 0) is missing"));
        PicturePart part = finding.pictures().get(0).part().orElseThrow();
        assertTrue(part.shown().contains(300, 0), part::toString);
        assertEquals(new Pixel(300, 0), part.pixel());
    }

    private static void assertMarked(
            Segment segment, PixelRecording drawn, Answer.CallEnding ending) {
        Answer answer = answer(ending, drawn);
        List<CasePicture> pictures = call(segment, "", true).judge(answer).pictures();
        assertEquals(3, pictures.size());
        assertFalse(Arrays.equals(pictures.get(0).png(), pictures.get(2).png()));
    }

    /** A case's only call, with further fields of its input. */
    private static GradedCall call(Segment s, String further, boolean eitherOnTies) {
        String input =
                String.format(
                        Locale.ROOT,
                        "{\"given\": {\"from\": [%d, %d], \"to\": [%d, %d]}%s}",
                        s.x0(),
                        s.y0(),
                        s.x1(),
                        s.y1(),
                        further);
        Case one =
                new Case("a-case", Map.of(), Criterion.ACCURACY, Disclosure.OPEN, 0, input, false);
        return new LineGrading().calls(one, new ExerciseTolerance(eitherOnTies), 0).get(0);
    }

    private static Answer answer(Answer.CallEnding ending, PixelRecording drawn) {
        return Answer.with(ending, drawn, drawn.size(), "", "");
    }
}
