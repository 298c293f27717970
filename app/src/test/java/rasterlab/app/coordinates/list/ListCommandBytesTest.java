package rasterlab.app.coordinates.list;

import java.io.IOException;
import java.util.ArrayList;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.GoldenCommands;

class ListCommandBytesTest {
    @Test
    @DisplayName("the copied commands have changed")
    void commandsStayAsTheyWere() throws IOException {
        var commands = new ArrayList<String>();
        try (var model =
                new ListLabModel(
                        Runnable::run,
                        failure -> {
                            throw new AssertionError(failure);
                        })) {
            for (Example example : Example.values()) {
                model.show(example);
                for (Reading reading : Reading.values()) {
                    model.read(reading);
                    commands.add(
                            example
                                    + " "
                                    + reading
                                    + ": "
                                    + ListCommand.of(model.scene(), model.last()));
                }
            }
            for (var hazard : model.hazards()) {
                model.show(hazard);
                commands.add(hazard.name() + ": " + ListCommand.of(model.scene(), 1));
            }
        }
        GoldenCommands.assertKept("lists", commands);
    }
}
