package rasterlab.exercises.judging;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.LongNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.Topics;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.format.Written;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.document.OwnJson;
import rasterlab.exercises.json.JsonSink;
import rasterlab.exercises.json.StrictJson;

/**
 * The steps that a method records on one input, as {@code ./lab run TOPIC METHOD --steps} answers
 * them; those of several things in one input stand one behind the other.
 *
 * @param steps an object each
 */
public record Walk(List<JsonNode> steps) {

    /** Whole numbers below are doubles. */
    private static final double MOST_WHOLE = 0x1p53;

    public Walk {
        steps = List.copyOf(steps);
    }

    /**
     * Runs the method.
     *
     * @param input a JSON object
     * @throws InvalidInput if it is no input of the topic, or the method has no steps
     * @throws IllegalArgumentException if the method refuses the input
     */
    public static Walk of(String topic, String method, String input) {
        List<JsonNode> steps = new ArrayList<>();
        each(topic, method, input).forEach(steps::addAll);
        return new Walk(steps);
    }

    /**
     * The steps for each of several things in one input; one list where they are not told apart.
     */
    static List<List<JsonNode>> each(String topic, String method, String input) {
        JsonNode answer = tree(answer(Topics.named(topic), method, input));
        List<List<JsonNode>> walks = new ArrayList<>();
        List<JsonNode> alone = new ArrayList<>();
        for (JsonNode one : answer.path("steps")) {
            if (!one.isArray()) alone.add(one);
            else {
                List<JsonNode> steps = new ArrayList<>();
                one.forEach(steps::add);
                walks.add(steps);
            }
        }
        return walks.isEmpty() ? List.of(alone) : walks;
    }

    private static <C, I, O> Written answer(Topic<C, I, O> topic, String method, String input) {
        Format<C, I, O> format = topic.format();
        var call = new Call<>(method, topic.method(method).implementation(), true);
        if (!format.hasSteps()) throw call.noSteps();
        byte[] text = input.getBytes(StandardCharsets.UTF_8);
        return format.prepared(
                        call, StrictJson.read(text, text.length, format.input(), format.open()))
                .get();
    }

    private static JsonNode tree(Written answer) {
        StringWriter text = new StringWriter();
        try (JsonGenerator json = OwnJson.MAPPER.createGenerator(text)) {
            json.writeStartObject();
            answer.write(new JsonSink(json));
            json.writeEndObject();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        try {
            return wholes(OwnJson.MAPPER.readTree(text.toString()));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** The document with whole numbers as such, 3 instead of 3.0. */
    private static JsonNode wholes(JsonNode node) {
        if (node.isObject()) {
            ObjectNode object = OwnJson.MAPPER.createObjectNode();
            node.properties().forEach(one -> object.set(one.getKey(), wholes(one.getValue())));
            return object;
        }
        if (node.isArray()) {
            ArrayNode array = OwnJson.MAPPER.createArrayNode();
            node.forEach(one -> array.add(wholes(one)));
            return array;
        }
        double value = node.doubleValue();
        return node.isDouble() && value == Math.rint(value) && Math.abs(value) < MOST_WHOLE
                ? new LongNode((long) value)
                : node;
    }
}
