package rasterlab.app.coordinates.view;

import java.io.IOException;
import java.util.ArrayList;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.GoldenCommands;

class ViewCommandBytesTest {
    @Test
    @DisplayName("the copied commands have changed")
    void commandsStayAsTheyWere() throws IOException {
        var model = new ViewLabModel();
        var commands = new ArrayList<String>();
        for (ViewKind kind : ViewKind.values()) {
            model.choose(kind);
            commands.add(kind + ": " + ViewCommand.of(model.scene(), model.last()));
        }
        for (ViewSituation situation : ViewSituation.values()) {
            model.show(situation);
            commands.add(situation + ": " + ViewCommand.of(model.scene(), model.last()));
        }
        GoldenCommands.assertKept("views", commands);
    }
}
