package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.language.Language;
import rasterlab.contract.SplineEnds;
import rasterlab.engine.spline.function.SplineFunctionTopic;
import rasterlab.engine.spline.function.SplineProblem;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.axis.AxisTopic;
import rasterlab.engine.transform.axis.AxisTurn;
import rasterlab.engine.transform.chain.Chain;
import rasterlab.engine.transform.chain.TransformTopic;
import rasterlab.engine.transform.rotate.RotateTopic;
import rasterlab.engine.transform.rotate.Turns;
import rasterlab.engine.transform.view.ViewTask;
import rasterlab.engine.transform.view.ViewTopic;

/** Compares what students read about a method's cost with the counters. */
class SaidCostTest {
    private static final double[] AXIS = {1, 2, 2};

    static Stream<Arguments> growth() {
        return Stream.of(
                        of(
                                new AxisTopic(),
                                new AxisTurn(AXIS, AXIS, 37, new double[3]),
                                new AxisTurn(AXIS, AXIS, 37, new double[6]),
                                "point"),
                        of(
                                new ViewTopic(),
                                new ViewTask(20, 70, 400, new double[3]),
                                new ViewTask(20, 70, 400, new double[6]),
                                "point"),
                        of(
                                new RotateTopic(),
                                new Turns(37, 5, new double[2]),
                                new Turns(37, 6, new double[2]),
                                "(further )?turn"),
                        of(
                                new TransformTopic(),
                                new Chain(3, new double[][] {new double[16]}, new double[3]),
                                new Chain(3, new double[][] {new double[16]}, new double[6]),
                                "(matrix and )?point"),
                        of(
                                new TransformTopic(),
                                new Chain(3, new double[1][16], new double[3]),
                                new Chain(3, new double[2][16], new double[3]),
                                "matrix"))
                .flatMap(cases -> cases);
    }

    /** One more of {@code unit} from {@code small} to {@code large}, by every method. */
    private static <C, I> Stream<Arguments> of(
            Topic<C, I, ?> topic, I small, I large, String unit) {
        return topic.methods().stream()
                .map(
                        method ->
                                arguments(
                                        topic.name() + " " + method.name(),
                                        cost(topic, method),
                                        difference(topic, method, small, large),
                                        unit));
    }

    private static String cost(Topic<?, ?, ?> topic, Method<?> method) {
        return TopicTexts.of(topic.name(), Language.ENGLISH).about(method, "cost");
    }

    private static <C, I> Map<String, Long> difference(
            Topic<C, I, ?> topic, Method<C> method, I small, I large) {
        var counts = new TreeMap<String, Long>();
        topic.operations(method.implementation(), large)
                .forEach((kind, number) -> counts.put(kind.replace("double-double-", ""), number));
        topic.operations(method.implementation(), small)
                .forEach(
                        (kind, number) ->
                                counts.merge(
                                        kind.replace("double-double-", ""), -number, Long::sum));
        counts.values().removeIf(number -> number == 0);
        return counts;
    }

    @ParameterizedTest(name = "{0} is said to cost what it does not")
    @MethodSource("growth")
    void aboutSaysWhatTheCounterCounts(
            String method, String cost, Map<String, Long> counted, String unit) {
        assertTrue(cost.matches(".*\\d.*"), cost);
        if (counted.isEmpty()) {
            assertTrue(cost.contains("however many"), cost);
            return;
        }
        for (var kind : counted.entrySet()) {
            var sentence =
                    Pattern.compile(
                            "\\b"
                                    + kind.getValue()
                                    + " "
                                    + kind.getKey()
                                    + "\\b[^;:]* per "
                                    + unit);
            assertTrue(sentence.matcher(cost).find(), counted + " where is said: " + cost);
        }
    }

    /** "Two steps per knot" and "one step per piece", as the methods say of themselves. */
    @ParameterizedTest(name = "{0} is said to take other steps than it does")
    @CsvSource({"cubic, 2, two steps per knot", "monotone, 1, one step per piece"})
    void aboutSaysWhatTheWalkCounts(String name, long steps, String said) {
        var topic = new SplineFunctionTopic();
        String cost = cost(topic, topic.method(name));
        assertTrue(cost.startsWith(said), cost);
        assertEquals(steps * 50, steps(topic, name, 150) - steps(topic, name, 100));
    }

    private static long steps(SplineFunctionTopic topic, String name, int knots) {
        double[] x = IntStream.range(0, knots).mapToDouble(i -> i).toArray();
        var problem = new SplineProblem(x, x, SplineEnds.natural(), new double[] {0}, false);
        return topic.operations(topic.method(name).implementation(), problem).get("steps");
    }
}
