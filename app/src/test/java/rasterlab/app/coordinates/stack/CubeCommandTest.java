package rasterlab.app.coordinates.stack;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.coordinates.CommandOutput;

@Timeout(300)
class CubeCommandTest {
    private final StackLabModel model = new StackLabModel();

    @ParameterizedTest(name = "the command has another cube or its matrix transposed: {0}")
    @EnumSource(
            value = StackProgram.class,
            names = {"ARM", "SPOKES", "LOADED"})
    void commandFindsTheCornersOfTheNewestCube(StackProgram program) throws IOException {
        model.show(program);
        var cubes = model.scene().cubes();
        Matrix4d newest = cubes.get(cubes.size() - 1);
        JsonNode points =
                CommandOutput.of(CubeCommand.of(model.scene()).orElseThrow()).path("points");
        assertEquals(8, points.size());
        Vector3d far = newest.transformPosition(new Vector3d(1, 1, 1));
        for (int i = 0; i < 3; i++)
            assertEquals(far.get(i), points.path(6).path(i).asDouble(), 1e-12, "corner (1, 1, 1)");
    }

    @Test
    @DisplayName("there is a command though no cube is drawn")
    void noCubeHasNoCommand() {
        model.clear();
        assertEquals(Optional.empty(), CubeCommand.of(model.scene()));
    }
}
