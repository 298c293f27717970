package rasterlab.app.coordinates.list;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.coordinates.CommandOutput;

/** The copied command computes the very images that the lab shows. */
@Timeout(300)
class ListCommandTest {
    private final ListLabModel model =
            new ListLabModel(
                    Runnable::run,
                    failure -> {
                        throw new AssertionError(failure);
                    });

    @AfterEach
    void close() {
        model.close();
    }

    @ParameterizedTest(name = "the order or a matrix is lost: {0}")
    @EnumSource(Example.class)
    void commandFindsTheSameImages(Example example) throws IOException {
        model.show(example);
        for (Reading reading : Reading.values()) {
            model.read(reading);
            for (int step = 0; step <= model.last(); step++) assertSame(step);
        }
    }

    @Test
    void commandHasThePrintedCells() throws IOException {
        model.show(
                model.hazards().stream()
                        .filter(hazard -> hazard.name().equals("axis"))
                        .findFirst()
                        .orElseThrow());
        assertSame(1);
    }

    private void assertSame(int step) throws IOException {
        JsonNode answer = CommandOutput.of(ListCommand.of(model.scene(), step));
        double[] images = model.scene().images(step, false);
        int dimension = model.choice().dimension();
        for (int i = 0; i < images.length; i++)
            assertEquals(
                    images[i],
                    answer.path("points").path(i / dimension).path(i % dimension).asDouble());
    }
}
