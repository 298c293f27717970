package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Ran;
import rasterlab.app.cli.study.TopicSchemas;
import rasterlab.app.golden.GoldenFile;
import rasterlab.engine.Topics;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.line.CoverageLine;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.json.StrictJson;

/**
 * Holds what a format writes of the output that a topic judges to what {@code ./lab run} says. Of a
 * line with coverage that is more pixels than are judged.
 */
class WrittenOutputsTest {
    static Stream<Topic<?, ?, ?>> topics() {
        return Topics.all().stream();
    }

    @ParameterizedTest
    @MethodSource("topics")
    void theOutputThatIsJudgedIsPartOfTheAnswer(Topic<?, ?, ?> topic) throws IOException {
        assertTrue(compared(topic) > 0, topic.name());
    }

    private static <C, I, O> int compared(Topic<C, I, O> topic) throws IOException {
        int compared = 0;
        for (String json : GoldenFile.inputs(topic.name()))
            for (Method<C> method : topic.methods()) {
                Ran ran = Ran.labReading(json, "run", topic.name(), method.name());
                if (ran.exitCode() != 0 || !isRead(topic.format(), json)) continue;
                if (method.implementation() instanceof CoverageLine) continue;
                I input = read(topic.format(), json);
                O output = topic.record(method.implementation(), input, Integer.MAX_VALUE);
                JsonNode written = written(topic.format(), input, output);
                JsonNode answer = TopicSchemas.tree(ran.out());
                assertTrue(!written.isEmpty(), topic.name());
                written.properties()
                        .forEach(
                                field ->
                                        assertEquals(
                                                answer.get(field.getKey()),
                                                field.getValue(),
                                                field.getKey()
                                                        + " of "
                                                        + method.name()
                                                        + " for "
                                                        + json));
                compared++;
            }
        return compared;
    }

    /** The corners of a window go to one method alone, past the topic. */
    private static boolean isRead(Format<?, ?, ?> format, String json) {
        try {
            read(format, json);
            return true;
        } catch (InvalidInput e) {
            return false;
        }
    }

    private static <I> I read(Format<?, I, ?> format, String json) {
        byte[] text = json.getBytes(StandardCharsets.UTF_8);
        return format.read(StrictJson.read(text, text.length, format.input(), format.open()));
    }

    private static <I, O> JsonNode written(Format<?, I, O> format, I input, O output)
            throws IOException {
        var bytes = new ByteArrayOutputStream();
        try (JsonGenerator json = new JsonFactory().createGenerator(bytes)) {
            json.writeStartObject();
            format.write(input, output, new ProgramJson(json));
            json.writeEndObject();
        }
        return TopicSchemas.tree(bytes.toString(StandardCharsets.UTF_8));
    }
}
