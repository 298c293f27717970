package rasterlab.exercises.property;

import com.fasterxml.jackson.core.JsonPointer;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.DoubleNode;
import com.fasterxml.jackson.databind.node.LongNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Makes of an input as JSON smaller ones, the boldest first: arrays lose half of their members or
 * one; all numbers, and then each, are rounded to whole ones, halved, or brought nearer to 0. What
 * is no input of the topic is among them.
 *
 * <p>However often it is done, it ends: each has fewer members, or numbers that are nearer to 0 or
 * whole where they were not.
 */
public final class SmallerInputs {
    private static final List<DoubleUnaryOperator> STEPS =
            List.of(
                    value -> 0,
                    SmallerInputs::rounded,
                    value -> rounded(value / 2),
                    value -> value == Math.rint(value) ? value - Math.signum(value) : value);

    private final JsonNode root;
    private final List<JsonPointer> arrays = new ArrayList<>();
    private final List<JsonPointer> numbers = new ArrayList<>();

    private SmallerInputs(JsonNode root) {
        this.root = root;
        visit(JsonPointer.empty(), root);
    }

    /** Made when they are asked for. */
    public static Stream<JsonNode> of(JsonNode input) {
        return new SmallerInputs(input).all();
    }

    private void visit(JsonPointer at, JsonNode node) {
        if (node.isNumber()) numbers.add(at);
        if (node.isObject())
            node.properties()
                    .forEach(one -> visit(at.appendProperty(one.getKey()), one.getValue()));
        if (!node.isArray()) return;
        arrays.add(at);
        for (int i = 0; i < node.size(); i++) visit(at.appendIndex(i), node.get(i));
    }

    private Stream<JsonNode> all() {
        Stream<Supplier<JsonNode>> fewer =
                arrays.stream().flatMap(array -> withoutSome(array, root.at(array).size()));
        Stream<Supplier<JsonNode>> rounded = Stream.of(() -> each(numbers, STEPS.get(1)));
        Stream<Supplier<JsonNode>> halved = Stream.of(() -> each(numbers, STEPS.get(2)));
        Stream<Supplier<JsonNode>> nearer =
                numbers.stream()
                        .flatMap(
                                number ->
                                        STEPS.stream()
                                                .map(step -> () -> each(List.of(number), step)));
        return Stream.of(fewer, rounded, halved, nearer)
                .flatMap(some -> some)
                .map(Supplier::get)
                .filter(one -> !one.equals(root));
    }

    private Stream<Supplier<JsonNode>> withoutSome(JsonPointer array, int size) {
        int half = size / 2;
        Stream<Supplier<JsonNode>> halves =
                half < 2
                        ? Stream.of()
                        : Stream.of(
                                () -> without(array, half, size), () -> without(array, 0, half));
        Stream<Supplier<JsonNode>> single =
                IntStream.range(0, size).mapToObj(i -> () -> without(array, i, i + 1));
        return Stream.concat(halves, single);
    }

    private JsonNode without(JsonPointer array, int from, int to) {
        JsonNode copy = root.deepCopy();
        ArrayNode left = (ArrayNode) copy.at(array);
        for (int i = to - 1; i >= from; i--) left.remove(i);
        return copy;
    }

    private JsonNode each(List<JsonPointer> chosen, DoubleUnaryOperator step) {
        JsonNode copy = root.deepCopy();
        for (JsonPointer at : chosen) {
            JsonNode holder = copy.at(at.head());
            JsonNode value = number(step.applyAsDouble(copy.at(at).doubleValue()), copy.at(at));
            if (holder instanceof ArrayNode array) array.set(at.last().getMatchingIndex(), value);
            else ((ObjectNode) holder).set(at.last().getMatchingProperty(), value);
        }
        return copy;
    }

    private static JsonNode number(double value, JsonNode before) {
        if (value == before.doubleValue()) return before;
        boolean whole = value == Math.rint(value) && Math.abs(value) < 1e15;
        return whole ? new LongNode((long) value) : new DoubleNode(value);
    }

    /** The whole number next to it towards 0; of one below 1, the nearest half. */
    private static double rounded(double value) {
        double whole = value < 0 ? Math.ceil(value) : Math.floor(value);
        return whole == 0 ? Math.rint(2 * value) / 2 : whole;
    }
}
