package rasterlab.engine.circle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.CompiledCode;

/** Compares the counted arithmetic with the compiled walks. */
class ArcWorkTest {
    @ParameterizedTest(name = "{0} multiplies on its way although it counts no multiplication")
    @ValueSource(
            strings = {"BresenhamCircle", "MidpointCircle", "BresenhamEllipse", "MidpointEllipse"})
    void aCompiledWalkMultipliesOnlyAtItsStart(String type) {
        String walk = compiledWalk(type);
        for (String method :
                new String[] {
                    "advance", "choose", "stepAside", "stepDown", "nextColumn", "nextRow"
                }) assertEquals(0, multiplications(walk, method), type + "." + method);
    }

    @Test
    void aTextbookWalkMultiplies() {
        assertTrue(
                multiplications(compiledWalk("BresenhamTextbookEllipse"), "choose") > 0,
                "no multiplication is found in BresenhamTextbookEllipse.choose");
    }

    /** A quadrant of radius 4 goes 4 columns aside and 4 rows down. */
    @Test
    void choicesAndStepsAreCountedAsTheyHappen() {
        var topic = new CircleTopic();
        var bresenham = topic.method("bresenham").implementation();
        var pixels = new ArrayList<Integer>();
        ArcWalk walk = new BresenhamCircle().walk(4);
        while (walk.advance()) pixels.add(10 * walk.u() + walk.v());
        int choices = pixels.size() - 1;
        Map<String, Long> counts = topic.operations(bresenham, new Circle(9, 9, 4));
        assertEquals(2L * choices + 2 * 4 + 2 * 4, counts.get("additions"));
        assertEquals(2L * choices, counts.get("comparisons"));
        assertEquals(0, counts.get("multiplications"));
    }

    @Test
    void aParametricStepCostsTwoSines() {
        var topic = new EllipseTopic();
        var method = topic.method("parametric").implementation();
        Map<String, Long> counts = topic.operations(method, new Ellipse(0, 0, 100, 7));
        assertEquals(2 * 159, counts.get("sines and roots"));
        assertEquals(2 * 159, counts.get("multiplications"));
    }

    /** One of radii 3 and 4 ends the octant by a step past the diagonal, which is counted. */
    @ParameterizedTest(name = "the counts of {0} with radius {1} change")
    @CsvSource({
        "midpoint, 0, 'additions=2, comparisons=0, multiplications=0, sines and roots=0'",
        "midpoint, 1, 'additions=4, comparisons=1, multiplications=0, sines and roots=0'",
        "midpoint, 3, 'additions=8, comparisons=2, multiplications=0, sines and roots=0'",
        "midpoint, 4, 'additions=10, comparisons=3, multiplications=0, sines and roots=0'",
        "midpoint, 100, 'additions=202, comparisons=71, multiplications=0, sines and roots=0'",
        "bresenham, 0, 'additions=0, comparisons=0, multiplications=0, sines and roots=0'",
        "bresenham, 100, 'additions=682, comparisons=282, multiplications=0, sines and roots=0'",
        "bresenham-textbook, 4, 'additions=24, comparisons=9, multiplications=18, sines and roots=9'",
        "bresenham-textbook, 5, 'additions=32, comparisons=12, multiplications=24, sines and roots=12'",
        "parametric, 4, 'additions=0, comparisons=0, multiplications=10, sines and roots=10'",
    })
    void countsStayAsPublished(String method, int radius, String published) {
        var topic = new CircleTopic();
        var counts =
                new TreeMap<>(
                        topic.operations(
                                topic.method(method).implementation(), new Circle(9, 9, radius)));
        counts.keySet().removeAll(List.of("divisions", "roundings"));
        assertEquals("{" + published + "}", counts.toString());
    }

    private static long multiplications(String walk, String method) {
        var body =
                Pattern.compile("\\b" + method + "\\(\\);\\n    Code:(.*?)\\n\\n", Pattern.DOTALL)
                        .matcher(walk);
        return body.find()
                ? Pattern.compile(" [ilfd](mul|div|rem)\\b")
                        .matcher(body.group(1))
                        .results()
                        .count()
                : 0;
    }

    private static String compiledWalk(String type) {
        return CompiledCode.of(ArcWalk.class, "rasterlab.engine.circle." + type + "$Walk");
    }
}
