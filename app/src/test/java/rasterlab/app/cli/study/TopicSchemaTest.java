package rasterlab.app.cli.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Ran;
import rasterlab.app.golden.GoldenFile;
import rasterlab.engine.Topics;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.json.StrictJson;

/** Holds the schema of every topic to what {@code ./lab run} reads and answers. */
class TopicSchemaTest {
    /** How readers that read a value first and refuse it then say what is allowed. */
    private static final List<String> RANGES =
            List.of(
                    "must be from ",
                    "must be a vertex from ",
                    "must be above ",
                    "must be a number above ",
                    "must be finite and not negative",
                    "must have shares from ");

    static Stream<Topic<?, ?, ?>> topics() {
        return Topics.all().stream();
    }

    @ParameterizedTest
    @MethodSource("topics")
    void isASchemaOfDraft202012(Topic<?, ?, ?> topic) {
        JsonNode schema = TopicSchemas.of(topic.name()).text();
        assertEquals(
                "https://json-schema.org/draft/2020-12/schema", schema.path("$schema").asText());
        assertEquals(List.of(), TopicSchemas.ofSchemas().validate(schema));
    }

    @ParameterizedTest
    @MethodSource("topics")
    void fitsInputsThatAreReadAndTheirAnswers(Topic<?, ?, ?> topic) throws IOException {
        TopicSchemas schemas = TopicSchemas.of(topic.name());
        int answered = 0;
        for (String input : GoldenFile.inputs(topic.name()))
            for (Method<?> method : topic.methods())
                for (boolean steps : List.of(false, true)) {
                    Optional<String> answer = answer(topic, method, input, steps);
                    if (answer.isEmpty()) continue;
                    answered++;
                    assertEquals(
                            List.of(), schemas.input().validate(TopicSchemas.tree(input)), input);
                    assertEquals(
                            List.of(),
                            schemas.output().validate(TopicSchemas.tree(answer.get())),
                            method.name() + " answers to " + input);
                }
        assertTrue(answered > 0, topic.name());
    }

    private static Optional<String> answer(
            Topic<?, ?, ?> topic, Method<?> method, String input, boolean steps) {
        var arguments = new ArrayList<>(List.of("run", topic.name(), method.name()));
        if (steps) arguments.add("--steps");
        Ran ran = Ran.labReading(input, arguments.toArray(String[]::new));
        return ran.exitCode() == 0 ? Optional.of(ran.out()) : Optional.empty();
    }

    /** The schema refuses all that a reader refuses by the form alone, and nothing that is read. */
    @ParameterizedTest
    @MethodSource("topics")
    void refusesWhatTheReaderRefuses(Topic<?, ?, ?> topic) throws IOException {
        TopicSchemas schemas = TopicSchemas.of(topic.name());
        int refused = 0;
        for (String input : GoldenFile.inputs(topic.name()))
            for (Spoilt spoilt : Spoilt.all(TopicSchemas.tree(input))) {
                boolean fits = schemas.input().validate(spoilt.value()).isEmpty();
                Optional<String> refusal = refusal(topic.format(), spoilt.value());
                String what = spoilt.how() + " in " + input + ": " + refusal;
                if (refusal.isPresent() && ofTheForm(refusal.get())) {
                    assertTrue(!fits, what);
                    refused++;
                }
                if (refusal.isEmpty()) assertTrue(fits, what);
            }
        assertTrue(refused > 20, topic.name() + ": only " + refused + " were refused");
    }

    /** Whether the refusal compares no field with another, and depends on no method. */
    private static boolean ofTheForm(String refusal) {
        return (Stream.of("expected ", "missing", "unknown field", "only ", "more than ")
                                .anyMatch(refusal::startsWith)
                        || RANGES.stream().anyMatch(refusal::contains))
                && Stream.of(" as /", "to needs it").noneMatch(refusal::contains)
                && !refusal.matches(".* vertex\\b.* got \\d+")
                && !refusal.equals("expected [xmin,ymin,xmax,ymax]");
    }

    private static Optional<String> refusal(Format<?, ?, ?> format, JsonNode input) {
        byte[] text = input.toString().getBytes(StandardCharsets.UTF_8);
        try {
            Given given = StrictJson.read(text, text.length, format.input(), format.open());
            format.read(given);
            return Optional.empty();
        } catch (InvalidInput e) {
            return Optional.of(e.reason());
        } catch (IllegalArgumentException e) {
            return Optional.of(e.getMessage());
        }
    }

    /** The unit is found by the place of a field in the schema of an input, and of an answer. */
    @ParameterizedTest
    @CsvSource({
        "rotate, input, /degrees, in degrees",
        "view, input, /phi, in degrees",
        "shade, input, /light/properties/spot/properties/cutoff, in degrees",
        "line-plane, output, /angle, in degrees",
        "line, input, /from, in pixels",
        "curve, input, /flatness, in pixels",
        "view, input, /rho, ''",
        "rotate, input, /times, ''"
    })
    void tellsTheUnitOfNumbersThatHaveOne(
            String topic, String of, String field, String description) {
        JsonNode properties =
                TopicSchemas.of(topic).text().at("/$defs/" + of + "/properties" + field);
        assertTrue(properties.isObject(), field);
        assertEquals(description, properties.path("description").asText());
    }

    @Test
    void isOfOneTopic() {
        Ran.lab("methods", "--schema")
                .assertComplains(2, "./lab methods: --schema needs TOPIC; see `./lab methods`");
        Ran unknown = Ran.lab("methods", "cricle", "--schema");
        assertTrue(
                unknown.err().startsWith("./lab methods: no topic 'cricle'; there are "),
                unknown.err());
    }
}
