package rasterlab.app.row;

import java.io.IOException;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.GoldenCommands;
import rasterlab.engine.texture.filter.FilterTopic;

class FilterCommandTest {
    @Test
    @DisplayName("the copied commands have changed")
    void commandsStayAsTheyWere() throws IOException {
        GoldenCommands.assertKept(
                "texture-filter",
                new FilterTopic()
                        .hazards().stream()
                                .map(
                                        each ->
                                                each.name()
                                                        + ": "
                                                        + new FilterKind().json(each.name()))
                                .toList());
    }
}
