package rasterlab.app.clip;

import java.io.IOException;
import java.util.ArrayList;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.canvas.GoldenCommands;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.clip.outcome.ClipTopics;
import rasterlab.app.clip.scene.ClipGrip;
import rasterlab.app.clip.scene.ClipMode;
import rasterlab.engine.study.Hazard;

class ClipCommandTest {
    @ParameterizedTest(name = "the copied commands have changed: {0}")
    @EnumSource(ClipMode.class)
    void commandsStayAsTheyWere(ClipMode mode) throws IOException {
        var topics = new ClipTopics();
        var commands = new ArrayList<String>();
        try (var model =
                new ClipLabModel(
                        topics,
                        new ModelThread(),
                        e -> {
                            throw new AssertionError(e);
                        })) {
            model.chooseMode(mode);
            commands.add("first: " + ClipCommand.of(model.state().choice().scene()));
            for (Hazard<?> hazard : topics.hazards(mode)) {
                model.show(mode, hazard.name());
                commands.add(hazard.name() + ": " + ClipCommand.of(model.state().choice().scene()));
            }
            if (mode != ClipMode.VOLUME) {
                model.shapeWindow(false);
                commands.add("oblique: " + ClipCommand.of(model.state().choice().scene()));
                model.shapeWindow(true);
                commands.add("upright: " + ClipCommand.of(model.state().choice().scene()));
            }
            model.move(ClipGrip.end(0, 0), -0.0, 0.1);
            commands.add("moved: " + ClipCommand.of(model.state().choice().scene()));
        }
        GoldenCommands.assertKept(mode.topic(), commands);
    }
}
