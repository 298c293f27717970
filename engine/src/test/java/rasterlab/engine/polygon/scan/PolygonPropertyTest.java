package rasterlab.engine.polygon.scan;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tuple;
import net.jqwik.api.constraints.IntRange;
import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;

/**
 * Checks properties of every right filling on polygons that shrink to the smallest counterexample.
 */
class PolygonPropertyTest {
    private static final int SIDE = 24;
    private static final List<PolygonFiller> RIGHT =
            List.of(new ScanlinePolygon(), new EdgeFunctionPolygon());

    private record Span(int y, int from, int to) {}

    /**
     * Coordinates on centres, halfway between them, anywhere, an ulp beside a centre, and far away.
     */
    @Provide
    Arbitrary<Double> coordinates() {
        Arbitrary<Integer> whole = Arbitraries.integers().between(-4, SIDE + 4);
        return Arbitraries.frequencyOf(
                Tuple.of(4, whole.map(v -> (double) v)),
                Tuple.of(2, whole.map(v -> v / 2.0)),
                Tuple.of(2, whole.map(v -> Math.nextUp((double) v))),
                Tuple.of(4, Arbitraries.doubles().between(-9, SIDE + 9.0)),
                Tuple.of(1, Arbitraries.doubles().between(-1e100, 1e100)));
    }

    @Provide
    Arbitrary<double[]> polygons() {
        return coordinates()
                .array(double[].class)
                .ofMinSize(0)
                .ofMaxSize(18)
                .map(numbers -> Arrays.copyOf(numbers, numbers.length & ~1));
    }

    @Property(tries = 2000)
    void anyPolygonIsExact(@ForAll("polygons") double[] corners, @ForAll FillRule rule) {
        PolygonTask task = PolygonTask.of(rule, SIDE, SIDE, corners);
        var expected = new ArrayList<Span>();
        new ExactFill(task).fill((y, from, to) -> expected.add(new Span(y, from, to)));
        for (PolygonFiller method : RIGHT)
            assertEquals(expected, spans(method, task), method.getClass().getSimpleName());
    }

    /** Triangles about a hub cover the polygon that winds round it, each pixel of it once. */
    @Property(tries = 1000)
    void sharedEdgesAreCoveredOnce(
            @ForAll("coordinates") double hubX,
            @ForAll("coordinates") double hubY,
            @ForAll @IntRange(min = 3, max = 12) int corners,
            @ForAll long seed,
            @ForAll @IntRange(max = 1) int which) {
        double x = hubX % 50;
        double y = hubY % 50;
        double[] star = star(x, y, corners, new Random(seed));
        var expected = new int[SIDE][SIDE];
        var sum = new int[SIDE][SIDE];
        addCover(PolygonTask.of(FillRule.NON_ZERO, SIDE, SIDE, star), RIGHT.get(which), expected);
        for (int i = 0; i < star.length; i += 2) {
            int j = (i + 2) % star.length;
            double[] triangle = {x, y, star[i], star[i + 1], star[j], star[j + 1]};
            Assume.that(turn(triangle) > 0);
            addCover(
                    PolygonTask.of(FillRule.NON_ZERO, SIDE, SIDE, triangle), RIGHT.get(which), sum);
        }
        assertEquals(Arrays.deepToString(expected), Arrays.deepToString(sum));
    }

    /** Corners at random distances and increasing angles; so far apart that rounding turns none. */
    private static double[] star(double x, double y, int corners, Random random) {
        var star = new double[2 * corners];
        for (int i = 0; i < corners; i++) {
            double distance = 1 + 20 * random.nextDouble();
            star[2 * i] = x + distance * StrictMath.cos(2 * Math.PI * i / corners);
            star[2 * i + 1] = y + distance * StrictMath.sin(2 * Math.PI * i / corners);
        }
        return star;
    }

    /** The sign of the area of a triangle x0, y0, x1, y1, x2, y2. */
    private static int turn(double[] c) {
        var p = Arrays.stream(c).mapToObj(BigDecimal::new).toArray(BigDecimal[]::new);
        BigDecimal a = p[2].subtract(p[0]).multiply(p[5].subtract(p[1]));
        return a.compareTo(p[3].subtract(p[1]).multiply(p[4].subtract(p[0])));
    }

    private static void addCover(PolygonTask task, PolygonFiller method, int[][] times) {
        for (Span span : spans(method, task))
            for (int x = span.from; x < span.to; x++) times[span.y][x]++;
    }

    @Property(tries = 500)
    void aPolygonMovedByWholePixelsIsTheSamePolygonMoved(
            @ForAll("polygons") double[] corners,
            @ForAll FillRule rule,
            @ForAll @IntRange(max = 40) int byX,
            @ForAll @IntRange(max = 40) int byY) {
        // Sixteenths keep every sum exact.
        double[] here = Arrays.stream(corners).map(PolygonPropertyTest::sixteenths).toArray();
        var there = here.clone();
        for (int i = 0; i + 1 < here.length; i += 2) {
            there[i] += byX;
            there[i + 1] += byY;
        }
        for (PolygonFiller method : RIGHT) {
            var moved = new ArrayList<Span>();
            for (Span s : spans(method, PolygonTask.of(rule, 200, 200, here)))
                moved.add(new Span(s.y + byY, s.from + byX, s.to + byX));
            var cut = spans(method, PolygonTask.of(rule, 200 + byX, 200 + byY, there));
            assertEquals(moved, cut);
        }
    }

    private static double sixteenths(double value) {
        return 40 + Math.rint(16 * (value % 32)) / 16;
    }

    @Property(tries = 500)
    void bothRulesAgreeOnPolygonsThatDoNotCrossThemselves(
            @ForAll("coordinates") double middleX,
            @ForAll("coordinates") double middleY,
            @ForAll @IntRange(min = 3, max = 30) int corners,
            @ForAll long seed) {
        double[] star = star(middleX % 50, middleY % 50, corners, new Random(seed));
        for (PolygonFiller method : RIGHT)
            assertEquals(
                    spans(method, PolygonTask.of(FillRule.EVEN_ODD, SIDE, SIDE, star)),
                    spans(method, PolygonTask.of(FillRule.NON_ZERO, SIDE, SIDE, star)));
    }

    private static List<Span> spans(PolygonFiller method, PolygonTask task) {
        var spans = new ArrayList<Span>();
        method.fill(
                task.x(),
                task.y(),
                task.rule(),
                task.width(),
                task.height(),
                (y, from, to) -> spans.add(new Span(y, from, to)));
        return spans;
    }
}
