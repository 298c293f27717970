package rasterlab.app.spline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.cli.Lab;
import rasterlab.app.spline.curve.Sampling;
import rasterlab.contract.SplineEnds;

/** The copied command computes the very numbers that the lab shows. */
@Timeout(300)
class SplineCommandTest {
    static Stream<Arguments> curves() {
        return Stream.of(
                curve("kind is lost", model -> model.chooseForm(CurveForm.CATMULL_ROM)),
                curve("derivatives are lost", model -> model.chooseForm(CurveForm.HERMITE)),
                curve("all pieces but one are lost", model -> model.chooseForm(CurveForm.PIECES)),
                curve("flatness is lost", model -> model.sample(Sampling.flat(0.3))),
                curve("equal steps are lost", model -> model.sample(Sampling.equal(7))),
                curve("method is lost", model -> model.chooseMethod("uniform")),
                curve("digits are lost", model -> model.move(1, 1 / 3.0, -2e-7)));
    }

    private static Arguments curve(String mistake, Consumer<CurveLabModel> change) {
        return argumentSet(mistake, change);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("curves")
    void curvesCommandSendsTheSamePoints(Consumer<CurveLabModel> change) throws IOException {
        var thread = new ModelThread();
        try (var model =
                new CurveLabModel(
                        thread,
                        e -> {
                            throw new AssertionError(e);
                        })) {
            change.accept(model);
            thread.settle(model::settle);
            var points = new ArrayList<List<Double>>();
            for (String line : CurveCommand.of(model.state().choice()).split("\n"))
                for (JsonNode point : answer(line).path("points")) {
                    var next = List.of(point.path(0).asDouble(), point.path(1).asDouble());
                    boolean joint = !points.isEmpty() && points.get(points.size() - 1).equals(next);
                    if (!joint) points.add(next);
                }
            assertEquals(
                    model.state().drawing().points().stream()
                            .map(corner -> List.of(corner.x(), corner.y()))
                            .toList(),
                    points);
        }
    }

    static Stream<Arguments> functions() {
        return Stream.of(
                function("method is lost", model -> model.chooseMethod("monotone")),
                function("ends are lost", model -> model.chooseEnds(SplineEnds.notAKnot())),
                function("slopes are lost", model -> model.chooseEnds(SplineEnds.slopes(1, -2.5))),
                function("place is lost", model -> model.readAt(0.1)),
                function("digits are lost", model -> model.move(1, 1 / 3.0, -2e-7)));
    }

    private static Arguments function(String mistake, Consumer<FunctionLabModel> change) {
        return argumentSet(mistake, change);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("functions")
    void functionsCommandFindsTheSameCoefficients(Consumer<FunctionLabModel> change)
            throws IOException {
        var thread = new ModelThread();
        try (var model =
                new FunctionLabModel(
                        thread,
                        e -> {
                            throw new AssertionError(e);
                        })) {
            change.accept(model);
            thread.settle(model::settle);
            JsonNode answer = answer(FunctionCommand.of(model.state()));
            double[] first = model.state().drawing().coefficients().get(1);
            for (int i = 0; i < 4; i++)
                assertEquals(first[i], answer.path("coefficients").path(1).path(i).asDouble());
            assertEquals(
                    model.state().at().orElseThrow().y(),
                    answer.path("y").path(0).asDouble(),
                    1e-12);
        }
    }

    /** The output of {@code echo 'JSON' | ./lab run TOPIC METHOD}. */
    private static JsonNode answer(String command) throws IOException {
        assertTrue(command.startsWith("echo '"), command);
        int end = command.indexOf("' | ./lab ");
        String json = command.substring("echo '".length(), end);
        String[] words = command.substring(end + "' | ./lab ".length()).split(" ");
        var out = new ByteArrayOutputStream();
        var err = new ByteArrayOutputStream();
        int exitCode =
                Lab.run(
                        words,
                        new ByteArrayInputStream(json.getBytes(StandardCharsets.UTF_8)),
                        new PrintStream(out),
                        new PrintStream(err));
        assertEquals(0, exitCode, err.toString(StandardCharsets.UTF_8));
        return new ObjectMapper().readTree(out.toString(StandardCharsets.UTF_8));
    }
}
