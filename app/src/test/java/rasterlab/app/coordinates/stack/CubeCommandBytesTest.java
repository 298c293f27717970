package rasterlab.app.coordinates.stack;

import java.io.IOException;
import java.util.ArrayList;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.GoldenCommands;

class CubeCommandBytesTest {
    @Test
    @DisplayName("the copied commands have changed")
    void commandsStayAsTheyWere() throws IOException {
        var model = new StackLabModel();
        var commands = new ArrayList<String>();
        for (StackProgram program : StackProgram.values()) {
            model.show(program);
            commands.add(program + ": " + CubeCommand.of(model.scene()));
        }
        GoldenCommands.assertKept("cubes", commands);
    }
}
