package rasterlab.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import rasterlab.contract.ColorConverter;
import rasterlab.contract.ColorModel;
import rasterlab.contract.PointTransformer;
import rasterlab.contract.PolygonClipper;
import rasterlab.contract.SeedFiller;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict.Kind;
import rasterlab.engine.visibility.depth.DepthCoding;

/**
 * Compares the promises of a contract beside the answer itself. What a mutant is listed for is not
 * here again: directions of pieces and polylines, the order of rows, ends that stay.
 */
class PromisesTest {
    @Test
    void aFillInAnotherColorIsWrong() {
        SeedFiller right = right("fill", "stack");
        SeedFiller pale =
                (picture, x, y, with, connectivity) ->
                        right.fill(picture, x, y, with + 1, connectivity);
        assertEquals(Kind.WRONG, kind("fill", "hole", pale));
    }

    @Test
    void aHueOf360IsNotTheUsualOne() {
        ColorConverter right = right("color", "formula");
        ColorConverter turned =
                (from, components, to) -> {
                    double[] color = right.convert(from, components, to);
                    if (to == ColorModel.HSV && color[0] == 0) color[0] = 360;
                    return color;
                };
        assertEquals(Kind.DEGRADED, kind("color", "pure-colours", turned));
    }

    @Test
    void aCornerInTheWindowThatMovesByOneStepIsSeen() {
        PolygonClipper right = right("clip-polygon", "weiler-atherton");
        PolygonClipper moving =
                (window, subject, out) ->
                        right.clip(
                                window,
                                subject,
                                piece -> {
                                    for (int i = 0; i < piece.length; i++)
                                        if (piece[i] == 5) piece[i] = Math.nextUp(5.0);
                                    out.polygon(piece);
                                });
        assertEquals(Kind.DEGRADED, kind("clip-polygon", "convex", moving));
    }

    @Test
    void aPointWithoutImageIsNaNAndNotInfinite() {
        PointTransformer right = right("transform", "double-double");
        PointTransformer infinite =
                (dimension, matrices, points, h) -> {
                    right.transform(dimension, matrices, points, h);
                    for (int i = 0; i < points.length; i++)
                        if (Double.isNaN(points[i])) points[i] = Double.POSITIVE_INFINITY;
                };
        assertEquals(Kind.WRONG, kind("transform", "at-the-eye", infinite));
    }

    /** One pixel at least must show it in every hazard that has more than one. */
    @Test
    void aDepthRowThatStartsLaterIsLookedAt() {
        DepthCoding right = right("depth-buffer", "reversed-z");
        DepthCoding fromTheFirst = range -> new FromTheFirst(right.over(range));
        assertTrue(some("depth-buffer", kind -> kind == Kind.EXACT, right));
        assertTrue(
                Topics.named("depth-buffer").hazards().stream()
                        .anyMatch(
                                hazard ->
                                        kind("depth-buffer", hazard.name(), right) == Kind.EXACT
                                                && kind("depth-buffer", hazard.name(), fromTheFirst)
                                                        != Kind.EXACT),
                "no hazard shows it");
    }

    private record FromTheFirst(DepthCoding.RangeCodes right) implements DepthCoding.RangeCodes {
        @Override
        public int code(double nearness) {
            return right.code(nearness);
        }

        @Override
        public void row(double base, double perPixel, int from, int to, int[] codes) {
            right.row(base, perPixel, 0, to - from, codes);
        }

        @Override
        public double stored(int code) {
            return right.stored(code);
        }

        @Override
        public double depth(int code) {
            return right.depth(code);
        }
    }

    private static boolean some(String topic, Predicate<Kind> wanted, Object method) {
        return Topics.named(topic).hazards().stream()
                .anyMatch(hazard -> wanted.test(kind(topic, hazard.name(), method)));
    }

    @SuppressWarnings("unchecked") // the test that asks knows the topic's contract
    private static <C> C right(String topic, String method) {
        return (C) Topics.named(topic).method(method).implementation();
    }

    @SuppressWarnings("unchecked") // as above
    private static <C, I, O> Kind kind(String name, String hazard, Object method) {
        var topic = (Topic<C, I, O>) Topics.named(name);
        Hazard<I> found =
                topic.hazards().stream()
                        .filter(each -> each.name().equals(hazard))
                        .findFirst()
                        .orElseThrow();
        return HazardTrial.judge(
                        topic, Method.failing("made-up", (C) method), found, Duration.ofMinutes(2))
                .kind();
    }
}
