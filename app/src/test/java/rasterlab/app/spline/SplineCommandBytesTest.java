package rasterlab.app.spline;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.GoldenCommands;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.spline.curve.Sampling;
import rasterlab.contract.SplineEnds;
import rasterlab.engine.spline.curve.CurveTopic;
import rasterlab.engine.spline.function.SplineFunctionTopic;

class SplineCommandBytesTest {
    private static void fail(Throwable failure) {
        throw new AssertionError(failure);
    }

    @Test
    @DisplayName("the copied commands of curves have changed")
    void curvesCommandsStayAsTheyWere() throws IOException {
        var commands = new ArrayList<String>();
        try (var model = new CurveLabModel(new ModelThread(), SplineCommandBytesTest::fail)) {
            for (CurveForm form : CurveForm.values()) {
                model.chooseForm(form);
                commands.add(form + ": " + CurveCommand.of(model.state().choice()));
            }
            model.move(1, -0.0, 1e-9);
            model.sample(Sampling.flat(0.3));
            commands.add("flat: " + CurveCommand.of(model.state().choice()));
            model.sample(Sampling.equal(7));
            commands.add("equal: " + CurveCommand.of(model.state().choice()));
            for (var hazard : new CurveTopic().hazards()) {
                model.show(hazard.input());
                commands.add(hazard.name() + ": " + CurveCommand.of(model.state().choice()));
            }
        }
        GoldenCommands.assertKept("curve", lines(commands));
    }

    @Test
    @DisplayName("the copied commands of functions have changed")
    void functionsCommandsStayAsTheyWere() throws IOException {
        var commands = new ArrayList<String>();
        var thread = new ModelThread();
        try (var model = new FunctionLabModel(thread, SplineCommandBytesTest::fail)) {
            thread.settle(model::settle);
            commands.add("first: " + FunctionCommand.of(model.state()));
            for (SplineEnds ends :
                    List.of(
                            SplineEnds.slopes(-0.0, 1 / 3.0),
                            SplineEnds.natural(),
                            SplineEnds.notAKnot())) {
                model.chooseEnds(ends);
                thread.settle(model::settle);
                commands.add(ends.kind() + ": " + FunctionCommand.of(model.state()));
            }
            for (var hazard : new SplineFunctionTopic().hazards()) {
                model.show(hazard.input());
                thread.settle(model::settle);
                commands.add(hazard.name() + ": " + FunctionCommand.of(model.state()));
            }
        }
        GoldenCommands.assertKept("spline-function", lines(commands));
    }

    private static List<String> lines(List<String> commands) {
        return commands.stream().flatMap(String::lines).toList();
    }
}
