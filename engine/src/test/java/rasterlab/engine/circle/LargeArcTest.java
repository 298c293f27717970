package rasterlab.engine.circle;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.CircleRasterizer;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict.Kind;

/** Circles and ellipses of so many pixels that they are judged by a part, or nearly so. */
@Tag("slow")
class LargeArcTest {
    private static final CircleTopic CIRCLE = new CircleTopic();
    private static final EllipseTopic ELLIPSE = new EllipseTopic();

    static Stream<Circle> circles() {
        return Stream.of(
                new Circle(0, 0, 400_000),
                new Circle(-70, 12, 240_001),
                new Circle(3, 4, 5_000_000));
    }

    @ParameterizedTest
    @MethodSource("circles")
    void aCircleIsExactInAnyOrderButNotWithoutItsDiagonalOrOfAnotherRadius(Circle circle) {
        CircleRasterizer right = new MidpointCircle();
        CircleRasterizer mirrored =
                (x0, y0, r, out) ->
                        right.draw(x0, y0, r, (x, y) -> out.plot(2 * x0 - x, 2 * y0 - y));
        CircleRasterizer gap =
                (x0, y0, r, out) ->
                        right.draw(
                                x0,
                                y0,
                                r,
                                (x, y) -> {
                                    if (Math.abs(x - x0 - Math.round(r * Math.sqrt(0.5))) > 0)
                                        out.plot(x, y);
                                });
        CircleRasterizer small = (x0, y0, r, out) -> right.draw(x0, y0, r - 2, out);
        Function<CircleRasterizer, Kind> kind = kinds(CIRCLE, circle);
        assertEquals(Kind.EXACT, kind.apply(right));
        assertEquals(Kind.EXACT, kind.apply(mirrored), "in another order");
        assertEquals(Kind.DEGRADED, kind.apply(gap));
        assertEquals(Kind.WRONG, kind.apply(small));
    }

    @Test
    void aRightEllipseIsExactAndOneWithSwappedHalfAxesIsNot() {
        EllipseRasterizer right = new MidpointEllipse();
        EllipseRasterizer swapped = (x, y, a, b, out) -> right.draw(x, y, b, a, out);
        var ellipse = new Ellipse(7, -9, MidpointEllipse.LARGEST - 1, MidpointEllipse.LARGEST - 90);
        Function<EllipseRasterizer, Kind> kind = kinds(ELLIPSE, ellipse);
        assertEquals(Kind.EXACT, kind.apply(right));
        assertEquals(Kind.WRONG, kind.apply(swapped));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 70, 29_999, 30_001, 64_000})
    void thePartHasWhatTheWholeFigureHasThere(int b) {
        for (int a : new int[] {0, 5, 30_000, 90_001}) {
            var figure = new Ellipse(11, -13, a, b);
            var sample = new ArcSample(figure);
            PixelRecording whole = ELLIPSE.exact(figure, 4_000_000);
            PixelSet there = PixelSet.of(whole).filter(sample);
            PixelRecording part = sample.exact(4_000_000);
            assertEquals(there.size(), part.size(), "pixels of a = " + a + ", b = " + b);
            assertEquals(0, PixelSet.of(part).filter((x, y) -> !there.contains(x, y)).size());
        }
    }

    private static <C, I> Function<C, Kind> kinds(Topic<C, I, PixelRecording> topic, I input) {
        var trying = HazardTrial.trying(topic, input, Duration.ofMinutes(2));
        return method -> trying.apply(Method.failing("made-up", method)).verdict().kind();
    }
}
