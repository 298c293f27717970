package rasterlab.app.polygon;

import java.io.IOException;
import java.util.ArrayList;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.canvas.GoldenCommands;
import rasterlab.app.polygon.figure.Grip;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.polygon.figure.PolygonPoint;
import rasterlab.app.polygon.figure.PolygonScene;
import rasterlab.app.polygon.outcome.PolygonTopics;
import rasterlab.engine.study.Hazard;

class PolygonCommandBytesTest {
    private static final PolygonPoint SIGNED_ZERO = new PolygonPoint(-0.0, 2.5);

    @ParameterizedTest(name = "the copied commands have changed: {0}")
    @EnumSource(PolygonMode.class)
    void commandsStayAsTheyWere(PolygonMode mode) throws IOException {
        var topics = new PolygonTopics();
        PolygonScene first = PolygonScene.first(mode);
        var commands = new ArrayList<String>();
        commands.add("first: " + PolygonCommand.of(first));
        for (Hazard<?> hazard : topics.hazards(mode)) {
            PolygonScene scene = first.with(topics.showing(first, hazard.name()));
            commands.add(hazard.name() + ": " + PolygonCommand.of(scene));
        }
        for (Grip grip : first.figure().grips().keySet())
            commands.add(
                    grip
                            + ": "
                            + PolygonCommand.of(
                                    first.with(first.figure().moved(grip, SIGNED_ZERO))));
        GoldenCommands.assertKept(mode.topic(), commands);
    }
}
