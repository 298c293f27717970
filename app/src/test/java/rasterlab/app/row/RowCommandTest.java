package rasterlab.app.row;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.coordinates.CommandOutput;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.texture.filter.FilterTopic;
import rasterlab.engine.texture.mapping.MappingTopic;
import rasterlab.engine.transform.Images;
import rasterlab.engine.visibility.depth.DepthBufferTopic;
import rasterlab.engine.visibility.depth.StoredDepths;

/** The copied command answers to the row that the lab shows, by its method. */
@Tag("slow")
@Timeout(300)
class RowCommandTest {
    static Stream<Arguments> cells() {
        return Stream.of(new DepthBufferTopic(), new MappingTopic(), new FilterTopic())
                .flatMap(RowCommandTest::cells);
    }

    private static Stream<Arguments> cells(Topic<?, ?, ?> topic) {
        return topic.hazards().stream()
                .flatMap(
                        hazard ->
                                topic.methods().stream()
                                        .filter(method -> answers(hazard, method))
                                        .map(
                                                method ->
                                                        argumentSet(
                                                                topic.name()
                                                                        + " "
                                                                        + hazard.name()
                                                                        + " "
                                                                        + method.name(),
                                                                topic,
                                                                hazard,
                                                                method)));
    }

    private static boolean answers(Hazard<?> hazard, Method<?> method) {
        return hazard.recorded().get(method.name()) != Verdict.Kind.REFUSED;
    }

    @ParameterizedTest(name = "the command has another row or method: {argumentSetName}")
    @MethodSource("cells")
    <C, I, O> void commandAnswersAsTheMethod(
            Topic<C, I, O> topic, Hazard<I> hazard, Method<C> method) throws IOException {
        RowLabModel model =
                topic instanceof DepthBufferTopic
                        ? RowLabModel.ofDepths(
                                new OwnMethods(), Runnable::run, RowCommandTest::fail)
                        : RowLabModel.ofTextures(
                                new OwnMethods(), Runnable::run, RowCommandTest::fail);
        model.show(topic.name(), hazard.name(), method.name());
        String command = model.command();
        model.end();
        String end = "./lab run " + topic.name() + " " + method.name();
        assertTrue(command.endsWith(end), command);
        JsonNode answer = CommandOutput.of(command);
        double[] right = numbers(topic.record(method.implementation(), hazard.input(), 1 << 20));
        assertEquals(
                DoubleStream.of(right).boxed().toList(),
                found(answer).boxed().toList(),
                hazard.name() + " " + method.name());
    }

    private static void fail(Throwable failure) {
        throw new AssertionError(failure);
    }

    private static DoubleStream found(JsonNode answer) {
        if (answer.has("codes")) return numbers(answer.get("codes"));
        if (answer.has("levels")) return numbers(answer.get("levels"));
        return IntStream.range(0, answer.get("coordinates").size())
                .boxed()
                .flatMapToDouble(i -> numbers(answer.get("coordinates").get(i)));
    }

    private static DoubleStream numbers(JsonNode list) {
        return IntStream.range(0, list.size()).mapToDouble(i -> list.get(i).asDouble());
    }

    /** Codes, coordinates, or the red of each colour. */
    private static double[] numbers(Object output) {
        if (output instanceof StoredDepths stored)
            return IntStream.of(stored.codes()).asDoubleStream().toArray();
        if (output instanceof Images images) return images.coordinates();
        var levels = (double[]) output;
        return IntStream.range(0, levels.length / 4).mapToDouble(i -> levels[4 * i + 1]).toArray();
    }
}
