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
 * Makes of an input as JSON smaller ones, the boldest first: all numbers are rounded to whole ones;
 * arrays lose half of their members or one; all numbers, and then each, are halved or brought
 * nearer to 0. What is no input of the topic is among them.
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

    /** Rounds, and halves: of {@link #STEPS}. */
    private static final int ROUNDS = 1;

    private static final int HALVES = 2;

    /**
     * An input, and where to go on from it.
     *
     * @param settled whether no array can lose members: none could before a number changed
     * @param from which of its numbers is changed first
     */
    public record SmallerInput(JsonNode json, boolean settled, int from) {
        /** One that was not made smaller yet. */
        public static SmallerInput first(JsonNode json) {
            return new SmallerInput(json, false, 0);
        }
    }

    private final SmallerInput start;
    private final JsonNode root;
    private final List<JsonPointer> arrays = new ArrayList<>();
    private final List<JsonPointer> numbers = new ArrayList<>();

    private SmallerInputs(SmallerInput start) {
        this.start = start;
        this.root = start.json();
        visit(JsonPointer.empty(), root);
    }

    /** Makes smaller inputs when they are asked for. */
    public static Stream<SmallerInput> of(SmallerInput start) {
        return new SmallerInputs(start).all();
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

    private Stream<SmallerInput> all() {
        Stream<Supplier<SmallerInput>> rounded =
                Stream.of(
                        () ->
                                new SmallerInput(
                                        each(numbers, STEPS.get(ROUNDS)), start.settled(), 0));
        Stream<Supplier<SmallerInput>> fewer =
                start.settled()
                        ? Stream.of()
                        : arrays.stream()
                                .flatMap(array -> withoutSome(array, root.at(array).size()));
        Stream<Supplier<SmallerInput>> halved =
                Stream.of(() -> new SmallerInput(each(numbers, STEPS.get(HALVES)), true, 0));
        return Stream.of(rounded, fewer, halved, nearer())
                .flatMap(some -> some)
                .map(Supplier::get)
                .filter(one -> !one.json().equals(root));
    }

    /** One number changed, from where it went on last and round. */
    private Stream<Supplier<SmallerInput>> nearer() {
        return IntStream.range(0, numbers.size())
                .map(i -> (i + start.from()) % numbers.size())
                .boxed()
                .flatMap(
                        i ->
                                STEPS.stream()
                                        .map(
                                                step ->
                                                        () ->
                                                                new SmallerInput(
                                                                        each(
                                                                                List.of(
                                                                                        numbers.get(
                                                                                                i)),
                                                                                step),
                                                                        true,
                                                                        i)));
    }

    private Stream<Supplier<SmallerInput>> withoutSome(JsonPointer array, int size) {
        int half = size / 2;
        Stream<Supplier<SmallerInput>> halves =
                half < 2
                        ? Stream.of()
                        : Stream.of(
                                () -> without(array, half, size), () -> without(array, 0, half));
        Stream<Supplier<SmallerInput>> single =
                IntStream.range(0, size).mapToObj(i -> () -> without(array, i, i + 1));
        return Stream.concat(halves, single);
    }

    private SmallerInput without(JsonPointer array, int from, int to) {
        JsonNode copy = root.deepCopy();
        ArrayNode left = (ArrayNode) copy.at(array);
        for (int i = to - 1; i >= from; i--) left.remove(i);
        return SmallerInput.first(copy);
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
