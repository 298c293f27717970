package rasterlab.app.coordinates.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.coordinates.CommandOutput;

/** The copied command computes the very coordinates that the lab shows. */
@Timeout(300)
class ViewCommandTest {
    private final ViewLabModel model = new ViewLabModel();

    @ParameterizedTest(name = "a matrix or its numbers are lost: {0}")
    @EnumSource(ViewKind.class)
    void commandFindsTheSameCoordinates(ViewKind kind) throws IOException {
        model.choose(kind);
        for (int stage = 0; stage <= model.last(); stage++) assertSame(stage);
    }

    @Test
    void commandHasNullWhereThereIsNoImage() throws IOException {
        model.show(ViewSituation.AT_THE_EYE);
        assertSame(ViewStage.CoordinateSpace.PICTURE.ordinal());
    }

    @Test
    void commandNamesTheMethod() throws IOException {
        model.chooseMethod("float");
        assertSame(ViewStage.CoordinateSpace.SCREEN.ordinal());
    }

    private void assertSame(int stage) throws IOException {
        JsonNode answer = CommandOutput.of(ViewCommand.of(model.scene(), stage));
        ViewScene.StagePoints image = model.scene().image(stage).orElseThrow();
        for (int vertex = 0; vertex < 10; vertex++) {
            JsonNode point = answer.path("points").path(vertex);
            assertEquals(image.h().get(vertex), answer.path("h").path(vertex).asDouble());
            if (image.h().get(vertex) == 0) assertTrue(point.isNull(), point.toString());
            else
                for (int axis = 0; axis < 3; axis++)
                    assertEquals(image.coordinate(vertex, axis), point.path(axis).asDouble());
        }
    }
}
