package rasterlab.app.coordinates.turn;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.coordinates.CommandOutput;
import rasterlab.engine.transform.rotate.RotateTopic;

/** The copied command computes the very point that the lab shows. */
@Timeout(300)
class TurnCommandTest {
    @ParameterizedTest(name = "method, angle or number of turns is lost: {0}")
    @ValueSource(strings = {"direct", "float", "table", "buneman-textbook", "quaternion"})
    void commandFindsTheSamePoint(String method) throws IOException {
        var choice = new TurnChoice(method, 12.3, 1234, 1 / 3.0, -7);
        TurnScene scene = TurnScene.of(new RotateTopic(), choice, () -> false);
        JsonNode point = CommandOutput.of(TurnCommand.of(choice)).path("points").path(0);
        assertEquals(scene.drift().end().x(), point.path(0).asDouble());
        assertEquals(scene.drift().end().y(), point.path(1).asDouble());
    }
}
