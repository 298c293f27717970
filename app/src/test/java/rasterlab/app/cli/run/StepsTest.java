package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.contract.Curve;
import rasterlab.contract.CurvePoints;
import rasterlab.contract.SplineEnds;
import rasterlab.engine.clip.ClippedEnds;
import rasterlab.engine.clip.segment.SegmentClipFormat;
import rasterlab.engine.clip.segment.SegmentWalk;
import rasterlab.engine.clip.segment.SteppedSegmentClipper;
import rasterlab.engine.clip.volume.SteppedVolumeClipper;
import rasterlab.engine.clip.volume.VolumeClipFormat;
import rasterlab.engine.clip.volume.VolumeWalk;
import rasterlab.engine.format.AnswerLimitReached;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.polygon.inside.EdgeWalk;
import rasterlab.engine.polygon.inside.PolygonTestFormat;
import rasterlab.engine.polygon.inside.SteppedPolygonTest;
import rasterlab.engine.polygon.triangle.SideWalk;
import rasterlab.engine.polygon.triangle.SteppedTriangleTest;
import rasterlab.engine.polygon.triangle.TriangleFormat;
import rasterlab.engine.spline.curve.CurveFormat;
import rasterlab.engine.spline.curve.CurveWalk;
import rasterlab.engine.spline.curve.PointStep;
import rasterlab.engine.spline.curve.SteppedCurve;
import rasterlab.engine.spline.curve.SteppedPoint;
import rasterlab.engine.spline.function.SplineFunctionFormat;
import rasterlab.engine.spline.function.SplineWalk;
import rasterlab.engine.spline.function.SteppedSpline;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.Images;
import rasterlab.engine.transform.rotate.RotateFormat;
import rasterlab.engine.transform.rotate.SteppedRotation;
import rasterlab.engine.transform.rotate.TurnWalk;
import rasterlab.engine.transform.view.SteppedView;
import rasterlab.engine.transform.view.ViewFormat;
import rasterlab.engine.transform.view.ViewStep;

/** Methods that answer, and whose walk crashes. */
class StepsTest {
    private static final Watch WATCH = new Watch(Duration.ofSeconds(60));
    private static final Images IMAGES = new Images(new double[3], 3);
    private static final ClippedEnds ENDS = new ClippedEnds(List.of(Optional.of(new double[6])), 0);

    @ParameterizedTest(name = "half an answer is written before a walk crashes: {argumentSetName}")
    @MethodSource("brokenWalks")
    void walkThatCrashesIsGivenUpBeforeAnythingIsWritten(TopicRunner<?> run, String in) {
        byte[] text = in.getBytes(StandardCharsets.UTF_8);
        Complaint complaint =
                assertThrows(Complaint.class, () -> run.answer("broken", text, text.length, true));
        assertEquals(
                "broken crashed: java.lang.IllegalStateException: torn", complaint.getMessage());
        assertEquals(ExitCode.GAVE_UP, complaint.exitCode());
    }

    @Test
    void stepsAreNotKeptBeyondTheMostOfOneAnswer() {
        var steps = new ArrayList<Integer>(Collections.nCopies(999_999, 7));
        RecordedSteps.add(steps, 7);
        var more = assertThrows(AnswerLimitReached.class, () -> RecordedSteps.add(steps, 7));
        assertEquals(
                "--steps: more than 1000000 steps, the most that one answer may have",
                more.getMessage());
    }

    static Stream<Arguments> brokenWalks() {
        return Stream.of(
                argumentSet(
                        "point-in-polygon",
                        runner(new OneMethod<>(new BrokenTest(), null), PolygonTestFormat::new),
                        "{\"polygon\":[[0,0],[1,0],[0,1]],\"points\":[[0,0]]}"),
                argumentSet(
                        "point-in-triangle",
                        runner(new OneMethod<>(new BrokenSides(), null), TriangleFormat::new),
                        "{\"triangle\":[[0,0],[1,0],[0,1]],\"points\":[[0,0]]}"),
                argumentSet(
                        "rotate",
                        runner(new OneMethod<>(new BrokenTurn(), null), RotateFormat::new),
                        "{\"points\":[[0,0]],\"degrees\":9}"),
                argumentSet(
                        "view",
                        runner(new OneMethod<>(new BrokenView(), IMAGES), ViewFormat::new),
                        "{\"points\":[[0,0,0]],\"theta\":1,\"phi\":2,\"rho\":3}"),
                argumentSet(
                        "curve at t",
                        runner(new OneMethod<>(new BrokenPoint(), null), CurveFormat::new),
                        "{\"kind\":\"bezier\",\"points\":[[0,0],[1,0]],\"at\":[0.5]}"),
                argumentSet(
                        "curve",
                        runner(new OneMethod<>(new BrokenCurve(), null), CurveFormat::new),
                        "{\"kind\":\"bezier\",\"points\":[[0,0],[1,0],[0,1],[2,2]],\"flatness\":1}"),
                argumentSet(
                        "spline-function",
                        runner(
                                new OneMethod<>(new BrokenSpline(), null),
                                SplineFunctionFormat::new),
                        "{\"x\":[0,1],\"y\":[0,1],\"ends\":{\"kind\":\"natural\"},\"at\":[]}"),
                argumentSet(
                        "clip-segment",
                        runner(new OneMethod<>(new BrokenClipper(), ENDS), SegmentClipFormat::new),
                        "{\"window\":[0,0,1,1],\"segments\":[[0,0,1,1]]}"),
                argumentSet(
                        "clip-volume",
                        runner(new OneMethod<>(new BrokenVolume(), ENDS), VolumeClipFormat::new),
                        "{\"zmin\":0.5,\"segments\":[[0,0,1,1,0,1]]}"));
    }

    private static <C, I, O> TopicRunner<?> runner(
            OneMethod<C, I, O> topic, Function<Topic<C, I, O>, Format<C, I, O>> format) {
        return new TopicRunner<>(WATCH, topic, format.apply(topic));
    }

    private static final class BrokenTest implements SteppedPolygonTest {
        @Override
        public EdgeWalk walk(double[] polygonX, double[] polygonY, double x, double y) {
            throw new IllegalStateException("torn");
        }

        @Override
        public boolean contains(double[] polygonX, double[] polygonY, double x, double y) {
            return true;
        }

        @Override
        public String countFormula() {
            return "";
        }
    }

    private static final class BrokenSides implements SteppedTriangleTest {
        @Override
        public SideWalk walk(
                double ax,
                double ay,
                double bx,
                double by,
                double cx,
                double cy,
                double x,
                double y) {
            throw new IllegalStateException("torn");
        }

        @Override
        public boolean contains(
                double ax,
                double ay,
                double bx,
                double by,
                double cx,
                double cy,
                double x,
                double y) {
            return true;
        }

        @Override
        public String valueFormula() {
            return "";
        }
    }

    private static final class BrokenTurn implements SteppedRotation {
        @Override
        public TurnWalk walk(double degrees, int times, double x, double y) {
            throw new IllegalStateException("torn");
        }

        @Override
        public void rotate(double degrees, int times, double[] points) {}
    }

    private static final class BrokenView implements SteppedView {
        @Override
        public List<ViewStep> steps(
                double theta, double phi, double rho, double x, double y, double z) {
            throw new IllegalStateException("torn");
        }

        @Override
        public void view(double theta, double phi, double rho, double[] points) {}
    }

    private static final class BrokenPoint implements SteppedPoint {
        @Override
        public List<PointStep> stepsAt(Curve curve, double t) {
            throw new IllegalStateException("torn");
        }

        @Override
        public void at(Curve curve, double[] t, CurvePoints out) {
            out.point(0, 0);
        }

        @Override
        public void flatten(Curve curve, double flatness, CurvePoints out) {
            throw new UnsupportedOperationException("only single points");
        }
    }

    private static final class BrokenCurve implements SteppedCurve {
        @Override
        public CurveWalk walk(Curve curve, double flatness) {
            throw new IllegalStateException("torn");
        }

        @Override
        public void at(Curve curve, double[] t, CurvePoints out) {
            throw new UnsupportedOperationException("only flattens");
        }

        @Override
        public void flatten(Curve curve, double flatness, CurvePoints out) {
            out.point(0, 0);
        }

        @Override
        public String decisionFormula() {
            return "";
        }
    }

    private static final class BrokenSpline implements SteppedSpline {
        @Override
        public SplineWalk walk(double[] x, double[] y, SplineEnds ends) {
            throw new IllegalStateException("torn");
        }

        @Override
        public double[] coefficients(double[] x, double[] y, SplineEnds ends) {
            return new double[4];
        }

        @Override
        public String decisionFormula() {
            return "";
        }
    }

    private static final class BrokenClipper implements SteppedSegmentClipper {
        @Override
        public SegmentWalk walk(
                double xmin,
                double ymin,
                double xmax,
                double ymax,
                double x0,
                double y0,
                double x1,
                double y1) {
            throw new IllegalStateException("torn");
        }

        @Override
        public String decisionFormula() {
            return "";
        }
    }

    private static final class BrokenVolume implements SteppedVolumeClipper {
        @Override
        public VolumeWalk walk(
                double zmin, double x0, double y0, double z0, double x1, double y1, double z1) {
            throw new IllegalStateException("torn");
        }

        @Override
        public String decisionFormula() {
            return "";
        }
    }
}
