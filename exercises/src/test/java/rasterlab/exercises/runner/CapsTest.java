package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import rasterlab.exercises.Capped;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.StatedLimits;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;

/** A call is stopped where its exercise says. */
@Tag("slow")
class CapsTest {
    private static final String FACE =
            """
            import rasterlab.contract.*;

            public class Mine implements FaceShader {
                public double[] shade(LitFace face, double[] weights) {
                    %s
                }
            }
            """;

    private static final String CLIP =
            """
            import rasterlab.contract.*;

            public class Mine implements SegmentClipper {
                public void clip(double xmin, double ymin, double xmax, double ymax,
                        double x0, double y0, double x1, double y1, SegmentSink out) {
                    %s
                }
            }
            """;

    /** A source that answers true, wherever the point is. */
    private static final String INSIDE =
            """
            import rasterlab.contract.*;

            public class Mine implements PointInTriangle {
                public boolean contains(double ax, double ay, double bx, double by,
                        double cx, double cy, double x, double y) {
                    return true;
                }
            }
            """;

    /** About 0.3 s of processor time, which no compiler leaves out. */
    private static final String BURN =
            "double waste = 1; for (int i = 0; i < 60_000_000; i++) waste = Math.sqrt(waste + i);"
                    + " if (waste == 0) throw new IllegalStateException();";

    /** About 0.9 s: more than a limit that a first call keeps on a busy machine too. */
    private static final String BURN_LONG = "for (int j = 0; j < 3; j++) {" + BURN + "}";

    @RegisterExtension static final StartedJudge JUDGE = new StartedJudge();

    @Test
    @DisplayName("an answer of 80 bytes is taken where 60 are allowed, or one of 40 is not")
    void bytesAreLimited() throws Exception {
        StatedLimits sixty =
                new StatedLimits(OptionalInt.empty(), OptionalInt.of(60), Optional.empty());
        CaseReport more = first("shade-face", sixty, FACE.formatted("return new double[9];"));
        assertEquals(GradingVerdict.OUTPUT_LIMIT, more.verdict(), more.message());
        assertEquals("its answer is longer than what is taken", more.message());
        CaseReport taken = first("shade-face", sixty, FACE.formatted("return new double[3];"));
        assertEquals(GradingVerdict.WRONG, taken.verdict(), taken.message());
    }

    @Test
    @DisplayName(
            "the least limit that an exercise may state stops an answer that is as long as a right one")
    void aRightAnswerHasRoomInTheLeastLimit() throws Exception {
        assertEquals(GradingVerdict.WRONG, ofTruth(2).verdict());
        assertEquals(GradingVerdict.OUTPUT_LIMIT, ofTruth(1).verdict());
    }

    private static CaseReport ofTruth(int bytes) throws Exception {
        StatedLimits caps =
                new StatedLimits(OptionalInt.empty(), OptionalInt.of(bytes), Optional.empty());
        return first("point-in-triangle", caps, INSIDE);
    }

    @Test
    @DisplayName("an answer of 24 MB is told as a want of memory")
    void aHugeAnswerIsToldByItsLength() throws Exception {
        CaseReport huge =
                first(
                        "shade-face",
                        StatedLimits.NONE,
                        FACE.formatted("return new double[3_000_000];"));
        assertEquals(GradingVerdict.OUTPUT_LIMIT, huge.verdict(), huge.message());
        assertEquals("its answer is longer than what is taken", huge.message());
        assertEquals("ответ длиннее, чем принимается", huge.explanation().in("ru"));
    }

    @Test
    @DisplayName("a method that goes on for ever is stopped at the usual number of items")
    void itemsAreLimited() throws Exception {
        StatedLimits thirty =
                new StatedLimits(OptionalInt.of(30), OptionalInt.empty(), Optional.empty());
        String source = CLIP.formatted("while (true) out.segment(x0, y0, x1, y1);");
        CaseReport endless = first("clip-segment", thirty, source);
        assertEquals(GradingVerdict.OUTPUT_LIMIT, endless.verdict(), endless.message());
        assertEquals("it goes on beyond the most items that are taken", endless.message());
    }

    @Test
    @DisplayName("a filling that never ends is told as the student's own exception")
    void writingsAreLimited() throws Exception {
        String source =
                """
                import rasterlab.contract.*;
                public class Endless implements SeedFiller {
                    public void fill(PixelGrid picture, int x, int y, int with, int connectivity) {
                        while (true) picture.write(x, y, with);
                    }
                }
                """;
        CaseReport endless = first("seed-fill", StatedLimits.NONE, source);
        assertEquals(GradingVerdict.OUTPUT_LIMIT, endless.verdict(), endless.message());
    }

    @Test
    @DisplayName("a call has the usual time, or names that")
    void timeIsLimited() throws Exception {
        StatedLimits tenth = seconds(Duration.ofMillis(100));
        String source = FACE.formatted("while (true);");
        CaseReport endless = first("shade-face", tenth, source);
        assertEquals(GradingVerdict.TIME_LIMIT, endless.verdict(), endless.message());
        assertTrue(endless.message().contains("0.1 s"), endless.message());
    }

    @Test
    @DisplayName("six calls for one input have the time of six inputs")
    void allCallsForOneInputShareTheTime() throws Exception {
        StatedLimits second = seconds(Duration.ofSeconds(1));
        Exercise clip = Capped.with(Catalogue.builtIn().named("clip-segment"), second);
        Report report = JUDGE.grade(clip, CLIP.formatted(BURN), CaseSelection.open());
        assertTrue(
                report.cases().stream().anyMatch(one -> one.verdict() == GradingVerdict.TIME_LIMIT),
                () -> report.cases().stream().map(CaseReport::message).toList().toString());
    }

    @Test
    @DisplayName("a call has the time of all calls that it is timed with")
    void eachOfTheTimedCallsHasItsTime() throws Exception {
        Exercise circle =
                Capped.with(Catalogue.builtIn().named("circle"), seconds(Duration.ofMillis(300)));
        String head = "int radius, Pixels out) {";
        String slowInTheEnd =
                circle.evidence()
                        .model()
                        .orElseThrow()
                        .replace("private static void", "private int calls; static void")
                        .replaceFirst(
                                Pattern.quote(head),
                                head + "if (++calls > 120 && calls % 20 == 0) {" + BURN_LONG + "}");
        Report report = JUDGE.grade(circle, slowInTheEnd, CaseSelection.all(7));
        String said = report.speed().orElseThrow().message();
        String failed =
                report.cases().stream()
                        .filter(one -> one.verdict() != GradingVerdict.OK)
                        .map(one -> one.name() + ": " + one.message())
                        .collect(Collectors.joining("\n", said + "\n", ""));
        assertEquals(75, report.points().accuracy(), failed);
        assertTrue(said.contains("stopped while speed was measured"), said);
        assertTrue(said.contains("no answer within 0.3 s of processor time"), said);
    }

    private static StatedLimits seconds(Duration most) {
        return new StatedLimits(OptionalInt.empty(), OptionalInt.empty(), Optional.of(most));
    }

    private static CaseReport first(String id, StatedLimits caps, String source) throws Exception {
        return JUDGE.grade(
                        Capped.with(Catalogue.builtIn().named(id), caps),
                        source,
                        CaseSelection.open())
                .cases()
                .get(0);
    }
}
