package rasterlab.app.study;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.DateTimeException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyConditions;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.study.measuring.Machine;
import rasterlab.exercises.json.JsonText;
import rasterlab.exercises.json.NotJson;

/** Reads a study from the JSON that {@link StudyJson} writes. */
final class StudyReading {
    private StudyReading() {}

    /**
     * The study of that text, of the methods and workloads that the topic still has.
     *
     * @throws IllegalArgumentException if it is none of that topic; the message says what is
     *     missing or wrong
     */
    static Study of(String json, Topic<?, ?, ?> topic) throws NotJson {
        JsonNode root = JsonText.tree(json);
        String name = root.required("topic").asText();
        if (!name.equals(topic.name()))
            throw new IllegalArgumentException(
                    "it is a study of '" + name + "', not of '" + topic.name() + "'");
        var measurements = new ArrayList<Measurement>();
        for (JsonNode one : root.required("measurements")) {
            Measurement measured = measurement(one);
            if (isOf(topic, measured)) measurements.add(measured);
        }
        return new Study(
                name,
                root.required("item").asText(),
                root.required("errorUnit").asText(),
                measurements,
                root.has("date") ? Optional.of(circumstances(root)) : Optional.empty());
    }

    private static boolean isOf(Topic<?, ?, ?> topic, Measurement measured) {
        return topic.methods().stream().anyMatch(one -> one.name().equals(measured.method()))
                && topic.workloads().stream()
                        .anyMatch(one -> one.name().equals(measured.workload()));
    }

    private static StudyConditions circumstances(JsonNode root) {
        Map<String, List<Double>> fixed = new TreeMap<>();
        for (JsonNode one : root.required("noise"))
            fixed.put(one.required("workload").asText(), numbers(one.required("rounds")));
        try {
            return new StudyConditions(
                    settings(root.required("settings"), root.required("seed").asLong()),
                    Instant.parse(root.required("date").asText()),
                    machine(root.required("machine")),
                    number(root.required("load").required("before")),
                    number(root.required("load").required("after")),
                    fixed,
                    root.required("whole").asBoolean());
        } catch (DateTimeException e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        }
    }

    private static Machine machine(JsonNode node) {
        return new Machine(
                node.required("system").asText(),
                node.required("processor").asText(),
                node.required("cores").asInt(),
                node.required("heapBytes").asLong(),
                node.required("java").asText());
    }

    private static StudySettings settings(JsonNode node, long seed) {
        return new StudySettings(
                millis(node.required("warmUpMillis")),
                millis(node.required("roundMillis")),
                node.required("rounds").asInt(),
                millis(node.required("wallLimitMillis")),
                millis(node.required("budgetMillis")),
                seed);
    }

    private static Duration millis(JsonNode node) {
        return Duration.ofNanos(Math.round(1e6 * number(node)));
    }

    private static Measurement measurement(JsonNode node) {
        JsonNode error = node.required("error");
        return new Measurement(
                node.required("method").asText(),
                node.required("workload").asText(),
                node.required("size").asInt(),
                cost(node),
                new Deviation(
                        number(error.required("worst")),
                        error.required("missing").asInt(),
                        error.required("extra").asInt(),
                        error.required("of").asInt(),
                        error.required("first").asText()),
                verdict(node.required("verdict").asText()),
                node.required("detail").asText(),
                numbers(node.required("errors")));
    }

    private static Cost cost(JsonNode node) {
        JsonNode nanos = node.required("nanosPerItem");
        Map<String, Long> counts = new TreeMap<>();
        for (Map.Entry<String, JsonNode> one : node.required("counts").properties())
            counts.put(one.getKey(), one.getValue().asLong());
        if (nanos.isNull()) return Cost.of(List.of(), counts);
        return new Cost(
                number(nanos.required("median")),
                number(nanos.required("low")),
                number(nanos.required("high")),
                counts,
                numbers(node.required("rounds")));
    }

    private static Verdict.Kind verdict(String code) {
        return Arrays.stream(Verdict.Kind.values())
                .filter(one -> one.code().equals(code))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("no verdict '" + code + "'"));
    }

    private static List<Double> numbers(JsonNode array) {
        var numbers = new ArrayList<Double>();
        for (JsonNode one : array) numbers.add(number(one));
        return numbers;
    }

    /** A number; an endless one stands in quotes. */
    private static double number(JsonNode node) {
        return node.isTextual() ? Double.parseDouble(node.textValue()) : node.doubleValue();
    }
}
